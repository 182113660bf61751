// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// In which order do goals of a set come, how many are looked at, and which get the work?
#include "planners/set_goals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <stop_token>
#include <vector>

#include "planners/path_search.h"
#include "planners/plan_to_set.h"
#include "support/problems.h"
#include "vandplan/search.h"

namespace vandplan {
namespace {

using planning::SetGoal, planning::SetGoals;

constexpr double no_goal = std::numeric_limits<double>::infinity();

/// Docks on both sides of the start: bounds come in another order than straight ways, as the
/// vehicle has to turn. Something stands in dock 3.
Scenario both_rows() {
  Scenario scenario{.bounds = {-100, 100, -100, 100}, .start = {0, 0, 0.3}};
  for (int i = 0; i < 40; ++i) {
    const bool is_ahead = i % 2 == 0;
    scenario.goal_set.push_back(region_of_pose(
        {1.9 * i - 30, is_ahead ? 20.0 : -14.0, is_ahead ? 0.0 : std::numbers::pi / 2}));
  }
  const Pose blocked = {scenario.goal_set[3].x.least, -14.0, 0};
  scenario.obstacles = {box(blocked.x - 0.5, -14, blocked.x + 0.5, -13)};
  return scenario;
}

std::vector<std::size_t> order_of(SetGoals& goals) {
  std::vector<std::size_t> order;
  double last = 0.0;
  for (double least = goals.least_waiting(); least < no_goal; least = goals.least_waiting()) {
    const std::optional<SetGoal> goal = goals.next();
    if (!goal) break;
    EXPECT_LE(least, goal->bound);
    EXPECT_LE(last, goal->bound);
    last = goal->bound;
    order.push_back(goal->point.region);
  }
  return order;
}

/// Bound of the regions of a scenario, if nothing interrupts it.
double goals_bound(const Scenario& scenario) {
  const Problem problem = make_problem(scenario);
  const PlanOptions options;
  const search::Budget budget({});
  return SetGoals(problem.task(), options, 0.0, budget).bound_of_regions();
}

TEST(SetGoals, ComeInTheOrderOfTheirBounds) {
  const Problem problem = make_problem(both_rows());
  const PlanOptions options;
  const search::Budget budget(options.budget);
  SetGoals goals(problem.task(), options, 0.0, budget);
  goals.spread_out();
  const std::vector<std::size_t> order = order_of(goals);
  std::set<std::size_t> all(order.begin(), order.end());
  EXPECT_EQ(all.size(), order.size());
  EXPECT_FALSE(all.contains(3));
  EXPECT_GT(order.size(), 35U);
  EXPECT_EQ(goals.least_waiting(), no_goal);
  EXPECT_FALSE(goals.next());
}

TEST(SetGoals, OfAnAreaComeInTheOrderOfTheirBounds) {
  Scenario scenario = both_rows();
  scenario.goal_set.push_back(
      {.x = {-20, 20}, .y = {-10, 10}, .heading = {-std::numbers::pi, std::numbers::pi}});
  const Problem problem = make_problem(scenario);
  const PlanOptions options;
  const search::Budget budget(options.budget);
  SetGoals goals(problem.task(), options, 0.0, budget);
  goals.spread_out();
  EXPECT_GT(order_of(goals).size(), 60U);
}

// The goal that comes first is the one that all bounds of the set's single poses name.
TEST(SetGoals, TheFirstHasTheLeastBoundOfAll) {
  const Scenario scenario = both_rows();
  const Problem problem = make_problem(scenario);
  const PlanOptions options;
  const search::Budget budget(options.budget);
  SetGoals goals(problem.task(), options, 0.0, budget);
  goals.spread_out();
  const std::optional<SetGoal> first = goals.next();
  ASSERT_TRUE(first);
  for (std::size_t region = 0; region < scenario.goal_set.size(); ++region) {
    const std::optional<SetGoal> goal = goals.at({.region = region});
    if (goal) {
      EXPECT_GE(goal->bound, first->bound) << region;
    }
  }
}

/// A search that finds a path after so many iterations.
class LateSearch final : public planning::PathSearch {
 public:
  explicit LateSearch(std::int64_t late) : late_(late) {}

  bool advance(std::int64_t most) override {
    iterations_ += std::min<std::int64_t>(most, 16);
    return true;
  }
  [[nodiscard]] std::optional<std::vector<Segment>> path() override {
    if (iterations_ < late_) return std::nullopt;
    return std::vector{Segment{0.0, 100.0}};
  }
  [[nodiscard]] std::int64_t iterations() const override { return iterations_; }
  [[nodiscard]] PlannerAnswer answer() override {
    PlannerAnswer answer{.status = PlanStatus::iteration_limit, .iterations = iterations_};
    answer.segments = path();
    if (answer.segments) answer.anytime = {{0.0, iterations_, 100.0}};
    return answer;
  }

 private:
  std::int64_t late_, iterations_ = 0;
};

// Where each of 64 goals takes long, one of them gets along.
TEST(SetGoals, TheFirstGetsAQuarterOfTheWorkUntilThereIsAPath) {
  Scenario scenario = both_rows();
  scenario.goal_set = {{.x = {20, 60}, .y = {-10, 10}, .heading = {-3.0, 3.0}}};
  const Problem problem = make_problem(scenario);
  PlanOptions options;
  options.budget.max_iterations = 100'000;
  for (const std::int64_t late : {100, 2000, 8000}) {
    const auto search_to = [&](const Task&, const PlanOptions&, const Path*) {
      return std::make_unique<LateSearch>(late);
    };
    const PlannerAnswer answer = planning::plan_to_set(problem.task(), options, 0.0, search_to);
    ASSERT_FALSE(answer.anytime.empty());
    EXPECT_LT(answer.anytime.front().iteration, 4 * late + 64 * 16);
  }
}

// A set of many goals must not outlast the time of a run by all that is looked at in it.
TEST(SetGoals, LooksAtNothingOnceTheBudgetIsInterrupted) {
  Scenario scenario = both_rows();
  const GoalRegion area{.x = {20, 60}, .y = {-10, 10}, .heading = {-3.0, 3.0}};
  for (const bool has_area : {false, true}) {
    if (has_area) scenario.goal_set = {area};
    const Problem problem = make_problem(scenario);
    std::stop_source stop;
    PlanOptions options;
    options.budget.stop = stop.get_token();
    const search::Budget budget(options.budget);
    SetGoals goals(problem.task(), options, 0.0, budget);
    goals.spread_out();
    ASSERT_TRUE(goals.next());
    const double least = goals.least_waiting();
    stop.request_stop();
    int looks = 0;
    while (goals.next()) ++looks;
    if (has_area) {
      EXPECT_EQ(goals.least_waiting(), no_goal);  // all were looked at before
    } else {
      EXPECT_LT(looks, 16);
      EXPECT_LT(goals.least_waiting(), no_goal);
      EXPECT_GE(goals.least_waiting(), least);
    }
    SetGoals late(problem.task(), options, 0.0, budget);
    late.spread_out();
    EXPECT_FALSE(late.saw_all());
    EXPECT_FALSE(late.next());
    EXPECT_EQ(late.without_goals().status, PlanStatus::stopped);
    if (has_area) {
      EXPECT_LT(late.bound_of_regions(), goals_bound(scenario));
    }
  }
}

}  // namespace
}  // namespace vandplan
