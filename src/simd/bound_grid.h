// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is the plane laid out in the table of bounds?
//
// In the mean frame every symmetry is a change of sign (docs/algorithms/steering.md), so a pair of
// poses is three numbers >= 0: distance r, bearing b in [0, pi/2], turn in [0, pi]. Three
// coordinates in [0, 1] cover them all, infinitely far ones too:
//
//   radial = r / (r + reach)    side = sin b / (sin b + cos b)    turn / pi
//
// A cell says between which two parallel planes over these coordinates length - r lies.

#include <cstdint>

namespace vandplan::simd {

inline constexpr int radial_cells = 64;
inline constexpr int side_cells = 32;
inline constexpr int turn_cells = 64;

/// The distance that radial = 1/2 stands for [turning radii].
inline constexpr double radial_reach = 4.0;

/// A cell in eight bytes. With u, v, w in [0, 1] across it along radial, side and turn, in units:
///   base + slope_step * (radial * u + side * v) + turn * w <= length - r <= the same + width
struct BoundEntry {
  std::uint32_t base_width;  ///< base: upper 16 bits, signed; width: lower 16 bits
  std::uint32_t slopes;      ///< signed; radial: upper 11 bits; side: next 11; turn: lower 10
};

inline constexpr double bound_unit = 0x1p-13;  ///< unit of an entry's numbers [turning radii]
inline constexpr int slope_step = 4;           ///< units per step of the slopes of radial and side

/// Position of a cell's entry; used by fill and look-up alike.
constexpr int bound_index(int radial, int side, int turn) {
  return (radial * side_cells + side) * turn_cells + turn;
}

inline constexpr int bound_cells = radial_cells * side_cells * turn_cells;

}  // namespace vandplan::simd
