// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// About how long is a word, by the circles of its turns at full lock, and is it a likely one?
//
// Estimates are measured: docs/algorithms/continuous_steering.md, section 4. A `ramp` is the length
// of a clothoid from straight wheels to full lock [turning radii].

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "steering/continuous/candidate.h"
#include "steering/continuous/circle_word.h"
#include "steering/word.h"

namespace vandplan::steering::continuous {

/// Length of a turn between straight wheels that may be too small for full lock (measured). `angle`
/// is the turn's angle by circles at full lock; it falls short of a ramp by u = 1 - angle / ramp.
struct SmallTurn {
  double min_angle;  ///< least `angle` with which the turn exists [ramps]; see `min_angle_drop`
  double vanishing;  ///< largest `angle` with which the turn may vanish [ramps]
  /// Coefficients: the turn is shorter than angle + ramp by u^2 (lack + growth u^4) [ramps].
  double lack, growth;
  double max_lack = 2;  ///< upper limit of what the turn is shorter than angle + ramp [ramps]

  /// By how much the turn is shorter than angle + ramp [ramps].
  [[nodiscard]] double lacks(double u) const {
    const double short_by = std::max(u, 0.0);
    const double square = short_by * short_by;
    return std::min(max_lack, square * (lack + growth * square * square));
  }
};

/// Small turns of a word: first, inner, last.
using SmallTurns = std::array<SmallTurn, 3>;

// Turns by their neighbour: a line, one turn, two equal inner turns (8.8; 8.7), a quarter turn.
constexpr SmallTurn beside_line{-0.55, 0, 0.01, 0};
constexpr SmallTurn beside_turn{-0.57, -0.38, 0.27, 0.08};
constexpr SmallTurn beside_twins{-0.3, -0.2, 0.28, 0.18};
constexpr SmallTurn before_twins{-0.88, -0.35, 0.14, 0, 0.12};
constexpr SmallTurn beside_quarter{-0.55, -0.2, 0.28, 0.26};

constexpr std::array<SmallTurns, 9> small_turns = {{
    {beside_line, beside_line, beside_line},                                 // lsl
    {beside_line, beside_line, beside_line},                                 // lsr
    {beside_turn, beside_turn, beside_turn},                                 // l_r_l
    {beside_turn, {-0.5, -0.5, 0.18, 0.17}, {-0.57, -0.38, 0.15, 0, 0.16}},  // r_lr
    {before_twins, {-0.2, -0.2, 0.4, 1}, before_twins},                      // lr_lr
    {beside_twins, {-0.2, -0.2, 0.38, 0.3}, beside_twins},                   // r_lr_l
    {beside_quarter, beside_line, beside_line},                              // r_lsr
    {beside_quarter, beside_line, beside_line},                              // r_lsl
    {beside_quarter, beside_line, beside_quarter},                           // r_lsr_l
}};

inline const SmallTurns& small_turns_of(Formula formula) {
  return small_turns[static_cast<std::size_t>(formula)];
}

/// By how much `SmallTurn::min_angle` falls beside an inner turn of angle `inner` [ramps]
/// (measured).
inline double min_angle_drop(double inner) { return 0.2 * std::max(0.0, inner - 1.5); }

/// Estimated length of a word of turns between straight wheels, from its angles by circles
/// (measured). Several small turns lack more than the sum of what each lacks.
inline double estimated_length(Formula formula, const Arcs& arcs, double ramp) {
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
/// beside a line of negative length. `min_angle` is that of `SmallTurn`.
inline bool may_have_clothoids(double min_angle, double angle, double length, double ramp) {
  constexpr double noise = 1e-9;
  const double share = length / ramp;
  return angle + noise >= ramp * (min_angle + (1 - min_angle) * share * share);
}

/// Limits of likely words of a steering (measured).
struct AngleLimits {
  double ramp;  ///< length of a clothoid to full lock [turning radii]
  double high;  ///< the cosine of the first or last angle of a word is at least -`high`
};

/// How far below 0 the first and the last angle of a word may be, as sines.
struct EndSlack {
  double first, last;
};

/// Whether the angle of a direction is likely for an end of a word: from -`slack` to a little more
/// than a quarter turn; in a word of three arcs to half a turn.
inline bool is_likely(const Complex& direction, double slack, double high, bool is_three_arcs) {
  const double squared = direction.squared();
  const double least = slack * slack + 1e-24;
  if (direction.im < 0 && (direction.re < 0 || direction.im * direction.im > least * squared)) {
    return false;
  }
  return direction.re >= 0 || is_three_arcs || direction.re * direction.re <= high * high * squared;
}

/// Angles of a word by its circles, if they are likely, for steering between stops.
inline std::optional<Arcs> likely_arcs_at_stops(Formula formula, const CircleWord& circles,
                                                const AngleLimits& limits, const EndSlack& slack) {
  const bool is_three_arcs = formula == Formula::l_r_l;
  if (!circles.exists || circles.line < -2 * limits.ramp ||
      !is_likely(circles.first, slack.first, limits.high, is_three_arcs) ||
      !is_likely(circles.last, slack.last, limits.high, is_three_arcs)) {
    return std::nullopt;
  }
  return in_one_turn(circles.arcs());
}

/// Angles of a word by its circles, if they are likely, where the curvature never jumps.
inline std::optional<Arcs> likely_arcs(Formula formula, const CircleWord& circles,
                                       const AngleLimits& limits, EndSlack slack) {
  if (circles.line < -1.05 * limits.ramp) return std::nullopt;
  if (circles.line > 3 * limits.ramp) {  // clothoids beside a long line move the turns but little
    slack.first = std::min(slack.first, 0.01 * limits.ramp);
    slack.last = std::min(slack.last, 0.01 * limits.ramp);
  }
  return likely_arcs_at_stops(formula, circles, limits, slack);
}

/// A word by its circles: angles and estimated length.
struct EstimatedWord {
  Arcs arcs;
  double length;
};

/// The word of a formula by its circles, where the curvature never jumps; nothing if there is none.
/// `simd::circle_words` gives the same for many words.
inline std::optional<EstimatedWord> estimated_word(Formula formula, const WordFrame& frame,
                                                   const Joints& joints, const AngleLimits& limits,
                                                   const EndSlack& slack) {
  const auto arcs = likely_arcs(formula, circle_word_of(formula, frame, joints), limits, slack);
  if (!arcs) return std::nullopt;
  const auto& [first, inner, last] = small_turns_of(formula);
  const double drop = min_angle_drop(arcs->inner);
  if (arcs->first < (first.min_angle - drop) * limits.ramp ||
      arcs->last < (last.min_angle - drop) * limits.ramp ||
      arcs->inner < inner.min_angle * limits.ramp) {
    return std::nullopt;
  }
  return EstimatedWord{*arcs, estimated_length(formula, *arcs, limits.ramp)};
}

/// Largest length that a word with these angles by its circles may save [turning radii].
inline double max_saving_by_circles(const Candidate& candidate, const Arcs& arcs, double ramp) {
  const auto& [first, inner, last] = small_turns_of(candidate.formula);
  constexpr double vanishes = 1e-6;
  const bool has_ends = arcs.first > first.vanishing * ramp + vanishes &&
                        arcs.last > last.vanishing * ramp + vanishes;
  // If an end step vanishes, the step beside it may save as much as any word.
  const double max_saving = candidate.task->max_saving();
  if (max_saving == 0 || !has_ends) return max_saving;
  const double drop = min_angle_drop(arcs.inner);
  const auto saves = [&](const SmallTurn& turn, double arc, double saving) {
    const bool lacks_line = arcs.line < 0;
    const bool may_drive_back = may_have_clothoids(turn.min_angle - drop, arc, saving / 2, ramp);
    const double may_save[] = {0, saving};  // a table: branches would be mispredicted
    return may_save[lacks_line || may_drive_back ? 1 : 0];
  };
  return saves(first, arcs.first, candidate.first_saving) +
         saves(last, arcs.last, candidate.last_saving);
}

}  // namespace vandplan::steering::continuous
