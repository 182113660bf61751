// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the word of Reeds and Shepp, or that of full circles, tell of a word's length?
//
// Practical bounds, measured and not proven: docs/algorithms/continuous_steering.md, section 4.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "steering/continuous_kinds.h"
#include "steering/continuous_shortlists.h"

namespace vandplan::steering::bounds {

using namespace families;

/// What the arcs of a word add up to; nearly a whole turn is a little less than none.
inline double signed_length(const Steps& steps, const Arcs& arcs) {
  const auto turned = [](double arc) { return arc > full_turn - 1 ? arc - full_turn : arc; };
  const double parts[] = {turned(arcs.first), arcs.inner, arcs.line, turned(arcs.last)};
  double sum = 0;
  for (std::size_t i = 0; i < steps.count; ++i) sum += parts[steps.list[i].part];
  return sum;
}

/// What becomes of a turn between straight wheels whose angle by its circles falls short of a ramp
/// by u ramps (measured).
struct Small {
  double least;         ///< there is none if that angle is less, in ramps; see `wide`
  double gone;          ///< it may be none if that angle is no more
  double lack, growth;  ///< it is shorter than its angle and a ramp by u^2 (lack + growth u^4)
  double most = 2;      ///< ramps, but by no more than that

  [[nodiscard]] double lacks(double u) const {
    const double short_by = std::max(u, 0.0);
    const double square = short_by * short_by;
    return std::min(most, square * (lack + growth * square * square));
  }
};

/// The first, the inner and the last turns of a word.
using SmallTurns = std::array<Small, 3>;

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

/// By how much less the angle of a turn beside such an inner turn may be, in ramps (measured).
inline double wide(double inner) { return 0.2 * std::max(0.0, inner - 1.5); }

/// About how long a word of turns between straight wheels is that has these circles (measured). Of
/// what small turns lack, more is lacking where there are several.
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

/// Whether a turn with that angle by its circles may have clothoids of a length (measured), unless
/// a line beside it lacks something; `least` as of `Small`.
inline bool may_wind(double least, double angle, double length, double ramp) {
  constexpr double noise = 1e-9;
  const double share = length / ramp;
  return angle + noise >= ramp * (least + (1 - least) * share * share);
}

/// By how much the way of a turn between straight wheels is longer than its `angle` >= 0.
inline double clothoids_add(double angle, double ramp) {
  const double more[] = {angle + ramp - angle, 2 * root(angle * ramp) - angle};
  return more[angle < ramp ? 1 : 0];  // no branches, as neither is likely
}

/// The share of a word of Reeds and Shepp in what clothoids add to it.
struct Shares {
  double moved;  ///< of how they move the circles at both ends,
  double ramps;  ///< and of so many more clothoids
  double turns;  ///< of how much longer turns would be,
  double inner;  ///< and how often the inner one counts
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

/// By how much clothoids of that length make the least word longer at least, where the curvature
/// never jumps (measured); from how they move the circles at both ends of the word of Reeds and
/// Shepp and, where it has no line, how much longer its turns would be.
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

/// Whether the word of Reeds and Shepp lacks a part, or one is a quarter turn where that is the
/// most: there rounding decides which word it is, and several parts may vanish at once.
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
