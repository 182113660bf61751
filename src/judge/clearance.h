// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the vehicle from a polygon, in the eyes of the judge?

#include "judge/track.h"
#include "vandplan/geometry.h"

namespace vandplan::judge {

/// A body in the vehicle frame, x forward from the rear axle, y to the left; it holds the origin.
struct Rectangle {
  double x_min, x_max, y_min, y_max;
};

/// Between the closed body and the closed polygon [m]: 0 if they touch or one holds the other.
[[nodiscard]] double clearance(const Position& position, const Rectangle& body,
                               const Polygon& polygon);

/// The same for one point and for one side, from a to b, seen from the vehicle.
[[nodiscard]] double distance_to_rectangle(const Point& p, const Rectangle& body);
[[nodiscard]] double distance_of_side(const Point& a, const Point& b, const Rectangle& body);

}  // namespace vandplan::judge
