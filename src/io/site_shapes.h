// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which polygons represent the lines, points and rings of a site?

#include <span>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::io {

/// Rectangles of width `width` [m], one along each side of a line. Together they cover all points
/// within half the width, except beyond the line's two ends. At bends, and at the ends of a closed
/// line, they are half the width longer. Empty if the line has no length.
[[nodiscard]] std::vector<Polygon> walls_along(std::span<const Point> line, double width);

/// Square with a centre, and sides of length `side` along the axes [m].
[[nodiscard]] Polygon square_around(const Point& center, double side);

/// Regular polygon of 32 corners in place of a circle: around it, or within it.
[[nodiscard]] Polygon circle_shape(const Point& center, double radius, bool around);

/// Whether a ring is a box along the axes, but for one percent of its size.
[[nodiscard]] bool is_box(const Polygon& ring);

}  // namespace vandplan::io
