// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which angles have the turns of many words by their circles, and about how long are these words?
//
// Plain C++, numbers only. The specification is `circles::word_of` and what the search for the
// least word of continuous steering asks of it, where the curvature never jumps
// (steering/continuous_least.cpp): every vector target gives its bits.

#include <array>
#include <cstddef>

namespace vandplan::simd {

/// What becomes of a small turn, as bounds::Small says.
struct SmallTurn {
  double least, lack, growth, most;
};

/// What all words of a formula share.
struct CircleFormula {
  double first_gear, first_turn, last_gear, last_turn;  ///< of the steps at both ends, 1 or -1
  SmallTurn first, inner, last;
};

/// What all words have in common, in turning radii.
struct CircleTurns {
  double ahead, aside;  ///< centre of a circle from where the wheels are straight
  double reach, skew;   ///< how far that is, how far off the perpendicular [rad]
  double ramp;          ///< length of a clothoid to full lock
  double high;          ///< the cosine of the largest angle at the ends of a word is above -`high`
};

/// The formulas of Reeds and Shepp.
inline constexpr std::size_t circle_formulas = 9;

/// Words of one formula, those looked at by one call.
struct CircleWords {
  static constexpr std::size_t most = 36;
  static constexpr std::size_t room = most + 4;  ///< for what fills vectors
  using Numbers = std::array<double, room>;

  std::size_t count = 0;
  Numbers x, y, sin, cos;       ///< their frames, sine and cosine of half the turn
  Numbers low_first, low_last;  ///< by so much both may be below nothing, at most 1
  /// Angles of the turns and the length of the line, which may be less than nothing [rad].
  Numbers first, inner, line, last;
  Numbers length;  ///< about, infinite where there is no such word
};

/// Works out the words of all formulas, for numbers up to 1e50. Returns false in a build without
/// vectors of double, and does nothing.
bool circle_words(std::array<CircleWords, circle_formulas>& words,
                  const std::array<CircleFormula, circle_formulas>& formulas,
                  const CircleTurns& turns) noexcept;

}  // namespace vandplan::simd
