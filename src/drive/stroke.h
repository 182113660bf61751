// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where should a vehicle be, and how fast, on its way from one stop to the next?

#include <vector>

#include "vandplan/path.h"
#include "vandplan/speed.h"

namespace vandplan::driving {

/// A place of a stroke.
struct Place {
  double s = 0.0;  ///< driven since the stroke began [m]
  Pose pose = {};
  double curvature = 0.0;  ///< [1/m]
};

/// A pose seen from a stroke.
struct Offset {
  Place place;           ///< beside which the pose is
  double lateral = 0.0;  ///< the pose is so far left of it, seen forward [m]
  double heading = 0.0;  ///< the pose is turned to the left by so much, in [-pi, pi) [rad]
};

/// A part of a path that is driven from standing to standing in one gear.
class Stroke {
 public:
  /// `s` is where it begins on its path [m].
  Stroke(const Pose& start, double s);

  /// Adds what is driven next.
  void add(const Segment& segment);
  /// Adds how it is driven from a knot on, for `duration` [s].
  void add(const SpeedKnot& knot, double duration) { knots_.push_back({knot, duration}); }

  [[nodiscard]] int direction() const noexcept { return direction_; }
  [[nodiscard]] double length() const noexcept { return samples_.back().s; }
  [[nodiscard]] double begin() const noexcept { return begin_; }
  [[nodiscard]] const Pose& end() const noexcept { return end_; }
  /// The curvature with which it begins [1/m].
  [[nodiscard]] double first_curvature() const noexcept { return samples_.front().curvature; }

  /// The place after `s` metres, within 0.01 mm; before and after it goes on as it begins and ends.
  [[nodiscard]] Place at(double s) const noexcept;
  [[nodiscard]] double curvature_at(double s) const noexcept;

  /// How a pose lies beside the stroke: the place is the one next to it that is found from near
  /// `guess` [m].
  [[nodiscard]] Offset offset_of(const Pose& pose, double guess) const noexcept;

  /// The planned speed after `s` metres [m/s]; 0 from the end on.
  [[nodiscard]] double speed_at(double s) const noexcept;

 private:
  struct Sample {
    double s;
    Pose pose;
    double curvature;
    double rate;  // change of the curvature from here on, per metre
  };
  struct Knot {
    SpeedKnot knot;
    double duration;  // until the next one [s]
  };
  [[nodiscard]] const Sample& before(double s) const noexcept;

  double begin_;
  Pose end_;
  int direction_ = 1;
  std::vector<Sample> samples_;  // of the stroke, the last one at its end
  std::vector<Knot> knots_;
};

/// The strokes of a path, in its frame. There is one at least, maybe without length.
[[nodiscard]] std::vector<Stroke> strokes_of(const Path& path, const SpeedProfile& profile);

}  // namespace vandplan::driving
