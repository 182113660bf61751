// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which area does the footprint sweep while one segment is driven, and which sides does it touch?
//
// Closed form, without steps. Theory and proof: docs/algorithms/collision.md.

#include <array>
#include <limits>

#include "collision/rectangle.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

/// Pose whose heading is a unit vector.
struct Placement {
  Point position;
  Point heading;
};

/// Converts a pose: its heading becomes a unit vector.
[[nodiscard]] Placement placement_of(const Pose& pose) noexcept;

/// Placement of a vehicle after a segment.
[[nodiscard]] Placement after(const Placement& from, const Segment& segment) noexcept;

/// Four sides of one polygon, each from a corner to the next. If fewer are left, the last corner is
/// repeated.
struct Sides {
  std::array<double, 5> x;
  std::array<double, 5> y;
};

/// Rigid body: the box around it, and its corners counter-clockwise.
struct Shape {
  Footprint box;
  Polygon corners = {};  ///< Corners; empty: the box itself.
};

/// Squared distance of a body from four sides of a polygon [m^2]; 0 if they touch. Infinity if it
/// is not less than `below`.
[[nodiscard]] double squared_distance(
    const Shape& body, const Placement& placement, const Sides& sides,
    double below = std::numeric_limits<double>::infinity()) noexcept;

/// Inflation of the footprint for tests at start and end, and on the arcs between [m]. The sizes
/// differ so that rounding opens no gap where they meet.
inline constexpr double end_margin = 0.5e-3;
inline constexpr double arc_margin = 0.3e-3;

/// Way of the rear axle, an arc or a line, in the frame of its start as if driven forward and
/// turning left. Other segments are mirrored into this frame.
struct PlacedSegment {
  PlacedSegment(const Placement& from, const Segment& segment) noexcept;

  Placement from;
  Placement to;
  Point forward;     // Unit vector of the first movement.
  Point left;        // Unit vector towards the turning centre.
  double length;     // >= 0 [m]
  double curvature;  // >= 0 [1/m]
  double turn;       // length * curvature [rad]
  double sin;        // Sine of `turn`.
  double cos;
  Point end;  // End of the way in this frame [m].

  /// Smallest box around all positions of the rear axle.
  [[nodiscard]] Bounds axle_box() const noexcept;

  /// Placement of the vehicle after a length from 0 to `length` [m].
  [[nodiscard]] Placement at(double driven) const noexcept;

  /// Part of the segment between two lengths, begin <= last [m].
  [[nodiscard]] PlacedSegment part(double begin, double last) const noexcept;

 private:
  [[nodiscard]] Placement placed(double sin_of_turn, double cos_of_turn,
                                 const Point& place) const noexcept;
};

/// Area swept by an inflated footprint, and all points within a margin of it [m].
class Sweep {
 public:
  Sweep(const Footprint& footprint, const PlacedSegment& placed, double margin = 0.0) noexcept;

  /// Box around the swept area and its margin.
  [[nodiscard]] Bounds box() const noexcept;

  /// Whether a side may come within the margin of the area. True wherever it does of the footprint
  /// itself; false where it stays the margin plus a millimetre away.
  [[nodiscard]] bool touches(const Sides& sides) const noexcept;

 private:
  // Arc of the outline of the swept area, drawn by a point of the footprint that begins at `start`.
  struct Arc {
    Point start;
    double level;
  };

  void build_arcs() noexcept;
  /// Whether a side comes within the margin of the footprint at the start.
  [[nodiscard]] bool is_near_first(const Point& a, const Point& b) const noexcept;
  [[nodiscard]] double level(const Point& p) const noexcept;
  [[nodiscard]] Point from_end(const Point& p) const noexcept;
  [[nodiscard]] bool is_reached(const Point& from, const Point& to) const noexcept;
  [[nodiscard]] bool crosses_arc(const Point& a, const Point& b) const noexcept;
  [[nodiscard]] bool passes_arc(const Point& a, const Point& b) const noexcept;
  [[nodiscard]] bool covers(const Point& p) const noexcept;
  [[nodiscard]] bool touches_turning(const std::array<double, 5>& x,
                                     const std::array<double, 5>& y) const noexcept;
  [[nodiscard]] bool touches_side(const Point& a, const Point& b) const noexcept;
  [[nodiscard]] bool touches_far_side(const Point& a, const Point& b) const noexcept;

  const PlacedSegment& segment_;
  double margin_;
  bool turns_;        // Whether the vehicle turns; if not, the area is the rectangle `first_`.
  Rectangle first_;   // Footprint at the start with `end_margin`.
  Rectangle moving_;  // Footprint with `arc_margin`.
  std::array<Arc, 4> arcs_;
  int arc_count_ = 0;
  // Range of levels of the footprint and its margin at any time, as `level` gives them.
  double least_level_;
  double most_level_;
  double least_x_;  // Least x of the area with its margin, seen from the start.
  double most_x_;   // Greatest x of the area with its margin, seen from the end.
};

}  // namespace vandplan::collision
