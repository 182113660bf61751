// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Are many problems planned like each of them alone, and handed over in their order?

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>

#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

/// Goals beside each other behind a wall, all in one world.
std::vector<Problem> many_problems() {
  const auto world = world_of({.bounds = wide_bounds, .obstacles = {box(14, -8, 16, 8)}});
  std::vector<Problem> problems;
  for (int i = 0; i < 12; ++i) {
    problems.push_back(make_problem(world, {}, {0, 0, 0}, {30, -12.0 + 2 * i, 0.1 * i}));
  }
  return problems;
}

PlanOptions some_iterations() {
  PlanOptions options;
  options.budget.max_iterations = 300;
  return options;
}

class PlanMany : public testing::TestWithParam<int> {};

TEST_P(PlanMany, EachResultIsThatOfThePlanAlone) {
  const std::vector<Problem> problems = many_problems();
  std::size_t count = 0;
  plan_many(problems, default_planner(), some_iterations(), GetParam(),
            [&](std::size_t i, const PlanResult& result) {
              ASSERT_EQ(i, count++);
              const PlanResult alone = plan(problems[i], some_iterations());
              EXPECT_EQ(result.status, alone.status);
              EXPECT_EQ(result.path, alone.path);
              EXPECT_EQ(result.cost, alone.cost);
              EXPECT_EQ(result.iterations, alone.iterations);
            });
  EXPECT_EQ(count, problems.size());
}

/// The later ones of five problems in a row are done first.
TEST_P(PlanMany, ResultsAreTakenInTheOrderOfTheProblems) {
  std::atomic<int> running = 0;
  const Planner planner{
      .name = "uneven", .summary = "", .function = [&](const Task& task, const PlanOptions&) {
        ++running;
        const double y = task.goal.y;
        const auto rounds = static_cast<int>(1e6 * (12 - y));
        volatile double work = 0;
        for (int i = 0; i < rounds; ++i) work = work + 1;
        --running;
        return PlannerAnswer{.status = PlanStatus::no_path,
                             .iterations = static_cast<std::int64_t>(y + 12)};
      }};
  std::vector<std::size_t> order;
  plan_many(many_problems(), planner, {}, GetParam(), [&](std::size_t i, const PlanResult& result) {
    EXPECT_EQ(result.iterations, static_cast<std::int64_t>(2 * i));
    EXPECT_LE(running.load(), GetParam());
    order.push_back(i);
  });
  ASSERT_EQ(order.size(), 12U);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST_P(PlanMany, WhatAPlannerThrowsComesOut) {
  const Planner planner{.name = "breaks",
                        .summary = "",
                        .function = [](const Task& task, const PlanOptions&) -> PlannerAnswer {
                          if (task.goal.y > 0) throw std::runtime_error("broken");
                          return {.status = PlanStatus::no_path};
                        }};
  std::vector<std::size_t> taken;
  const auto take = [&](std::size_t i, const PlanResult&) { taken.push_back(i); };
  EXPECT_THROW(plan_many(many_problems(), planner, {}, GetParam(), take), std::runtime_error);
  EXPECT_LE(taken.size(), 7U);  // the goals at y = -12, -10, ... 0
  for (std::size_t i = 0; i < taken.size(); ++i) EXPECT_EQ(taken[i], i);
}

TEST_P(PlanMany, WhatIsThrownWhileTakingComesOutAndNothingIsTakenAfterIt) {
  int taken = 0;
  const auto take = [&](std::size_t i, const PlanResult&) {
    ++taken;
    if (i == 3) throw std::runtime_error("full");
  };
  EXPECT_THROW(plan_many(many_problems(), default_planner(), some_iterations(), GetParam(), take),
               std::runtime_error);
  EXPECT_EQ(taken, 4);
}

TEST_P(PlanMany, OptionsAreCheckedBeforeAnythingIsTaken) {
  PlanOptions wrong = some_iterations();
  wrong.budget.threads = 0;
  const auto take = [](std::size_t, const PlanResult&) { ADD_FAILURE() << "taken"; };
  EXPECT_THROW(plan_many(many_problems(), default_planner(), wrong, GetParam(), take), InputError);
}

TEST_P(PlanMany, OfNoProblemsNothingIsTaken) {
  plan_many({}, default_planner(), {}, GetParam(),
            [](std::size_t, const PlanResult&) { ADD_FAILURE() << "taken"; });
}

INSTANTIATE_TEST_SUITE_P(Jobs, PlanMany, testing::Values(1, 2, 5),
                         [](const auto& jobs) { return std::to_string(jobs.param); });

}  // namespace
}  // namespace vandplan
