// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the table of bounds hold?
//
// Runs while the library is built; the library itself only looks up.

#include "simd/bound_grid.h"

namespace vandplan::tables {

/// The entry of one cell. Its bounds hold for every pair of poses in the closed cell, and a little
/// beyond: see `rounding` in the source.
[[nodiscard]] simd::BoundEntry bound_entry(int radial, int side, int turn);

}  // namespace vandplan::tables
