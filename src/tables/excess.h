// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does the Reeds-Shepp length change across a box of relative poses?
//
// Turning radius 1. Proofs: docs/algorithms/bound_table.md.

#include <array>
#include <bitset>

#include "tables/interval.h"
#include "tables/words_in_box.h"

namespace vandplan::tables {

/// Subset of the 48 words.
using WordSet = std::bitset<48>;

/// Bounds on the excess, length - distance, over a box of pairs of poses [turning radii].
struct Excess {
  double at_centre = 0.0;            ///< Exact excess at the centre of the box.
  std::array<Interval, 3> slopes{};  ///< Ranges of the slopes along radial, side and turn.
  WordSet words{};                   ///< Words that can be shortest somewhere in the box.
  bool bounded = true;  ///< Whether `slopes` is valid; near equal poses no slopes are known.
};

/// Excess (length - distance) over a box. Requires that only words of `among` are shortest anywhere
/// in it.
[[nodiscard]] Excess excess_over(const PairBox& box, const WordSet& among);

/// Excess (length - distance) of one pair [turning radii], from its coordinates in [0, 1].
[[nodiscard]] double excess_at(double radial, double side, double turn);

}  // namespace vandplan::tables
