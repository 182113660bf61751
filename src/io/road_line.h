// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where is the reference line of a road of OpenDRIVE, and how wide is what lies beside it?

#include <optional>
#include <vector>

#include "io/xml.h"
#include "vandplan/path.h"

namespace vandplan::io {

/// a + b x + c x^2 + d x^3.
struct Cubic {
  double a = 0.0, b = 0.0, c = 0.0, d = 0.0;

  [[nodiscard]] double at(double x) const { return a + x * (b + x * (c + x * d)); }
  [[nodiscard]] double slope_at(double x) const { return b + x * (2 * c + x * 3 * d); }
};

/// A function of the distance along a road, made of cubics.
class CubicLine {
 public:
  /// Cubics of all children with that name. Each holds from the distance `start` plus the value of
  /// its attribute `from`. Throws InputError unless their distances increase.
  CubicLine(const XmlFile& file, const XmlNode& parent, const char* name, const char* from,
            double start);

  [[nodiscard]] bool is_empty() const { return pieces_.empty(); }
  /// Value at a distance along the road; 0 before the first cubic.
  [[nodiscard]] double at(double s) const;
  /// Adds the distances at which cubics begin.
  void add_begins(std::vector<double>& distances) const;

 private:
  struct Piece {
    double s;
    Cubic cubic;
  };
  std::vector<Piece> pieces_;
};

/// Speed limits along a road or lane.
class SpeedLimits {
 public:
  /// Reads the limits of a road, of its children `type`.
  SpeedLimits(const XmlFile& file, const XmlNode& road);
  /// Reads the limits of a lane in a section that begins at a distance; `of_road` holds before.
  SpeedLimits(const XmlFile& file, const XmlNode& lane, double begin, const SpeedLimits& of_road);

  /// Limit at a distance along the road [m/s]; nothing if there is none.
  [[nodiscard]] std::optional<double> at(double s) const;
  /// Adds the distances at which limits change.
  void add_begins(std::vector<double>& distances) const;

 private:
  struct Piece {
    double s;
    std::optional<double> limit;
  };
  void add(const XmlFile& file, double s, const XmlNode& speed);

  std::vector<Piece> pieces_;
};

/// Point beside the reference line [m]; `t` counts to the left.
[[nodiscard]] Point beside(const Pose& on_line, double t);

/// Reference line of a road.
class RoadLine {
 public:
  /// Reads the plan view of a road. Throws InputError if a geometry is missing or unknown.
  RoadLine(const XmlFile& file, const XmlNode& road);

  /// Length of the line [m].
  [[nodiscard]] double length() const;
  /// Point and direction of the line at a distance along it [m]. The distance is clamped to the
  /// line.
  [[nodiscard]] Pose at(double s) const;
  /// Adds the distances at which pieces begin.
  void add_begins(std::vector<double>& distances) const;

 private:
  struct Piece {
    double s = 0.0;
    double length = 0.0;
    Pose begin = {};
    bool is_cubic = false;
    double curvature = 0.0;       // Curvature at the begin of a line, arc or spiral [1/m].
    double curvature_rate = 0.0;  // Change of its curvature per metre [1/m^2].
    Cubic u = {}, v = {};         // Place ahead and to the left, by the parameter.
    double scale = 1.0;           // Parameter per metre; 0: the line is a graph of v over u.

    [[nodiscard]] Pose at(double distance) const;
  };

  static Piece piece_from(const XmlFile& file, const XmlNode& geometry);

  std::vector<Piece> pieces_;
};

}  // namespace vandplan::io
