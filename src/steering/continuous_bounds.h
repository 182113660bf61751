// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the word of Reeds and Shepp, or that of full circles, tell of a word's length?
//
// Practical bounds, measured and not proven: docs/algorithms/continuous_steering.md, section 4.

#include <algorithm>
#include <cmath>
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

/// No word of turns between straight wheels is shorter that has these circles (measured). Turns to
/// full lock are as long as that and their clothoids; smaller ones less, but not by more than a
/// turn by that angle alone, and hardly at all where a line beside them takes up the rest.
inline double length_near(Formula formula, const Arcs& arcs, double ramp) {
  const Steps& steps = steps_of(formula);
  const double angles[] = {arcs.first, arcs.inner, 0, arcs.last};
  double at_full_lock = 0, gap = 0;
  for (std::size_t i = 0; i < steps.count; ++i) {
    const std::size_t part = steps.list[i].part;
    if (part == 2) {
      at_full_lock += arcs.line;
      continue;
    }
    const double length = angles[part] + ramp;
    at_full_lock += length;
    if (angles[part] < ramp) gap += length - 2 * root(angles[part] * ramp);
  }
  const bool takes_up = formula == Formula::lsl || formula == Formula::lsr;
  const double share = takes_up ? 0.02 : 1;
  return at_full_lock - (std::min(arcs.first, arcs.last) < 0 ? 2 : share) * gap;
}

/// By how much clothoids of that length make the least word longer at least, where the curvature
/// never jumps (measured); from how they move the circles at both ends of the word of Reeds and
/// Shepp and, where it has no line, how much longer its turns would be.
inline double least_added(const reeds_shepp_formulas::Solution& sharp, double ramp) {
  if (ramp > shortlists::longest_ramp) return 0;
  const auto most_cosine = [](double angle) {
    const double square = angle * angle;
    return 1 - square / 2 + square * square / 24;
  };
  const auto longer = [&](double angle) {
    return angle >= ramp ? ramp : 2 * root(angle * ramp) - angle;
  };
  const auto& [length, first, inner, line, last] = sharp.arcs;
  const double moved = ramp * (2 - most_cosine(first) - most_cosine(last)) / 2;
  switch (sharp.formula) {
    case Formula::lsl:
    case Formula::lsr:
      return (std::min(first, last) >= ramp ? 0.85 : 0.25) * moved;
    case Formula::r_lsr:
    case Formula::r_lsl:
    case Formula::r_lsr_l:
      return 0.45 * (ramp + moved);
    case Formula::l_r_l:
      return 0.75 * (longer(first) + longer(inner) + longer(last));
    case Formula::r_lr:
      return 0.3 * (longer(first) + longer(inner) + longer(last));
    default:
      return 0.25 * (longer(first) + 2 * longer(inner) + longer(last));
  }
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
