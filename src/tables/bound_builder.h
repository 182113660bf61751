// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the table of bounds hold?
//
// The table is built together with the library. The finished library only looks up entries.

#include "simd/bound_grid.h"

namespace vandplan::tables {

// Margins by which planes are moved outwards. Error analysis: docs/proofs/bound_table.md.

/// Largest error of a look-up in float [turning radii]. An error proportional to the distance,
/// `simd::noise`, comes on top.
inline constexpr double look_up_rounding = 1.1e-5;
/// Largest rounding error of a residual computed with intervals in double [turning radii].
inline constexpr double interval_rounding = 1e-7;
/// Margin by which planes are moved outwards [turning radii]; more than both errors together.
inline constexpr double rounding = 2e-5;
static_assert(look_up_rounding + interval_rounding < rounding);

/// Table entry of one cell. Its bounds hold for every pair of poses in the closed cell, with
/// `rounding` to spare.
[[nodiscard]] simd::BoundEntry bound_entry(int radial, int side, int turn);

}  // namespace vandplan::tables
