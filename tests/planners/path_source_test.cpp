// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What becomes of paths that the caller proposes while the default planner runs?

#include "vandplan/planner.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "../support/cases.h"
#include "../support/problems.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

/// A wall between start and goal, so that the best path on open ground is not free.
const std::vector<Polygon> wall_between = {box(10, -8, 12, 8)};
constexpr Pose begin{0, 0, 0};
constexpr Pose end{25, 0, 0};

PlanOptions limited(std::int64_t iterations, int threads = 1) {
  PlanOptions options;
  options.budget.max_iterations = iterations;
  options.budget.threads = threads;
  return options;
}

Path good_path() { return plan(problem_of(begin, end, wall_between), limited(5000)).path.value(); }

/// What a source was told, and how often it was asked.
struct Record {
  std::vector<double> costs = {};
  std::vector<LocalPath> paths = {};
  int proposals = 0;
};

/// Proposes the same paths in each run, then nothing.
class Listed final : public PathSource {
 public:
  Listed(std::vector<LocalPath> paths, Record& record)
      : paths_(std::move(paths)), record_(record) {}

  std::optional<LocalPath> propose() override {
    ++record_.proposals;
    return paths_[next_++];
  }
  [[nodiscard]] bool has_work() const override { return next_ < paths_.size(); }
  void hear(const LocalPath& best, double cost) override {
    record_.costs.push_back(cost);
    record_.paths.push_back(best);
  }

 private:
  std::vector<LocalPath> paths_;
  std::size_t next_ = 0;
  Record& record_;
};

/// The default planner with a source that proposes these paths of the scenario's frame.
Planner proposing(const std::vector<Path>& paths, Record& record) {
  const auto make = [paths, &record](const Task& task, const PlanOptions&) {
    std::vector<LocalPath> local;
    for (const Path& path : paths) {
      local.push_back({to_local(*task.world, path.start), path.segments});
    }
    return std::make_unique<Listed>(std::move(local), record);
  };
  return with_sources({{.name = "listed", .make = make}});
}

TEST(PathSource, AGoodPathIsTheAnswerSoon) {
  const Problem problem = problem_of(begin, end, wall_between);
  const double cost = plan(problem, limited(5000)).cost;
  Record record;
  const PlanResult with = plan(problem, proposing({good_path()}, record), limited(100));
  ASSERT_EQ(with.status, PlanStatus::solved) << with.reason;
  EXPECT_LE(with.cost, cost * (1 + 1e-3));
  EXPECT_GT(plan(problem, limited(100)).cost, cost * (1 + 1e-2));
}

TEST(PathSource, APathThatBeginsAndEndsElsewhereIsFitted) {
  const Problem problem = problem_of({-0.5, 0.3, 0.1}, {25.5, 0.2, 0.05}, wall_between);
  Record record;
  const PlanResult result = plan(problem, proposing({good_path()}, record), limited(100));
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.cost, plan(problem, limited(100)).cost * 0.95);
}

TEST(PathSource, WhatNoVehicleCanDriveLeavesTheAnswerRight) {
  const std::vector<Path> nonsense = {{begin, {{0, 25}}},               // through the wall
                                      {begin, {{10, 25}}},              // a turn that is too tight
                                      {begin, {}},                      // nothing
                                      {{1e6, -1e6, 3}, {{0, -1e5}}},    // far away
                                      {begin, {{0, 0}, {0, 1e-300}}}};  // hardly anything
  Record record;
  const PlanResult result =
      plan(problem_of(begin, end, wall_between), proposing(nonsense, record), limited(3000));
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_EQ(record.proposals, 5);
  EXPECT_TRUE(result.check->valid);
}

TEST(PathSource, HearsOfEachBetterPath) {
  Record record;
  const Problem problem = problem_of(begin, end, wall_between);
  const PlanResult result = plan(problem, proposing({{begin, {{0, 25}}}}, record), limited(3000));
  ASSERT_GE(record.costs.size(), 2U);
  for (std::size_t i = 1; i < record.costs.size(); ++i) {
    EXPECT_LT(record.costs[i], record.costs[i - 1]);
  }
  EXPECT_LE(result.cost, record.costs.back());
  for (const LocalPath& path : record.paths) {
    const Pose last = end_pose({path.start, path.segments});
    EXPECT_NEAR(last.x - path.start.x, end.x - begin.x, 1e-6);
  }
}

TEST(PathSource, TheAnswerDoesNotDependOnTheThreads) {
  const Problem problem = problem_of(begin, end, wall_between);
  const Path known = good_path();
  Record one;
  Record four;
  const PlanResult alone = plan(problem, proposing({known}, one), limited(2000, 1));
  const PlanResult shared = plan(problem, proposing({known}, four), limited(2000, 4));
  EXPECT_EQ(alone.path, shared.path);
  EXPECT_EQ(one.costs, four.costs);
}

TEST(PathSource, WithoutAProposalTheAnswerIsNearlyThatOfTheDefaultPlanner) {
  Record record;
  const Problem problem = problem_of(begin, end, wall_between);
  const PlanResult without = plan(problem, limited(3000));
  const PlanResult with = plan(problem, proposing({}, record), limited(3000));
  EXPECT_EQ(with.path, without.path);
}

TEST(PathSource, ProposesAmongWhatMoves) {
  Scenario crossing;
  crossing.bounds = {-20, 60, -30, 30};
  crossing.start = begin;
  crossing.goal = end;
  crossing.obstacles = wall_between;
  crossing.moving = {{box(-1, -1, 1, 1), {{0, {20, -25, 0}}, {20, {20, 25, 0}}}}};
  Record record;
  const PlanResult result =
      plan(make_problem(crossing), proposing({good_path()}, record), limited(1000));
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GE(record.proposals, 1);
}

TEST(PathSource, ANumberThatIsNotFiniteEndsTheRun) {
  Record record;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Planner planner = proposing({{begin, {{0, none}}}}, record);
  EXPECT_THROW((void)plan(problem_of(begin, end, wall_between), planner, limited(1000)),
               InputError);
}

TEST(PathSource, RefusesASourceThatCannotWork) {
  EXPECT_THROW((void)with_sources({{.name = "none", .make = {}}}), InputError);
  const auto nothing = [](const Task&, const PlanOptions&) {
    return std::unique_ptr<PathSource>();
  };
  EXPECT_THROW((void)with_sources({{.name = "idle", .make = nothing, .share = 0}}), InputError);
  EXPECT_THROW((void)with_sources({{.name = "busy", .make = nothing, .share = 10'001}}),
               InputError);
  const Planner empty = with_sources({{.name = "empty", .make = nothing}});
  EXPECT_THROW((void)plan(problem_of(begin, end, wall_between), empty, limited(100)), InputError);
}

}  // namespace
}  // namespace vandplan
