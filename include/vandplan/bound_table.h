// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Between which two numbers does a Reeds-Shepp length lie? A look-up that keeps its promise.
//
// One table, made for turning radius 1 when the library is built, serves every vehicle and every
// distance. Why the bounds hold, and how tight they are: docs/algorithms/bound_table.md.

#include <cstddef>
#include <span>

#include "vandplan/geometry.h"

namespace vandplan {

/// Lower and upper bound of a length: low <= length <= high [m].
struct LengthBounds {
  double low = 0.0;
  double high = 0.0;
};

/// Bounds of the length of the shortest path between two poses, `reeds_shepp_length(from, to,
/// radius)` [m]. Headings may be any angle. Throws InputError naming "radius" unless it is finite
/// and > 0 [m].
[[nodiscard]] LengthBounds length_bounds(const Pose& from, const Pose& to, double radius);

/// Bounds of the lengths from every node to one sample, in float [m]: low[i] and high[i] belong to
/// node i. They hold for the sample as rounded to float. Headings of nodes must be in [-pi, pi]:
/// for others the bounds are wrong. The sample's may be any angle. Throws InputError naming
/// "radius" unless it is finite and > 0 [m], or "nodes" unless all columns have as many numbers as
/// `low` and `high`.
void length_bounds(const PoseColumns& nodes, const Pose& sample, double radius,
                   std::span<float> low, std::span<float> high);

/// Shape of the table of bounds: cells along its three coordinates, and its size in bytes.
struct BoundTableInfo {
  int radial_cells, side_cells, turn_cells;
  std::size_t bytes;
};

/// Shape of the library's table of bounds.
[[nodiscard]] BoundTableInfo bound_table_info() noexcept;

}  // namespace vandplan
