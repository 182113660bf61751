// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Many words by their circles have the bits of one word after the other, on every target of this
// machine.

#include "simd/circle_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "steering/continuous/circle_batch.h"
#include "steering/continuous/estimates.h"
#include "support/simd_targets.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using steering::continuous::AngleLimits;
using steering::continuous::EndSlack;
using steering::continuous::Formula;
using steering::continuous::Joints;
using steering::continuous::SharpTurns;
using steering::continuous::WordFrame;
using Words = std::array<simd::CircleWords, simd::circle_formulas>;

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Anywhere near, or on a grid where parts vanish and circles touch.
WordFrame any_frame(double reach, Rng& rng) {
  const auto eighths = [&](int most) {
    return static_cast<double>(static_cast<int>(rng() % (2U * static_cast<unsigned>(most) + 1)) -
                               most) /
           8;
  };
  if (rng() % 4 == 0) {
    const double x = eighths(40), y = eighths(40);
    return steering::continuous::word_frame({x, y, std::numbers::pi / 2 * eighths(8)});
  }
  const double x = uniform(-reach, reach, rng), y = uniform(-reach, reach, rng);
  return steering::continuous::word_frame({x, y, uniform(-2.0, 2.0, rng)});
}

struct Case {
  Joints joints;
  AngleLimits limits;
  std::vector<WordFrame> frames;
  std::vector<EndSlack> slacks;
};

Case any_case(std::size_t count, Rng& rng) {
  const double ramp = uniform(0.01, 0.6, rng);
  Case made{Joints(SharpTurns(1 / ramp), {}), {ramp, std::min(1.0, 0.4 + 1.6 * ramp)}, {}, {}};
  const double reach = rng() % 2 == 0 ? 3 : 20;
  for (std::size_t i = 0; i < count; ++i) {
    made.frames.push_back(any_frame(reach, rng));
    const double first = ramp * uniform(0, 1, rng), last = ramp * uniform(0, 1, rng);
    made.slacks.push_back({first, last});
  }
  return made;
}

/// All frames for all formulas.
void work_out(const Case& made, Words& words) {
  for (simd::CircleWords& all : words) {
    all.count = made.frames.size();
    for (std::size_t i = 0; i < all.count; ++i) {
      const WordFrame& f = made.frames[i];
      all.x[i] = f.x;
      all.y[i] = f.y;
      all.sin[i] = f.s;
      all.cos[i] = f.c;
      all.slack_first[i] = made.slacks[i].first;
      all.slack_last[i] = made.slacks[i].last;
    }
  }
  const Joints& j = made.joints;
  ASSERT_TRUE(
      simd::circle_words(words, steering::continuous::detail::formulas,
                         {j.ahead, j.aside, j.reach, j.skew, made.limits.ramp, made.limits.high}));
}

TEST(CircleKernels, WordsHaveTheBitsOfOneAfterTheOther) {
  const auto words = std::make_unique<Words>();
  std::size_t found = 0, none = 0;
  on_every_target([&](std::size_t count, Rng& rng) {
    const Case made = any_case(count % (simd::CircleWords::capacity + 1), rng);
    work_out(made, *words);
    for (std::size_t formula = 0; formula < words->size(); ++formula) {
      const simd::CircleWords& all = (*words)[formula];
      for (std::size_t i = 0; i < all.count; ++i) {
        SCOPED_TRACE("formula " + std::to_string(formula) + ", word " + std::to_string(i));
        const auto word =
            steering::continuous::estimated_word(static_cast<Formula>(formula), made.frames[i],
                                                 made.joints, made.limits, made.slacks[i]);
        ++(word ? found : none);
        if (!word) {
          EXPECT_EQ(all.length[i], std::numeric_limits<double>::infinity());
          continue;
        }
        EXPECT_EQ(bits(all.length[i]), bits(word->length));
        EXPECT_EQ(bits(all.first[i]), bits(word->arcs.first));
        EXPECT_EQ(bits(all.inner[i]), bits(word->arcs.inner));
        EXPECT_EQ(bits(all.line[i]), bits(word->arcs.line));
        EXPECT_EQ(bits(all.last[i]), bits(word->arcs.last));
      }
    }
  });
  EXPECT_GT(found, none / 10);
}

}  // namespace
}  // namespace vandplan
