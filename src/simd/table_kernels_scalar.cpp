// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simd/table_kernels.h"

namespace vandplan::simd {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

// The mirrored heading pi - heading, in [-pi, pi].
float mirrored_in_y(float heading) noexcept {
  const float mirrored = pi - heading;
  return mirrored > pi ? mirrored - 2 * pi : mirrored;
}

// Index of the grid point nearest to a heading; far headings get the first or the last index. NaN
// gets the first, because std::max gives its first argument then.
int nearest_heading(const TableView& table, float heading) noexcept {
  const float cell = (heading + pi) * table.cells_per_radian + 0.5F;
  return static_cast<int>(std::min(static_cast<float>(table.headings - 1), std::max(0.0F, cell)));
}

}  // namespace

// Algorithm 7 of Guo 2020.
//
//   [1] dx, dy and the headings are the arguments
//   [2] outside the window: Euclid
//   [3] fold y < 0 onto y > 0 (Algorithm 5)
//   [4] then x < 0 onto x > 0
//   [5] floor x and y, round both headings
//   [6] read one entry
float table_distance(const TableView& table, float dx, float dy, float heading_node,
                     float heading_sample) noexcept {
  const float x = std::abs(dx) * table.to_table;
  const float y = std::abs(dy) * table.to_table;
  if (!(x < table.extent && y < table.extent)) return std::sqrt(dx * dx + dy * dy);  // [2]
  if (dy < 0.0F) {                                                                   // [3]
    heading_node = -heading_node;
    heading_sample = -heading_sample;
  }
  if (dx < 0.0F) {  // [4]
    heading_node = mirrored_in_y(heading_node);
    heading_sample = mirrored_in_y(heading_sample);
  }
  const int ix = static_cast<int>(x * table.cells_per_metre);  // [5]
  const int iy = static_cast<int>(y * table.cells_per_metre);
  const TableGridPoint cell{ix, iy, nearest_heading(table, heading_node),
                            nearest_heading(table, heading_sample)};
  const int index = table_index({table.positions, table.headings}, cell);
  return table.entries[index] * table.from_table;  // [6]
}

void scalar::table_distances(const TableView& table, std::span<const float> x,
                             std::span<const float> y, std::span<const float> heading,
                             const TableSample& sample, std::span<float> out) noexcept {
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = table_distance(table, x[i] - sample.x, y[i] - sample.y, heading[i], sample.heading);
  }
}

}  // namespace vandplan::simd
