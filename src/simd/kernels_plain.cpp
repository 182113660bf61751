// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The kernels of a build without vectors: the scalar functions.

#include "simd/bound_kernels.h"
#include "simd/length_kernels.h"
#include "simd/table_kernels.h"
#include "simd/target.h"

namespace vandplan::simd {

std::string_view simd_target() noexcept { return "scalar"; }

void table_distances(const TableView& table, std::span<const float> x, std::span<const float> y,
                     std::span<const float> heading, const TableSample& sample,
                     std::span<float> out) noexcept {
  scalar::table_distances(table, x, y, heading, sample, out);
}

void length_bounds(const BoundEntry* entries, std::span<const float> x, std::span<const float> y,
                   std::span<const float> heading, const BoundSample& sample, float radius,
                   std::span<float> low, std::span<float> high) noexcept {
  scalar::length_bounds(entries, x, y, heading, sample, radius, low, high);
}

void reeds_shepp_lengths(std::span<const float> x, std::span<const float> y,
                         std::span<const float> heading, const LengthSample& sample, float radius,
                         std::span<float> out) noexcept {
  scalar::reeds_shepp_lengths(x, y, heading, sample, radius, out);
}

}  // namespace vandplan::simd
