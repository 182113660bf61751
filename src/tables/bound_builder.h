// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the table of bounds hold?
//
// Runs while the library is built; the library itself only looks up.

#include "simd/bound_grid.h"

namespace vandplan::tables {

// What the planes are moved outwards for. docs/algorithms/bound_table.md, "Rounding", has the sums.

/// The most that a look-up in float is off by [turning radii], beside a part of the distance,
/// `simd::noise`.
inline constexpr double look_up_rounding = 1.1e-5;
/// The most that intervals in double are off by in a residual [turning radii].
inline constexpr double interval_rounding = 1e-7;
/// How far planes are moved outwards [turning radii]; more than both together.
inline constexpr double rounding = 2e-5;
static_assert(look_up_rounding + interval_rounding < rounding);

/// The entry of one cell. Its bounds hold for every pair of poses in the closed cell, with
/// `rounding` to spare.
[[nodiscard]] simd::BoundEntry bound_entry(int radial, int side, int turn);

}  // namespace vandplan::tables
