// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a polygon simple, and do line segments meet?

#include <string>

#include "vandplan/geometry.h"

namespace vandplan::geometry {

/// The polygon with equal neighbouring corners joined; the last and the first corner are
/// neighbours. Corners that are all equal become a triangle of micrometres around the point,
/// because such obstacles occur in recorded data.
[[nodiscard]] Polygon cleaned(const Polygon& polygon);

/// What keeps a cleaned polygon of finite corners from being simple, as half a sentence; empty if
/// it is simple. A simple polygon has an area, and no two of its sides share more than the corner
/// between them. `origin` is that of the polygon's frame, in the frame of the reader.
[[nodiscard]] std::string flaw_of(const Polygon& polygon, const Point& origin);

/// Distance of a point from the border of a simple polygon [m]; negative inside.
[[nodiscard]] double distance_from_border(const Polygon& polygon, const Point& point);

/// `distance_from_border` for what stays in the bounds: outside the bounds and on their edge a
/// border does not count inside of the polygon. A point outside the bounds is moved onto their
/// edge. If the answer is -d, all places of the bounds that are up to d from the point are in the
/// polygon.
[[nodiscard]] double distance_in_bounds(const Polygon& polygon, const Bounds& bounds,
                                        const Point& point);

/// Whether two closed line segments have a point in common, decided exactly.
[[nodiscard]] bool meet(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace vandplan::geometry
