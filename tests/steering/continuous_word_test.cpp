// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous/word_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steering/word.h"
#include "support/cases.h"
#include "support/draws.h"

namespace vandplan::steering::continuous {
namespace {

/// A word of any formula that ends where the frame does, and what Newton's method begins with.
struct DrawnWord {
  WordSolver solver;
  Formula formula;
  Stops stops;
  WordFrame frame;
  Arcs guess;

  [[nodiscard]] std::optional<SolvedWord> solve(const NewtonLimits& limits) const {
    return solver.solve(formula, stops, frame, guess, limits);
  }
};

DrawnWord drawn_word(Rng& rng) {
  const double ramp = any_size(0.02, 0.6, rng);
  const Formula formula = formula_rows[rng() % 9].formula;
  const bool jumps = chance(0.5, rng);
  const double reach = any_size(0.1, 10, rng);
  const double x = uniform(0, reach, rng), y = uniform(0, reach, rng);
  const MeanFrame frame{x, y, uniform(0, 1.57, rng)};
  return {WordSolver(SharpTurns(1 / ramp)),
          formula,
          {jumps, jumps, jumps},
          word_frame(frame),
          in_one_turn(arcs_of(formula, Circles(frame)))};
}

TEST(ContinuousWord, IsTheSameWhereLongerOnesAreOfNoUse) {
  int found = 0, lost = 0;
  for_each_case(1, 20000, [&](Rng& rng) {
    const DrawnWord drawn = drawn_word(rng);
    const auto word = drawn.solve({12});
    if (!word) return;
    const auto same = drawn.solve({12, 4, word->length * uniform(1, 1.2, rng)});
    ++found;
    lost += same ? 0 : 1;
    if (same) {
      EXPECT_EQ(same->lengths, word->lengths);
    }
  });
  EXPECT_GE(found, cases(20000) / 20);
  EXPECT_LE(lost, found / 1000);
}

TEST(ContinuousWord, IsSeldomSolvedToItsEndWhereItIsOfNoUse) {
  int found = 0, solved = 0;
  for_each_case(2, 20000, [&](Rng& rng) {
    const DrawnWord drawn = drawn_word(rng);
    const auto word = drawn.solve({12});
    if (!word) return;
    ++found;
    solved += drawn.solve({12, 4, word->length * 0.7}) ? 1 : 0;
  });
  EXPECT_LE(solved, found / 10);
}

}  // namespace
}  // namespace vandplan::steering::continuous
