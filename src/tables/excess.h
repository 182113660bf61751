// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does the Reeds-Shepp length change across a box of relative poses?
//
// Turning radius 1. The reasons why the answers hold: docs/algorithms/bound_table.md.

#include <array>
#include <bitset>

#include "tables/interval.h"
#include "tables/words_in_box.h"

namespace vandplan::tables {

/// Some of the 48 words.
using WordSet = std::bitset<48>;

/// length - distance over a box of pairs.
struct Excess {
  double at_centre = 0.0;            ///< exact
  std::array<Interval, 3> slopes{};  ///< of all its slopes along radial, side and turn
  WordSet words{};                   ///< those that can be shortest somewhere in the box
  bool bounded = true;               ///< else nothing is known of the slopes
};

/// Length - distance over a box, given that no word but those of `among` is shortest anywhere in
/// it.
[[nodiscard]] Excess excess_over(const PairBox& box, const WordSet& among);

/// Length - distance of a single pair, by its coordinates in [0, 1] [turning radii].
[[nodiscard]] double excess_at(double radial, double side, double turn);

}  // namespace vandplan::tables
