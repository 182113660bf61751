// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the footprint sweep while one segment is driven, and which sides does it touch?
//
// In closed form, without steps. Theory and proof: docs/algorithms/collision.md.

#include <array>
#include <limits>

#include "collision/rectangle.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

/// A pose whose heading is a unit vector.
struct Placement {
  Point position;
  Point heading;
};

/// A pose with its heading as a unit vector.
[[nodiscard]] Placement placement_of(const Pose& pose) noexcept;

/// Where a vehicle is after a segment.
[[nodiscard]] Placement after(const Placement& from, const Segment& segment) noexcept;

/// Four sides of one polygon, each from a corner to the next; where it has less, the last corner
/// repeats.
struct Sides {
  std::array<double, 5> x;
  std::array<double, 5> y;
};

/// A rigid body: the box around it, and its corners counter-clockwise.
struct Shape {
  Footprint box;
  Polygon corners = {};  ///< none: the box itself
};

/// Square of the distance of a body from four sides of a polygon, 0 if they touch; infinity if it
/// is not less than `below` [m^2].
[[nodiscard]] double squared_distance(
    const Shape& body, const Placement& placement, const Sides& sides,
    double below = std::numeric_limits<double>::infinity()) noexcept;

/// How far the footprint is inflated before it is tested [m]: at its start and end, and on the
/// arcs between. Two sizes, so that rounding opens no gap where they meet.
inline constexpr double end_margin = 0.5e-3;
inline constexpr double arc_margin = 0.3e-3;

/// Where the rear axle goes: an arc or a line, seen from its start, as if driven forward and
/// turning left. Other segments are mirrored into this frame.
struct PlacedSegment {
  PlacedSegment(const Placement& from, const Segment& segment) noexcept;

  Placement from;
  Placement to;
  Point forward;     // unit vector of the first movement
  Point left;        // unit vector towards the turning centre
  double length;     // >= 0 [m]
  double curvature;  // >= 0 [1/m]
  double turn;       // length * curvature [rad]
  double sin;        // of the turn
  double cos;
  Point end;  // in this frame [m]

  /// The smallest box around all positions of the rear axle.
  [[nodiscard]] Bounds axle_box() const noexcept;

  /// Where the vehicle is after that length, from 0 to all of it [m].
  [[nodiscard]] Placement at(double driven) const noexcept;

  /// What is driven between two lengths, the first one not above the other [m].
  [[nodiscard]] PlacedSegment part(double begin, double last) const noexcept;

 private:
  [[nodiscard]] Placement placed(double sin_of_turn, double cos_of_turn,
                                 const Point& place) const noexcept;
};

/// The area swept by an inflated footprint, and all that is within a margin of it [m].
class Sweep {
 public:
  Sweep(const Footprint& footprint, const PlacedSegment& placed, double margin = 0.0) noexcept;

  /// A box around the swept area and its margin.
  [[nodiscard]] Bounds box() const noexcept;

  /// Whether a side may come within the margin of the area: true wherever it does of the footprint
  /// itself, false where that stays the margin and a millimetre away.
  [[nodiscard]] bool touches(const Sides& sides) const noexcept;

 private:
  // Where a point of the footprint begins to draw a piece of the outline of the swept area.
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
  bool turns_;        // else the area is the rectangle `first_`
  Rectangle first_;   // at the start; with `end_margin`
  Rectangle moving_;  // with `arc_margin`
  std::array<Arc, 4> arcs_;
  int arc_count_ = 0;
  double least_level_;  // of the footprint and its margin at any time
  double most_level_;
  double least_x_;  // of the area with its margin, seen from the start
  double most_x_;   // of the same, seen from the end
};

}  // namespace vandplan::collision
