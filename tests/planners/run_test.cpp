// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Who gets how much, who hears of whom, and what becomes of what is found: with workers that do
// what they are told.
#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "planners/anytime/portfolio.h"
#include "support/problems.h"

namespace vandplan {
namespace {

using anytime::Counts, anytime::Found, anytime::Phase, anytime::Portfolio;
using anytime::Progress, anytime::Proven, anytime::Share, anytime::Slot, anytime::Told,
    anytime::Worker;
using planning::PathSearch;
using search::Budget, search::Route;

constexpr double nothing = std::numeric_limits<double>::infinity();
constexpr double shortest = 20.0;  // of `open_problem` [m]

Problem open_problem() { return problem_of({0, 0, 0}, {shortest, 0, 0}, {}); }

/// A route to the goal that is said to cost so much.
Route route_of(double cost) {
  Route route{LocalPose{Pose{0, 0, 0}}, {}, 0.0};
  search::drive_on(route.legs, {0.0, 30.0}, LocalPose{Pose{30, 0, 0}});
  search::drive_on(route.legs, {0.0, -10.0}, LocalPose{Pose{shortest, 0, 0}});
  route.cost = cost;
  return route;
}

/// What a worker was asked to do in one round.
struct Call {
  std::int64_t granted;
  double told;  // cost of the best route; `nothing` without one
  double enough;
};

/// What a worker does and was asked to do.
struct Script {
  std::deque<double> finds = {};     // cost of the route that each round finds; `nothing`: none
  std::deque<double> gives_up = {};  // cost of the route that each round gives up
  bool has_work = true;
  double proof_of_step = 0.0;  // what a step of proving adds to the bound [m]

  std::vector<Call> calls = {};
  std::vector<double> offers = {};
  std::int64_t proofs = 0;
};

/// The next of what is left; `nothing` at the end.
double next(std::deque<double>& left) {
  if (left.empty()) return nothing;
  const double first = left.front();
  left.pop_front();
  return first;
}

class Scripted final : public Worker {
 public:
  explicit Scripted(Script& script) : script_(script) {}

  [[nodiscard]] bool has_work() const override { return script_.has_work; }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told, const Budget&) override {
    script_.calls.push_back(
        {iterations, told.route != nullptr ? told.route->cost : nothing, told.enough});
    Found found;
    found.iterations = iterations;
    if (const double cost = next(script_.finds); cost < nothing) {
      found.route = route_of(cost);
      found.improvements.push_back({0.0, iterations, cost});
    }
    if (const double cost = next(script_.gives_up); cost < nothing) {
      found.given_up.push_back(route_of(cost));
    }
    return found;
  }
  void offer(const Route& route) override { script_.offers.push_back(route.cost); }
  std::int64_t prove(std::int64_t steps, const Budget&) override {
    script_.proofs += steps;
    return steps;
  }
  [[nodiscard]] Proven proven() const override {
    return {.shortest = script_.proof_of_step * static_cast<double>(script_.proofs)};
  }
  [[nodiscard]] Counts counts() const override { return {}; }

 private:
  Script& script_;
};

Share always(std::int64_t iterations) {
  return [iterations](const Progress&) { return iterations; };
}

/// A run of scripted workers on open ground.
class Scheduling : public ::testing::Test {
 protected:
  /// The script of another worker, with so many iterations in each round.
  Script& add(std::int64_t share) {
    Script& script = scripts_.emplace_back();
    slots_.push_back(
        {.name = "", .worker = std::make_unique<Scripted>(script), .share = always(share)});
    return script;
  }
  /// The slot of the last worker.
  Slot& slot() { return slots_.back(); }

  PathSearch& run(const BudgetOptions& options) {
    auto pricing = std::make_unique<const planning::Pricing>(problem_.task(), shortest_style);
    const planning::Pricing& prices = *pricing;
    Portfolio portfolio{.pricing = std::move(pricing),
                        .relaxed = nullptr,
                        .bound = {problem_.task(), prices},
                        .finisher = {problem_.task(), prices, {}},
                        .slots = std::move(slots_),
                        .gap = options.target_gap};
    run_ = anytime::begin_run(std::move(portfolio), Budget(options), options);
    return *run_;
  }
  /// So many rounds.
  PathSearch& rounds(int count, BudgetOptions options = {}) {
    options.time_limit.reset();
    PathSearch& started = run(options);
    for (int i = 0; i < count; ++i) started.advance();
    return started;
  }

 private:
  Problem problem_ = open_problem();
  std::deque<Script> scripts_;
  std::vector<Slot> slots_;
  std::unique_ptr<PathSearch> run_;
};

TEST_F(Scheduling, EverybodyGetsTheirShareWhileThereIsABudget) {
  const Script& first = add(5);
  const Script& second = add(7);
  BudgetOptions options;
  options.max_iterations = 18;
  const PathSearch& run = rounds(3, options);
  EXPECT_EQ(run.iterations(), 18);
  ASSERT_EQ(first.calls.size(), 2U);
  EXPECT_EQ(first.calls[0].granted, 5);
  EXPECT_EQ(second.calls[0].granted, 7);
  EXPECT_EQ(first.calls[1].granted, 5);
  EXPECT_EQ(second.calls[1].granted, 1);
}

TEST_F(Scheduling, RoundsEndAtAPause) {
  const Script& first = add(5);
  const Script& second = add(7);
  PathSearch& run = rounds(0);
  EXPECT_TRUE(run.advance(8));
  EXPECT_EQ(first.calls[0].granted, 5);
  EXPECT_EQ(second.calls[0].granted, 3);
  EXPECT_TRUE(run.advance(0));
  EXPECT_EQ(first.calls[1].granted, 0);
  EXPECT_TRUE(run.advance(100));
  EXPECT_EQ(second.calls[2].granted, 7);
}

TEST_F(Scheduling, SharesSeeHowFarTheRunIs) {
  Script& finder = add(3);
  finder.finds = {nothing, 50.0};
  std::vector<Progress> seen;
  slot().share = [&](const Progress& now) {
    seen.push_back(now);
    return std::int64_t{3};
  };
  rounds(4);
  ASSERT_EQ(seen.size(), 4U);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(seen[i].rounds, static_cast<std::int64_t>(i));
    EXPECT_EQ(seen[i].iterations, 3 * static_cast<std::int64_t>(i));
    EXPECT_EQ(seen[i].has_path, i >= 2);
    EXPECT_EQ(seen[i].rounds_with_path, i == 3 ? 1 : 0);
  }
}

TEST_F(Scheduling, EverybodyHearsOfTheBestRouteInTheNextRound) {
  Script& finder = add(3);
  finder.finds = {50.0};
  const Script& other = add(3);
  rounds(2);
  EXPECT_EQ(other.calls[0].told, nothing);
  EXPECT_EQ(other.calls[1].told, 50.0);
  EXPECT_EQ(finder.calls[1].told, 50.0);
}

TEST_F(Scheduling, TheCheapestRouteWinsAndOfEqualOnesTheFirst) {
  add(3).finds = {50.0, 40.0, nothing, 30.0};
  add(3).finds = {45.0, 40.0, 35.0};
  PathSearch& run = rounds(4);
  const PlannerAnswer answer = run.answer();
  ASSERT_EQ(answer.status, PlanStatus::solved);
  ASSERT_EQ(answer.anytime.size(), 5U);
  const std::vector<std::pair<double, std::int64_t>> expected = {
      {50, 3}, {45, 6}, {40, 9}, {35, 18}, {30, 21}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(answer.anytime[i].cost, expected[i].first);
    EXPECT_EQ(answer.anytime[i].iteration, expected[i].second);
  }
}

TEST_F(Scheduling, WhatIsGivenUpIsOfferedToThoseWhoAreFed) {
  add(3).gives_up = {60.0, 70.0};
  slot().feeds = {1};
  const Script& fed = add(3);
  const Script& other = add(3);
  rounds(2);
  EXPECT_EQ(fed.offers, (std::vector{60.0, 70.0}));
  EXPECT_TRUE(other.offers.empty());
}

TEST_F(Scheduling, WhoRunsDryLosesNothing) {
  Script& dry = add(3);
  dry.finds = {50.0};
  const Script& other = add(4);
  PathSearch& run = rounds(1);
  dry.has_work = false;
  run.advance();
  EXPECT_EQ(dry.calls[1].granted, 0);
  EXPECT_EQ(other.calls[1].granted, 4);
  EXPECT_EQ(other.calls[1].told, 50.0);
  EXPECT_EQ(run.iterations(), 11);
  EXPECT_EQ(run.answer().anytime.back().cost, 50.0);
}

// Some wait for later rounds, so a while passes before that is so.
TEST_F(Scheduling, TheRunEndsWhenNobodyWorksAnyMore) {
  Script& finder = add(3);
  finder.finds = {50.0};
  Script& late = add(3);
  slot().share = [](const Progress& now) { return now.rounds < 90 ? 0 : 3; };
  PathSearch& run = rounds(1);
  finder.has_work = false;
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(run.advance());
  EXPECT_EQ(run.iterations(), 36);
  late.has_work = false;
  int more = 0;
  while (run.advance()) ASSERT_LT(++more, 1000);
  EXPECT_EQ(run.answer().status, PlanStatus::solved);
}

TEST_F(Scheduling, ARunWithoutARouteEndsWhenNobodyWorksAnyMore) {
  add(3).has_work = false;
  PathSearch& run = rounds(1);
  int more = 0;
  while (run.advance()) ASSERT_LT(++more, 1000);
  EXPECT_EQ(run.answer().status, PlanStatus::node_limit);
  EXPECT_EQ(run.answer().reason, "the finest searches have no route");
}

TEST_F(Scheduling, ARunWithoutARouteGoesOnWhileSomebodyProves) {
  add(0);
  slot().proofs = always(2);
  PathSearch& run = rounds(1000);
  EXPECT_TRUE(run.advance());
}

TEST_F(Scheduling, APauseDoesNotEndARun) {
  add(3).finds = {50.0};
  PathSearch& run = rounds(1);
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(run.advance(0));
}

TEST_F(Scheduling, RelaxedRoutesAreNoAnswersButOffers) {
  Script& relaxed = add(3);
  relaxed.finds = {30.0, nothing, 25.0};
  relaxed.gives_up = {35.0};
  slot().is_relaxed = true;
  slot().feeds = {1};
  const Script& fed = add(3);
  PathSearch& run = rounds(4);
  EXPECT_EQ(fed.offers, (std::vector{35.0, 30.0, 25.0}));
  EXPECT_EQ(fed.calls.back().told, nothing);
  EXPECT_NE(run.answer().status, PlanStatus::solved);
}

TEST_F(Scheduling, WhoWorksAfterTheOthersHearsOfThemInTheSameRound) {
  const Script& last = add(3);
  slot().phase = Phase::after;
  add(3).finds = {nothing, 50.0, 40.0};
  rounds(3);
  ASSERT_EQ(last.calls.size(), 2U);
  EXPECT_EQ(last.calls[0].told, 50.0);
  EXPECT_EQ(last.calls[1].told, 40.0);
}

TEST_F(Scheduling, AGapIsProvenNoFurtherThanItTakes) {
  add(3).finds = {30.0};
  Script& prover = add(4);
  prover.has_work = false;
  prover.proof_of_step = 9.0;
  slot().phase = Phase::before;
  slot().proofs = always(1);
  BudgetOptions options;
  options.target_gap = 0.12;
  PathSearch& run = rounds(5, options);
  EXPECT_EQ(prover.proofs, 3);
  EXPECT_EQ(run.iterations(), 3);
  EXPECT_NEAR(run.answer().lower_bound.value_or(0.0), 27.0, 1e-9);
}

TEST_F(Scheduling, WhatIsEnoughFollowsFromTheProof) {
  add(3).finds = {50.0};
  const Script& other = add(3);
  BudgetOptions options;
  options.target_gap = 0.5;
  rounds(2, options);
  EXPECT_NEAR(other.calls[1].enough, 1.5 * shortest, 1e-9);
}

TEST_F(Scheduling, ProofsAreNoIterations) {
  Script& prover = add(0);
  prover.proof_of_step = 5.0;
  slot().proofs = always(2);
  PathSearch& run = rounds(3);
  EXPECT_EQ(prover.proofs, 6);
  EXPECT_EQ(run.iterations(), 0);
  EXPECT_NEAR(run.answer().lower_bound.value_or(0.0), 30.0, 1e-9);
}

TEST_F(Scheduling, AnOptimalRouteEndsTheRun) {
  add(3).finds = {nothing, shortest};
  PathSearch& run = rounds(2);
  EXPECT_FALSE(run.advance());
  EXPECT_EQ(run.iterations(), 6);
}

TEST_F(Scheduling, ThreadsChangeNothing) {
  std::vector<CostSample> expected;
  for (const int threads : {1, 3}) {
    for (const double cost : {60.0, 55.0, 50.0, 45.0}) add(3).finds = {cost, cost - 7, cost - 11};
    BudgetOptions options;
    options.threads = threads;
    const std::vector<CostSample> trace = rounds(4, options).answer().anytime;
    if (threads == 1) expected = trace;
    ASSERT_EQ(trace.size(), expected.size());
    for (std::size_t i = 0; i < trace.size(); ++i) {
      EXPECT_EQ(trace[i].cost, expected[i].cost);
      EXPECT_EQ(trace[i].iteration, expected[i].iteration);
    }
  }
}

}  // namespace
}  // namespace vandplan
