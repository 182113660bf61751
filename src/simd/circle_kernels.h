// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which angles do the turns of many words have by their circles, and about how long are the words?
//
// Plain C++, numbers only. The specification is `estimated_word` of continuous steering, where
// the curvature never jumps (steering/continuous/estimates.h): every vector target gives its bits.

#include <array>
#include <cstddef>

namespace vandplan::simd {

/// Numbers of `SmallTurn` of continuous steering (steering/continuous/estimates.h).
struct SmallTurn {
  double min_angle, lack, growth, max_lack;
};

/// What all words of a formula share.
struct CircleFormula {
  /// Gear and side of the first and of the last step, 1 or -1.
  double first_gear, first_turn, last_gear, last_turn;
  SmallTurn first, inner, last;
};

/// What all words have in common, in turning radii.
struct CircleTurns {
  double ahead, aside;  ///< centre of a circle, seen from where the wheels are straight
  double reach, skew;   ///< distance of that centre, and its angle off the perpendicular [rad]
  double ramp;          ///< length of a clothoid to full lock
  double high;          ///< the cosine of the first or last angle of a word is at least -`high`
};

/// Number of formulas of Reeds and Shepp.
inline constexpr std::size_t circle_formulas = 9;

/// Words of one formula that one call works out.
struct CircleWords {
  static constexpr std::size_t capacity = 36;
  static constexpr std::size_t padded = capacity + 4;  ///< enough to fill the last vector, too
  using Numbers = std::array<double, padded>;

  std::size_t count = 0;
  Numbers x, y, sin, cos;  ///< frames of the words, with sine and cosine of half the turn
  Numbers slack_first,
      slack_last;  ///< how far below 0 first and last angles may be (sines), at most 1
  /// Result: angles of the turns [rad] and length of the line [turning radii], negative ones, too.
  Numbers first, inner, line, last;
  Numbers length;  ///< result: estimated length; infinite where there is no word
};

/// Works out the words of all formulas, for numbers up to 1e50. Returns false in a build without
/// vectors of double, and does nothing.
bool circle_words(std::array<CircleWords, circle_formulas>& words,
                  const std::array<CircleFormula, circle_formulas>& formulas,
                  const CircleTurns& turns) noexcept;

}  // namespace vandplan::simd
