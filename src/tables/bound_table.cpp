// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/tables.h"

#include <iterator>

#include "base/require.h"
#include "bound_entries.h"
#include "geometry/pose_columns.h"
#include "simd/bound_kernels.h"

namespace vandplan {

using simd::bound_entries;

LengthBounds length_bounds(const Pose& from, const Pose& to, double radius) {
  base::require_radius(radius);
  // The difference is taken in double, so that poses may be far from the origin.
  const auto [low, high] = simd::length_bounds(
      bound_entries, static_cast<float>(from.x - to.x), static_cast<float>(from.y - to.y),
      static_cast<float>(wrap_angle(from.heading)), static_cast<float>(wrap_angle(to.heading)),
      static_cast<float>(radius));
  return {static_cast<double>(low), static_cast<double>(high)};
}

void length_bounds(const PoseColumns& nodes, const Pose& sample, double radius,
                   std::span<float> low, std::span<float> high) {
  base::require_radius(radius);
  geometry::expect_columns(nodes, low.size());
  geometry::expect_columns(nodes, high.size());
  const simd::BoundSample to{static_cast<float>(sample.x), static_cast<float>(sample.y),
                             static_cast<float>(wrap_angle(sample.heading))};
  simd::length_bounds(bound_entries, nodes.x, nodes.y, nodes.heading, to,
                      static_cast<float>(radius), low, high);
}

BoundTableInfo bound_table_info() noexcept {
  static_assert(std::size(bound_entries) == simd::bound_cells);
  return {simd::radial_cells, simd::side_cells, simd::turn_cells, sizeof bound_entries};
}

}  // namespace vandplan
