// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is a convex polygon from a point or a side?
//
// Corners are in counter-clockwise order.

#include <span>

#include "vandplan/geometry.h"

namespace vandplan::geometry {

/// The corners of a simple polygon in counter-clockwise order.
[[nodiscard]] Polygon counter_clockwise(Polygon polygon);

/// Distance of a point from the border of a convex polygon [m]; negative inside.
[[nodiscard]] double signed_distance(std::span<const Point> convex, const Point& point) noexcept;

/// Square of the distance between a convex polygon and the side from a to b [m^2], 0 if they touch.
[[nodiscard]] double squared_distance(std::span<const Point> convex, const Point& a,
                                      const Point& b) noexcept;

/// Square of the distance of a point from the side from a to b [m^2].
[[nodiscard]] double squared_distance_to_side(const Point& point, const Point& a,
                                              const Point& b) noexcept;

}  // namespace vandplan::geometry
