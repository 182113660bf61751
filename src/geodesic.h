// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it at least, around the obstacles? A proven bound, from the visibility graph.
//
// The rear axle keeps `disc` away from every side of an obstacle, where `disc` is its least
// distance to the outline of the footprint. So it stays out of a box around each side (inscribed in
// all points nearer than `disc`), and no path is shorter than the shortest one around these boxes.

#include <cstdint>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan {

/// A* over the corners of the boxes, a few tests at a time. Its bound only rises.
class Geodesic {
 public:
  Geodesic(const World& world, const Pose& from, const Pose& to);

  /// Looks whether one corner is seen from another, a few microseconds at most. False when the
  /// bound is final.
  bool step();

  /// Length of no path is below this [m].
  [[nodiscard]] double bound() const { return bound_; }

 private:
  struct Box {
    Point middle;
    Point along;  // unit vector
    double half_length;
    double half_width;
  };
  struct Corner {
    Point place;
    double length = 0.0;  // of the shortest way found from the start
    bool is_settled = false;
  };

  void settle_next();
  [[nodiscard]] bool is_seen(const Point& p, const Point& q) const;
  [[nodiscard]] double rank(const Corner& corner) const;

  std::vector<Box> boxes_;
  std::vector<Corner> corners_;  // the start, the goal, and those of the boxes
  std::size_t current_ = 0;      // settled; its neighbours are looked at one by one
  std::size_t next_ = 0;
  bool is_final_ = false;
  double bound_ = 0.0;
};

}  // namespace vandplan
