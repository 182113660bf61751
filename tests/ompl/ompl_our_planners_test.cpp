// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Our planners as OMPL's.

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <sstream>
#include <stop_token>

#include "support/cases.h"
#include "support/ompl_query.h"
#include "vandplan/input_error.h"
#include "vandplan/ompl.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

// ---- our planners as OMPL's ----

PlanOptions few_iterations() {
  PlanOptions options{.cost = shortest_style};
  options.budget.max_iterations = 5000;
  return options;
}

TEST(OurPlannersInOmpl, EachOfThemSolves) {
  for (const Planner& planner : planners()) {
    SCOPED_TRACE(planner.name);
    for (const double away : {0.0, 1e6}) {
      if (is_sanitized && away > 0.0) continue;  // two minutes
      Query query(yard_scenario(away, away));
      const auto wrapped = std::make_shared<ompl::Planner>(query.si, planner, few_iterations());
      query.simple.setPlanner(wrapped);
      ASSERT_EQ(query.simple.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
      EXPECT_EQ(query.simple.getProblemDefinition()->getSolutions()[0].plannerName_,
                "vandplan_" + planner.name);
      og::PathGeometric& path = query.simple.getSolutionPath();
      EXPECT_NEAR(path.length(), wrapped->result()->cost, 1e-5);
      EXPECT_EQ(ompl::pose_of(path.getState(0)), query.problem.start());
      EXPECT_EQ(ompl::pose_of(path.getStates().back()), query.problem.goal());
      EXPECT_TRUE(path.check());
      if (away == 0.0) expect_judged_good(query);
    }
  }
}

TEST(OurPlannersInOmpl, StatesAreJoinedByThePathItself) {
  for_each_case(8, 200, [](Rng& rng) {
    Path path{uniform_pose({-100, 100, -100, 100}, rng), {}};
    for (int i = 0; i < 6; ++i) {
      const double curvature = (static_cast<double>(rng() % 3) - 1) / query_radius;
      path.segments.push_back(
          {curvature, uniform(-2 * query_radius * 3.14, 2 * query_radius * 3.14, rng)});
    }
    const std::vector<Pose> poses = ompl::way_points(path);
    double s = 0;
    for (std::size_t i = 1; i < poses.size(); ++i) {
      const Piece piece = reeds_shepp(poses[i - 1], poses[i], query_radius);
      const Pose middle =
          pose_at(Path{poses[i - 1], {piece.view().begin(), piece.view().end()}}, piece.length / 2);
      const Pose expected = pose_at(path, s + piece.length / 2);
      EXPECT_NEAR(std::hypot(middle.x - expected.x, middle.y - expected.y), 0, 1e-7);
      s += piece.length;
    }
    EXPECT_NEAR(s, length(path), 1e-6);
  });
}

/// How a run of a planner ends when the problem is changed.
template <typename Change>
ob::PlannerStatus status_after(Change change, const PlanOptions& options = few_iterations(),
                               const char* planner = "anytime") {
  Scenario scenario = yard_scenario();
  change(scenario);
  Query query(scenario);
  query.simple.setPlanner(
      std::make_shared<ompl::Planner>(query.si, planner_named(planner), options));
  const ob::PlannerStatus status = query.simple.solve(60.0);
  EXPECT_EQ(query.simple.getProblemDefinition()->hasSolutionNonExistenceProof(),
            status == ob::PlannerStatus::ABORT);
  EXPECT_EQ(query.simple.haveSolutionPath(), status == ob::PlannerStatus::EXACT_SOLUTION);
  return status;
}

TEST(OurPlannersInOmpl, OutcomesHaveTheNamesOfOmpl) {
  const auto unchanged = [](Scenario&) {};
  EXPECT_EQ(status_after(unchanged), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(status_after([](Scenario& s) { s.start.x = 10; }), ob::PlannerStatus::INVALID_START);
  EXPECT_EQ(status_after([](Scenario& s) { s.goal.x = 10; }), ob::PlannerStatus::INVALID_GOAL);
  EXPECT_EQ(status_after([](Scenario& s) {
              for (const Polygon& wall : {box(5, -10, 6, 20), box(35, -10, 36, 20),
                                          box(5, -10, 36, -9), box(5, 20, 36, 21)}) {
                s.obstacles.push_back(wall);
              }
              s.obstacles.erase(s.obstacles.begin());
              s.start.x = -10;
            }),
            ob::PlannerStatus::ABORT);  // proven
  PlanOptions none = few_iterations();
  none.budget.max_iterations = 0;
  EXPECT_EQ(status_after(unchanged, none, "rrt-opt-euc"), ob::PlannerStatus::TIMEOUT);
}

TEST(OurPlannersInOmpl, TheTerminationConditionEndsTheRun) {
  Query query(yard_scenario());
  std::atomic<int> asked = 0;
  Planner patient{.name = "patient", .summary = "waits"};
  patient.function = [](const Task&, const PlanOptions& options) {
    while (!options.budget.stop.stop_requested()) {
    }
    return PlannerAnswer{};
  };
  query.simple.setPlanner(
      std::make_shared<ompl::Planner>(query.si, patient, PlanOptions{.cost = shortest_style}));
  EXPECT_EQ(query.simple.solve(ob::PlannerTerminationCondition([&] { return ++asked > 3; })),
            ob::PlannerStatus::TIMEOUT);
  EXPECT_GT(asked, 3);
  std::stop_source stop;
  stop.request_stop();
  PlanOptions stopped{.cost = shortest_style};
  stopped.budget.stop = stop.get_token();
  query.simple.setPlanner(std::make_shared<ompl::Planner>(query.si, patient, stopped));
  EXPECT_EQ(query.simple.solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
}

TEST(OurPlannersInOmpl, OptionsAreParameters) {
  Query query(yard_scenario());
  ompl::Planner planner(query.si, "rrt-opt-euc");
  EXPECT_TRUE(planner.params().setParam("goal_bias", "0.5"));
  std::string value;
  EXPECT_TRUE(planner.params().getParam("goal_bias", value));
  EXPECT_EQ(value, "0.5");
  EXPECT_TRUE(planner.params().setParam("seed", "7"));
  EXPECT_TRUE(planner.params().getParam("seed", value));
  EXPECT_EQ(value, "7");
  EXPECT_FALSE(planner.params().hasParam("margin"));
  EXPECT_FALSE(planner.params().hasParam("steering"));
}

TEST(OurPlannersInOmpl, WhatDoesNotFitIsRefused) {
  Query query(yard_scenario());
  EXPECT_THROW(ompl::Planner(query.si, "none"), InputError);
  PlanOptions continuous = few_iterations();
  continuous.steering = Steering::continuous;
  EXPECT_THROW(ompl::Planner(query.si, default_planner(), continuous), InputError);
  const auto refuses = [](Query& other, const PlanOptions& options) {
    ompl::Planner planner(other.si, default_planner(), options);
    EXPECT_THROW(planner.setup(), ::ompl::Exception);
  };
  PlanOptions margin = few_iterations();
  margin.clearance.margin = 0.5;
  refuses(query, margin);
  Query dubins(yard_scenario(), std::make_shared<ompl::DubinsStateSpace>(query_radius));
  refuses(dubins, few_iterations());
  query.simple.setStateValidityChecker([](const ob::State*) { return true; });
  refuses(query, few_iterations());
}

TEST(OurPlannersInOmpl, TheMarginIsThatOfTheChecker) {
  Query query(yard_scenario(), nullptr, {.margin = 0.5});
  query.simple.setPlanner(
      std::make_shared<ompl::Planner>(query.si, default_planner(), few_iterations()));
  EXPECT_EQ(query.simple.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(query.simple.getSolutionPath().check());
  const Path path = path_of(query.simple.getSolutionPath(), query.problem);
  EXPECT_GE(check_path(query.problem, path).clearance.value_or(0), 0.5);
}

TEST(OurPlannersInOmpl, ASpaceMayTurnLessSharplyThanTheVehicle) {
  Query query(yard_scenario(), std::make_shared<ompl::ReedsSheppStateSpace>(9.0));
  query.simple.setPlanner(
      std::make_shared<ompl::Planner>(query.si, default_planner(), few_iterations()));
  EXPECT_EQ(query.simple.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(query.simple.getSolutionPath().check());
  const auto& planner = *query.simple.getPlanner()->as<ompl::Planner>();
  EXPECT_NEAR(query.simple.getSolutionPath().length(), planner.result()->cost, 1e-5);
}

TEST(OurPlannersInOmpl, TheTreeIsPlannerData) {
  Query query(yard_scenario());
  PlanOptions options = few_iterations();
  options.planner.set("keep_tree", true);
  const auto planner =
      std::make_shared<ompl::Planner>(query.si, planner_named("rrt-opt-euc"), options);
  query.simple.setPlanner(planner);
  EXPECT_EQ(query.simple.solve(60.0), ob::PlannerStatus::EXACT_SOLUTION);
  ob::PlannerData tree(query.si);
  planner->getPlannerData(tree);
  const std::size_t nodes = planner->result()->tree->poses.size();
  EXPECT_GT(nodes, 10U);
  EXPECT_EQ(tree.numVertices(), nodes);
  EXPECT_EQ(tree.numEdges(), nodes - 1);
  EXPECT_EQ(tree.numStartVertices(), 1U);
  planner->clear();
  ob::PlannerData nothing(query.si);
  planner->getPlannerData(nothing);
  EXPECT_EQ(nothing.numVertices(), 0U);
}

TEST(OurPlannersInOmpl, TheyAppearInOmplsBenchmark) {
  Query query(yard_scenario());
  ::ompl::tools::Benchmark benchmark(query.simple, "yard");
  benchmark.addPlanner(
      std::make_shared<ompl::Planner>(query.si, default_planner(), few_iterations()));
  benchmark.addPlanner(std::make_shared<ompl::geometric::RRTConnect>(query.si));
  ::ompl::tools::Benchmark::Request request;
  request.maxTime = 60;
  request.runCount = 2;
  request.displayProgress = false;
  request.simplify = false;
  request.saveConsoleOutput = false;  // no file beside the test
  benchmark.benchmark(request);
  std::ostringstream log;
  benchmark.saveResultsToStream(log);
  EXPECT_NE(log.str().find("vandplan_anytime"), std::string::npos);
  for (const auto& planner : benchmark.getRecordedExperimentData().planners) {
    ASSERT_EQ(planner.runs.size(), 2U);
    for (const auto& run : planner.runs) {
      EXPECT_EQ(run.at("solved BOOLEAN"), "1") << planner.name;
      EXPECT_EQ(run.at("correct solution BOOLEAN"), "1") << planner.name;
    }
  }
}

}  // namespace
}  // namespace vandplan
