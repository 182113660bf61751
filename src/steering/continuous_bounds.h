// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is a word, by the Reeds-Shepp word or by the circles of its turns at full lock?
//
// Bounds and estimates are measured, not proven: docs/algorithms/continuous_steering.md, section 4.
// A `ramp` is the length of a clothoid from straight wheels to full lock [turning radii].

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "steering/continuous_kinds.h"
#include "steering/continuous_shortlists.h"

namespace vandplan::steering::bounds {

using namespace families;

/// Sum of the parts of a word. A first or last arc that lacks less than 1 rad of a whole turn
/// counts as the negative rest.
inline double signed_length(const Steps& steps, const Arcs& arcs) {
  const auto turned = [](double arc) { return arc > full_turn - 1 ? arc - full_turn : arc; };
  const double parts[] = {turned(arcs.first), arcs.inner, arcs.line, turned(arcs.last)};
  double sum = 0;
  for (std::size_t i = 0; i < steps.count; ++i) sum += parts[steps.list[i].part];
  return sum;
}

/// Length of a turn between straight wheels that may be too small for full lock (measured). `angle`
/// is the turn's angle by circles at full lock; it falls short of a ramp by u = 1 - angle / ramp.
struct Small {
  double least;  ///< least `angle` with which the turn exists [ramps]; see `wide`
  double gone;   ///< largest `angle` with which the turn may vanish [ramps]
  /// Coefficients: the turn is shorter than angle + ramp by u^2 (lack + growth u^4) [ramps].
  double lack, growth;
  double most = 2;  ///< upper limit of what the turn is shorter than angle + ramp [ramps]

  /// By how much the turn is shorter than angle + ramp [ramps].
  [[nodiscard]] double lacks(double u) const {
    const double short_by = std::max(u, 0.0);
    const double square = short_by * short_by;
    return std::min(most, square * (lack + growth * square * square));
  }
};

/// Small turns of a word: first, inner, last.
using SmallTurns = std::array<Small, 3>;

// Turns by their neighbour: a line, one turn, two equal inner turns (8.8; 8.7), a quarter turn.
constexpr Small by_line{-0.55, 0, 0.01, 0};
constexpr Small by_turn{-0.57, -0.38, 0.27, 0.08};
constexpr Small by_twins{-0.3, -0.2, 0.28, 0.18};
constexpr Small before_twins{-0.88, -0.35, 0.14, 0, 0.12};
constexpr Small by_quarter{-0.55, -0.2, 0.28, 0.26};

constexpr std::array<SmallTurns, 9> small_turns = {{
    {by_line, by_line, by_line},                                         // lsl
    {by_line, by_line, by_line},                                         // lsr
    {by_turn, by_turn, by_turn},                                         // l_r_l
    {by_turn, {-0.5, -0.5, 0.18, 0.17}, {-0.57, -0.38, 0.15, 0, 0.16}},  // r_lr
    {before_twins, {-0.2, -0.2, 0.4, 1}, before_twins},                  // lr_lr
    {by_twins, {-0.2, -0.2, 0.38, 0.3}, by_twins},                       // r_lr_l
    {by_quarter, by_line, by_line},                                      // r_lsr
    {by_quarter, by_line, by_line},                                      // r_lsl
    {by_quarter, by_line, by_quarter},                                   // r_lsr_l
}};

inline const SmallTurns& small_turns_of(Formula formula) {
  return small_turns[static_cast<std::size_t>(formula)];
}

/// By how much `Small::least` falls beside an inner turn of angle `inner` [ramps] (measured).
inline double wide(double inner) { return 0.2 * std::max(0.0, inner - 1.5); }

/// Estimated length of a word of turns between straight wheels, from its angles by circles
/// (measured). Several small turns lack more than the sum of what each lacks.
inline double length_near(Formula formula, const Arcs& arcs, double ramp) {
  const Steps& steps = steps_of(formula);
  double length = arcs.first + arcs.last + 2 * ramp;
  for (std::size_t i = 1; i + 1 < steps.count; ++i) {
    length += steps.list[i].part == 2 ? arcs.line : arcs.inner + ramp;
  }
  const SmallTurns& turns = small_turns_of(formula);
  const double per_ramp = 1 / ramp;
  const double first = turns[0].lacks(1 - arcs.first * per_ramp);
  const double inner = turns[1].lacks(1 - arcs.inner * per_ramp);
  const double last = turns[2].lacks(1 - arcs.last * per_ramp);
  const double together = 5 * inner * (first + last) + first * last;
  return length - ramp * (first + inner + last + together);
}

/// Whether a turn with `angle` by its circles may have clothoids of `length` (measured). Not valid
/// beside a line of negative length. `least` is that of `Small`.
inline bool may_wind(double least, double angle, double length, double ramp) {
  constexpr double noise = 1e-9;
  const double share = length / ramp;
  return angle + noise >= ramp * (least + (1 - least) * share * share);
}

/// By how much the way of a turn between straight wheels is longer than its `angle` >= 0.
inline double clothoids_add(double angle, double ramp) {
  const double more[] = {angle + ramp - angle, 2 * root(angle * ramp) - angle};
  return more[angle < ramp ? 1 : 0];  // a table: branches would be mispredicted
}

/// Factors of `least_added` for the formula of a Reeds-Shepp word (measured).
struct Shares {
  double moved;  ///< factor of `ramps` clothoids and of the shift of the circles at both ends
  double ramps;  ///< number of whole clothoids beside that shift
  double turns;  ///< factor of what clothoids add to the turns
  double inner;  ///< number of inner turns
};

constexpr std::array<Shares, 9> shares = {{
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
inline double least_added(const reeds_shepp_formulas::Solution& sharp, double ramp) {
  if (ramp > shortlists::longest_ramp) return 0;
  const auto most_cosine = [](double angle) {
    const double square = angle * angle;
    return 1 - square / 2 + square * square / 24;
  };
  const auto& [length, first, inner, line, last] = sharp.arcs;
  const double moved = ramp * (2 - most_cosine(first) - most_cosine(last)) / 2;
  const auto formula = static_cast<std::size_t>(sharp.formula);
  const Shares& share = shares[formula];
  double longer = 0;
  if (share.turns != 0) {
    longer = clothoids_add(first, ramp) + share.inner * clothoids_add(inner, ramp) +
             clothoids_add(last, ramp);
  }
  const bool is_full = formula < 2 && std::min(first, last) >= ramp;
  return (is_full ? 0.85 : share.moved) * (share.ramps * ramp + moved) + share.turns * longer;
}

/// Whether a part of the Reeds-Shepp word vanishes, or an arc is a quarter turn, its maximum. There
/// rounding decides which word it is, and several parts may vanish at once.
inline bool is_on_border(const Solution& sharp) {
  constexpr double noise = 1e-6;
  constexpr double quarter = std::numbers::pi / 2;
  const auto& [length, first, inner, line, last] = sharp.arcs;
  const Steps& steps = all_steps[static_cast<std::size_t>(sharp.formula)];
  const bool has_line = steps.list[1].turn == 0 || steps.list[2].turn == 0;
  const auto is_at_most = [](double arc) { return std::abs(arc - quarter) < noise; };
  return std::min({first, last, has_line ? line : inner}) < noise || is_at_most(first) ||
         is_at_most(last) || (!has_line && is_at_most(inner));
}

}  // namespace vandplan::steering::bounds
