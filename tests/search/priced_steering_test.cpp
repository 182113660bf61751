// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Steering under prices: is the piece the cheapest, also where an arc vanishes and lengths jump?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "steering/words.h"
#include "support/leads.h"
#include "support/problems.h"
#include "support/radius.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using search::Connector;
using search::CostRule;
using search::end_of;

constexpr CostRule rules[] = {{1, 2, 20, 0},  {1, 2, 5, 0}, {1, 1, 0.1, 0},
                              {1, 1.5, 0, 0}, {1, 3, 5, 1}, {2, 1, 5, -1}};
constexpr CostOptions dear = by_length_and(2, 20);

Piece piece_of(std::span<const Segment> segments) {
  Piece piece;
  for (const Segment& segment : segments) piece.segments[piece.count++] = segment;
  piece.length = length(segments);
  return piece;
}

/// A word between two random poses: each of those of Reeds and Shepp and of Dubins has a chance.
Piece random_word(Rng& rng) {
  const Pose to = uniform_pose({-25, 25, -25, 25}, rng);
  std::vector<Piece> words = reeds_shepp_words({}, to, default_radius);
  for (const Piece& word : dubins_words({}, to, default_radius)) words.push_back(word);
  const Piece word = words[rng() % words.size()];
  return rng() % 2 == 0 ? word : reversed(word);
}

/// The ends and the line of a word are left out or made tiny, each by chance: then it is on the
/// border of what words of its kind reach, or close to it on either side.
Piece degenerate(const Piece& word, Rng& rng) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < word.count; ++i) {
    Segment segment = word.segments[i];
    const bool may_vanish = i == 0 || i + 1U == word.count || segment.curvature == 0.0;
    const double chance = uniform01(rng);
    if (may_vanish && chance < 0.4) continue;
    if (may_vanish && chance < 0.6) segment.length *= std::exp2(uniform(-30, -5, rng));
    segments.push_back(segment);
  }
  return piece_of(segments);
}

/// As people type it, with six decimals.
Pose typed(const Pose& pose) {
  const auto rounded = [](double value) { return std::round(value * 1e6) / 1e6; };
  return {rounded(pose.x), rounded(pose.y), rounded(pose.heading)};
}

Pose moved(const Pose& pose, Rng& rng) {
  const double angle = uniform(-std::numbers::pi, std::numbers::pi, rng);
  const double by = uniform(0, 4e-7, rng);
  return {pose.x + by * std::cos(angle), pose.y + by * std::sin(angle),
          pose.heading + uniform(-4e-7, 4e-7, rng)};
}

bool ends_within(const Pose& end, const Pose& goal, const steering::Closing& closing) {
  return std::hypot(end.x - goal.x, end.y - goal.y) <= closing.position &&
         std::abs(wrap_angle(end.heading - goal.heading)) <= closing.heading;
}

/// Steering to a goal that a word leads to, nearly, costs no more than the word.
void expect_no_dearer(const Pose& start, const Piece& word, const Pose& goal,
                      const CostRule& rule) {
  const Problem problem = problem_of(start, goal, {});
  Connector connector(problem.task(), rule);
  const search::DrivenBeside beside{rule.initial_gear, 0};
  const Piece piece = *connector.steer(Local(start), Local(goal), beside);
  EXPECT_LE(connector.cost(piece, beside), connector.cost(word, beside) + 2e-4)
      << as_code(word.view()) << " to " << as_code(goal);
  EXPECT_TRUE(ends_within(end_of(start, piece), goal, {0.9e-6, 0.9e-6})) << as_code(word.view());
  EXPECT_NEAR(piece.length, length(piece.view()), 1e-9);
  for (const Segment& segment : piece.view())
    EXPECT_LE(std::abs(segment.curvature), 1 / default_radius);
}

TEST(PricedSteering, CostsNoMoreThanTheWordThatMadeTheGoal) {
  for_each_case(1, 200, [](Rng& rng) {
    for (int i = 0; i < 100; ++i) {
      const Piece word = rng() % 4 == 0 ? random_word(rng) : degenerate(random_word(rng), rng);
      const CostRule& rule = rules[rng() % std::size(rules)];
      expect_no_dearer({}, word, typed(end_of(Pose{}, word)), rule);
      const Pose start = uniform_pose({-300, 300, -300, 300}, rng);
      expect_no_dearer(start, word, moved(end_of(start, word), rng), rule);
      expect_no_dearer(start, word, end_of(start, word), rule);
    }
  });
}

TEST(PricedSteering, DrivesATypedArcInOneGo) {
  for (const Pose& goal : {Pose{7, 7, 1.570796}, Pose{4.949747, 2.050253, 0.785398}}) {
    const PlanResult result =
        plan(problem_of({}, goal, {}), {.cost = dear, .steering = Steering::reeds_shepp});
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_NEAR(result.cost, default_radius * goal.heading, 1e-5);
    EXPECT_EQ(result.path->segments.size(), 1U);
  }
}

// Far from the origin the doubles themselves are no more exact than that.
TEST(PricedSteering, DrivesAnArcInOneGoFarFromTheOrigin) {
  for_each_case(2, 200, [](Rng& rng) {
    const Pose start{500000 + uniform(0, 100, rng), 6400000 + uniform(0, 100, rng),
                     uniform(-3.1, 3.1, rng)};
    const Segment arc{(rng() % 2 == 0 ? 1 : -1) / default_radius,
                      uniform(0.1, 4, rng) * default_radius};
    const Path path{start, {arc}};
    Scenario scenario{.bounds = {start.x - 100, start.x + 100, start.y - 100, start.y + 100},
                      .start = start,
                      .goal = end_pose(path)};
    if (rng() % 2 == 0) scenario.goal = typed(scenario.goal);
    const PlanResult result =
        plan(scenario,
             {.budget = {.max_iterations = 100}, .cost = dear, .steering = Steering::reeds_shepp});
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_EQ(result.path->segments.size(), 1U) << as_code(result.path->segments);
    EXPECT_NEAR(result.cost, arc.length, 1e-4);
  });
}

// Only the last piece may end beside its pose: the errors of many would add up, and those of
// headings grow on the way.
TEST(PricedSteering, EndsOnTheWayButForRounding) {
  for_each_case(3, 100, [](Rng& rng) {
    const Problem problem = problem_of({}, {150, 0, 0}, {});
    Connector connector(problem.task(), rules[rng() % std::size(rules)]);
    for (int i = 0; i < 100; ++i) {
      const Pose from = uniform_pose({-100, 100, -100, 100}, rng);
      const Pose exact = end_of(from, degenerate(random_word(rng), rng));
      const Pose to = rng() % 2 == 0 ? exact : moved(exact, rng);
      const Pose end = end_of(from, *connector.steer(Local(from), Local(to)));
      EXPECT_TRUE(ends_within(end, to, {1e-9, 1e-11})) << as_code(from) << " to " << as_code(to);
    }
  });
}

// Cut anywhere, a word is steered along its parts as it was: rounding brings no gear change.
TEST(PricedSteering, GoesOnAlongAWordThatWasCut) {
  for_each_case(4, 300, [](Rng& rng) {
    const Piece word = piece_of(std::vector<Segment>{{1 / default_radius, uniform(1, 20, rng)},
                                                     {0, uniform(1, 200, rng)},
                                                     {-1 / default_radius, uniform(1, 20, rng)}});
    const Problem problem = problem_of({}, end_of(Pose{}, word), {});
    Connector connector(problem.task(), {1, 2, 20, 0});
    Pose pose;
    double cost = 0.0;
    for (int i = 1; i <= 50; ++i) {
      const Pose next = end_of(Pose{}, search::prefix(word, word.length * i / 50));
      const Piece piece = *connector.steer(Local(pose), Local(next));
      cost += connector.cost(piece, {1, 1});
      for (const Segment& segment : piece.view()) pose = advance(pose, segment);
      EXPECT_TRUE(ends_within(pose, next, {1e-9, 1e-11}));
    }
    EXPECT_NEAR(cost, word.length, 1e-8);
  });
}

TEST(PricedSteering, TheJudgeAllowsWhatItIsHeldAgainst) {
  const Path path{{}, {{0, 10}}};
  const auto is_valid = [&](const Pose& goal) {
    return check_path(problem_of({}, goal, {}), path).valid;
  };
  for (const double share : {0.99, 1.01}) {
    const steering::Closing off{share * steering::judged.position,
                                share * steering::judged.heading};
    EXPECT_EQ(is_valid({10, off.position, 0}), share < 1);
    EXPECT_EQ(is_valid({10, 0, off.heading}), share < 1);
  }
}

// A left bend and a right one lead there, but for rounding: the line that would lead there exactly
// is left out.
TEST(Words, LackAPartThatIsNoLongerThanRounding) {
  const Pose bend{2 * default_radius * std::sin(0.5), 2 * default_radius * (1 - std::cos(0.5)), 0};
  for (const double off : {1e-12, 3e-12, 8e-12}) {
    std::vector<Piece> words;
    steering::find_words({}, {bend.x + off, bend.y, 0}, default_radius,
                         {.longest = 2 * default_radius, .closing = steering::on_the_way}, words);
    EXPECT_TRUE(std::any_of(words.begin(), words.end(), [](const Piece& word) {
      return word.count == 2 && std::abs(word.length - default_radius) < 1e-11;
    })) << off;
  }
}

TEST(Mended, LengthsComeBack) {
  for_each_case(5, 1000, [](Rng& rng) {
    const Piece word = random_word(rng);
    Piece off = word;
    for (std::size_t i = 0; i < off.count; ++i) off.segments[i].length *= uniform(0.9999, 1, rng);
    const Pose to = end_of(Pose{}, word);
    const std::optional<Piece> mended = steering::mended({}, to, off, steering::at_goal);
    if (!mended) return;  // what lacks a part may not come back; the word does not end elsewhere
    EXPECT_TRUE(ends_within(end_of(Pose{}, *mended), to, steering::at_goal));
  });
}

TEST(Mended, WhatWouldBeShorterThanNothingIsLeftOut) {
  const Piece word = piece_of(std::vector<Segment>{{0, 1e-4}, {1 / default_radius, 5}, {0, 3}});
  const Pose to = end_of(Pose{}, piece_of(std::vector<Segment>{{1 / default_radius, 5}, {0, 3}}));
  const std::optional<Piece> mended = steering::mended({}, to, word, steering::on_the_way);
  ASSERT_TRUE(mended);
  EXPECT_LE(mended->count, 3);
  EXPECT_NEAR(mended->length, 8, 1e-9);
}

TEST(Mended, EndsNowhereElse) {
  const Piece word = piece_of(std::vector<Segment>{{1 / default_radius, 5}});
  const Pose end = end_of(Pose{}, word);
  EXPECT_TRUE(steering::mended({}, {end.x, end.y, end.heading + 5e-7}, word, steering::at_goal));
  EXPECT_FALSE(steering::mended({}, {end.x, end.y, end.heading + 5e-6}, word, steering::at_goal));
}

}  // namespace
}  // namespace vandplan
