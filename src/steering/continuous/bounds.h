// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Below which length is no word, by the Reeds-Shepp word?
//
// Bounds are measured, not proven: docs/algorithms/continuous_steering.md, section 4. A `ramp` is
// the length of a clothoid from straight wheels to full lock [turning radii].

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "steering/continuous/circle_word.h"
#include "steering/continuous/shortlist_rows.h"
#include "steering/word.h"

namespace vandplan::steering::continuous {

using reeds_shepp_formulas::Solution;

/// Length of a word with these arcs; negative ones count as 0.
inline double driven_length(const Steps& steps, const Arcs& arcs) {
  const double parts[] = {arcs.first, arcs.inner, arcs.line, arcs.last};
  double sum = 0;
  for (std::size_t i = 0; i < steps.count; ++i) sum += std::max(0.0, parts[steps.list[i].part]);
  return sum;
}

/// Sum of the parts of a word. A first or last arc that lacks less than 1 rad of a whole turn
/// counts as the negative rest.
inline double signed_length(const Steps& steps, const Arcs& arcs) {
  const auto turned = [](double arc) { return arc > full_turn - 1 ? arc - full_turn : arc; };
  const double parts[] = {turned(arcs.first), arcs.inner, arcs.line, turned(arcs.last)};
  double sum = 0;
  for (std::size_t i = 0; i < steps.count; ++i) sum += parts[steps.list[i].part];
  return sum;
}

/// By how much the way of a turn between straight wheels is longer than its `angle` >= 0.
inline double added_by_clothoids(double angle, double ramp) {
  const double more[] = {angle + ramp - angle, 2 * root(angle * ramp) - angle};
  return more[angle < ramp ? 1 : 0];  // a table: branches would be mispredicted
}

/// Factors of `added_length_bound` for the formula of a Reeds-Shepp word (measured).
struct AddedFactors {
  double moved;  ///< factor of `ramps` clothoids and of the shift of the circles at both ends
  double ramps;  ///< number of whole clothoids beside that shift
  double turns;  ///< factor of what clothoids add to the turns
  double inner;  ///< number of inner turns
};

constexpr std::array<AddedFactors, 9> added_factors = {{
    {0.25, 0, 0, 0},  // lsl
    {0.25, 0, 0, 0},  // lsr
    {0, 0, 0.75, 1},  // l_r_l
    {0, 0, 0.3, 1},   // r_lr
    {0, 0, 0.25, 2},  // lr_lr
    {0, 0, 0.25, 2},  // r_lr_l
    {0.45, 1, 0, 0},  // r_lsr
    {0.45, 1, 0, 0},  // r_lsl
    {0.45, 1, 0, 0},  // r_lsr_l
}};

/// Lower bound of what clothoids of length `ramp` add to the shortest word where the curvature
/// never jumps (measured). It comes from how clothoids shift the circles at both ends of the
/// Reeds-Shepp word and, if that has no line, from what they would add to its turns.
inline double added_length_bound(const Solution& reeds_shepp, double ramp) {
  if (ramp > shortlists::longest_ramp) return 0;
  const auto max_cosine = [](double angle) {
    const double square = angle * angle;
    return 1 - square / 2 + square * square / 24;
  };
  const auto& [length, first, inner, line, last] = reeds_shepp.arcs;
  const double moved = ramp * (2 - max_cosine(first) - max_cosine(last)) / 2;
  const auto formula = static_cast<std::size_t>(reeds_shepp.formula);
  const AddedFactors& factors = added_factors[formula];
  double longer = 0;
  if (factors.turns != 0) {
    longer = added_by_clothoids(first, ramp) + factors.inner * added_by_clothoids(inner, ramp) +
             added_by_clothoids(last, ramp);
  }
  const bool is_full = formula < 2 && std::min(first, last) >= ramp;
  return (is_full ? 0.85 : factors.moved) * (factors.ramps * ramp + moved) + factors.turns * longer;
}

/// Whether a part of the Reeds-Shepp word vanishes, or an arc is a quarter turn, its maximum. There
/// rounding decides which word it is, and several parts may vanish at once.
inline bool is_on_border(const Solution& reeds_shepp) {
  constexpr double noise = 1e-6;
  constexpr double quarter = std::numbers::pi / 2;
  const auto& [length, first, inner, line, last] = reeds_shepp.arcs;
  const Steps& steps = all_steps[static_cast<std::size_t>(reeds_shepp.formula)];
  const bool has_line = steps.list[1].turn == 0 || steps.list[2].turn == 0;
  const auto is_at_most = [](double arc) { return std::abs(arc - quarter) < noise; };
  return std::min({first, last, has_line ? line : inner}) < noise || is_at_most(first) ||
         is_at_most(last) || (!has_line && is_at_most(inner));
}

}  // namespace vandplan::steering::continuous
