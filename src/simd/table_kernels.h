// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is the thesis' table asked for many nodes at once?
//
// Plain C++, spans only. The scalar functions are the specification; every vector target gives the
// same bits.

#include <span>

namespace vandplan::simd {

/// A table and a turning radius, in the form the look-up wants. All in float.
struct TableView {
  const float* entries = nullptr;  ///< row-major [x][y][heading_node][heading_sample]
  int positions = 0;               ///< grid points along x and along y
  int headings = 0;                ///< grid points of a heading
  float extent = 0.0F;             ///< bound of |dx| and |dy| at the table's turning radius [m]
  float cells_per_metre = 0.0F;    ///< cells per metre at the table's turning radius
  float cells_per_radian = 0.0F;
  float to_table = 1.0F;    ///< turning radius of the table / that of the vehicle
  float from_table = 1.0F;  ///< turning radius of the vehicle / that of the table
};

/// Indices of a cell of a table.
struct TableGridPoint {
  int x, y, heading_node, heading_sample;
};
/// Numbers of grid points of a table: along x and along y, and of a heading.
struct TableShape {
  int positions, headings;
};

/// Position of a cell's entry; used by fill and look-up alike.
constexpr int table_index(const TableShape& shape, const TableGridPoint& cell) {
  return ((cell.x * shape.positions + cell.y) * shape.headings + cell.heading_node) *
             shape.headings +
         cell.heading_sample;
}

/// The pose to which the lengths lead [m, rad]; heading in [-pi, pi].
struct TableSample {
  float x, y, heading;
};

/// Length by Algorithm 7 of Guo 2020 between the sample and a node at (dx, dy) from it [m].
/// Headings are in [-pi, pi].
[[nodiscard]] float table_distance(const TableView& table, float dx, float dy, float heading_node,
                                   float heading_sample) noexcept;

/// Lengths by Algorithm 7 from every node, given as structure of arrays, to one sample [m]. out[i]
/// belongs to node i. Equal sizes.
void table_distances(const TableView& table, std::span<const float> x, std::span<const float> y,
                     std::span<const float> heading, const TableSample& sample,
                     std::span<float> out) noexcept;

namespace scalar {
void table_distances(const TableView& table, std::span<const float> x, std::span<const float> y,
                     std::span<const float> heading, const TableSample& sample,
                     std::span<float> out) noexcept;
}

}  // namespace vandplan::simd
