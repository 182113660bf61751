// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which polygons stand for the lines, points and rings of a site?

#include <span>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::io {

/// Rectangles along a line, a side each, `width` wide [m]: together they cover all that is within
/// half of the width of the line, but for the ground beyond its two ends. At bends they reach half
/// of the width further, too, and so they do at the ends of a line that ends where it begins.
/// Empty if the line has no length.
[[nodiscard]] std::vector<Polygon> walls_along(std::span<const Point> line, double width);

/// The square with that centre and sides along the axes [m].
[[nodiscard]] Polygon square_around(const Point& center, double side);

}  // namespace vandplan::io
