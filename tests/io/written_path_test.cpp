// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Whoever drives the segments of a result file arrives at the goal, near the origin and far away.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "support/problems.h"
#include "support/shared_files.h"
#include "vandplan/files.h"
#include "vandplan/result_file.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

/// Plans the first goal and returns what would be in the file.
Json planned(const Scenario& scenario, const std::string& name) {
  const Planner planner = planner_named(name);
  ResultRecord record;
  record.scenario = scenario.name;
  record.planner = name;
  record.options.budget.max_iterations = 3000;
  set_option(record.options, planner, "region", "scene");
  record.result = plan(make_problem(scenario), planner, record.options);
  return Json::parse(results_to_json({scenario}, {record}));
}

/// A reader's own integration, from a start near the origin: the straight formulas for an arc.
Pose driven(Pose pose, const Json& segments, double radius) {
  for (const Json& segment : segments) {
    const double length = segment["length"];
    const std::string turn = segment["turn"];
    const double before = pose.heading;
    if (turn == "straight") {
      pose.x += length * std::cos(before);
      pose.y += length * std::sin(before);
    } else {
      const double signed_radius = turn == "left" ? radius : -radius;
      pose.heading += length / signed_radius;
      pose.x += signed_radius * (std::sin(pose.heading) - std::sin(before));
      pose.y -= signed_radius * (std::cos(pose.heading) - std::cos(before));
    }
  }
  return pose;
}

double angle_between(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

void expect_arrival(const Json& result, const Scenario& scenario, double spacing) {
  const Json& start = result["path"]["start"];
  EXPECT_EQ(start["x"], scenario.start.x);
  EXPECT_EQ(start["y"], scenario.start.y);
  EXPECT_EQ(start["heading"], scenario.start.heading);
  const Pose& goal = scenario.goal;
  const Pose end = driven({0, 0, scenario.start.heading}, result["path"]["segments"],
                          scenario.vehicle.min_turning_radius);
  EXPECT_NEAR(end.x, goal.x - scenario.start.x, 1e-6 + spacing);
  EXPECT_NEAR(end.y, goal.y - scenario.start.y, 1e-6 + spacing);
  EXPECT_LT(angle_between(end.heading, goal.heading), 1e-6);
  const Json& last = result["path"]["poses"].back();
  EXPECT_NEAR(last["x"].get<double>(), goal.x, 1e-6 + spacing);
  EXPECT_NEAR(last["y"].get<double>(), goal.y, 1e-6 + spacing);
  EXPECT_LT(angle_between(last["heading"], goal.heading), 1e-6);
}

TEST(WrittenPath, BeginsAtTheStartAndEndsAtTheGoal) {
  int solved = 0;
  for (const std::string& file : yaml_files(repository() / "scenarios" / "thesis")) {
    SCOPED_TRACE(file);
    const Scenario scenario = scenario_at(read_scenario_file(file), 0);
    const Json result = planned(scenario, "rrt-opt-euc-goal");
    if (result["status"] != "solved") continue;
    ++solved;
    expect_arrival(result, scenario, 0.0);
  }
  EXPECT_GE(solved, 7);
}

TEST(WrittenPath, IsTheSameFarAway) {
  const Scenario here =
      read_scenario((repository() / "scenarios" / "thesis" / "2-flat-obstacle.yaml").string());
  const Json near = planned(here, "rrt-opt-euc-goal");
  ASSERT_EQ(near["status"], "solved");
  for (const double distance : {-3.0, 4484378811.0, 1e10}) {
    SCOPED_TRACE(distance);
    const Scenario there = moved_by(here, distance, 1 - distance);
    const Json far = planned(there, "rrt-opt-euc-goal");
    EXPECT_EQ(far["path"]["segments"], near["path"]["segments"]);
    expect_arrival(far, there, 2 * std::abs(std::nextafter(distance, 0) - distance));
  }
}

TEST(WrittenPath, OfTheFarCaseIsThatOfTheNearOne) {
  const auto folder = shared_folder() / "scenarios" / "tpcap";
  if (yaml_files(folder).empty()) GTEST_SKIP() << "no shared scenarios beside the repository";
  const std::string planner(default_planner().name);
  const Json far = planned(read_scenario(folder / "case13.yaml"), planner);
  const Json near = planned(read_scenario(folder / "case13-local.yaml"), planner);
  ASSERT_EQ(far["status"], "solved");
  EXPECT_EQ(far["path"]["segments"], near["path"]["segments"]);
}

}  // namespace
}  // namespace vandplan
