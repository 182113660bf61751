// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Goals that are more than a pose, in scenario files and in results.
#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/result_file.h"

namespace vandplan {
namespace {

using std::numbers::pi;

std::string file_with(const std::string& goal, const std::string& vehicle = "two-axle-truck") {
  return "name: set\nvehicle: " + vehicle +
         "\nbounds: {x: [-50, 90], y: [-50, 50]}\nstart: {x: 0, y: 0, heading: 0}\ngoal: " + goal +
         "\nobstacles: []\n";
}

std::vector<GoalRegion> set_of(const std::string& goal,
                               const std::string& vehicle = "two-axle-truck") {
  return scenario_from_yaml(file_with(goal, vehicle), "s.yaml").scenario.goal_set;
}

std::string error_for(const std::string& goal, const std::string& vehicle = "two-axle-truck") {
  try {
    (void)set_of(goal, vehicle);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(GoalFile, ReadsWhatGoalsMayBe) {
  EXPECT_TRUE(set_of("{x: 1, y: 2, heading: 3}").empty());
  GoalRegion region = region_of_pose({1, 2, 0});
  region.heading = any_heading;
  EXPECT_EQ(set_of("{x: 1, y: 2, heading: any}"), std::vector{region});
  region = region_of_pose({1, 2, 0.5});
  region.either_way = true;
  EXPECT_EQ(set_of("{x: 1, y: 2, heading: 0.5, either_way: true}"), std::vector{region});
  region.either_way = false;
  EXPECT_EQ(set_of("{x: 1, y: 2, heading: 0.5, either_way: false}"), std::vector{region});
  region.heading = {1.4, 1.7};
  region.x = {44, 46};
  EXPECT_EQ(set_of("{x: [44, 46], y: 2, heading: [1.4, 1.7]}"), std::vector{region});
  GoalRegion dock = region_of_pose({1, 2, 0.5});
  dock.straight = 8;
  EXPECT_EQ(set_of("{x: 1, y: 2, heading: 0.5, straight: 8}"), std::vector{dock});
  region = {.area = {{40, 15}, {50, 15}, {50, 25}}, .heading = any_heading, .curvature = 0.1};
  EXPECT_EQ(set_of("{area: [[40, 15], [50, 15], [50, 25]], heading: any, curvature: 0.1}"),
            std::vector{region});
  const std::vector<GoalRegion> two = {region_of_pose({1, 2, 3}), region};
  EXPECT_EQ(set_of("{any_of: [{x: 1, y: 2, heading: 3}, {area: [[40, 15], [50, 15], [50, 25]], "
                   "heading: any, curvature: 0.1}]}"),
            two);
}

TEST(GoalFile, ReadsGoalsOfTrailers) {
  const std::string rig = "tractor-semitrailer";
  const double most = vehicle_named(rig).max_hitch_angle;
  GoalRegion region = region_of_pose({1, 2, 3});
  region.hitch_angle = {-most, most};
  EXPECT_EQ(set_of("{x: 1, y: 2, heading: 3, hitch_angles: any}", rig), std::vector{region});
  region.hitch_angle = {-0.1, 0.2};
  EXPECT_EQ(set_of("{x: 1, y: 2, heading: 3, hitch_angles: [[-0.1, 0.2]]}", rig),
            std::vector{region});
  region.is_of_trailer = true;
  region.heading = any_heading;
  EXPECT_EQ(set_of("{trailer: {x: 1, y: 2, heading: any}, hitch_angles: [[-0.1, 0.2]]}", rig),
            std::vector{region});
}

TEST(GoalFile, WritesWhatItReads) {
  for (const char* const goal :
       {"{x: 0.1, y: 2, heading: any}", "{x: [0.1, 0.3], y: [1, 2], heading: [3, -3]}",
        "{area: [[40, 15.125], [50, 15], [50, 25]], heading: 1, either_way: true}",
        "{any_of: [{x: 1, y: 2, heading: 3}]}", "{x: 1, y: 2, heading: 3, straight: 8.5}",
        "{any_of: [{x: 1, y: 2, heading: 3, curvature: 0.01}, {x: 5, y: 6, heading: any}]}"}) {
    const ScenarioFile read = scenario_from_yaml(file_with(goal), "s.yaml");
    const ScenarioFile again = scenario_from_yaml(to_yaml(read), "again.yaml");
    EXPECT_EQ(again.scenario.goal_set, read.scenario.goal_set) << to_yaml(read);
    EXPECT_FALSE(read.scenario.goal_set.empty());
  }
  const std::string goal =
      "{trailer: {x: 1, y: [2, 3], heading: 3, either_way: true}, hitch_angles: [[-0.1, 0.2]]}";
  const ScenarioFile read = scenario_from_yaml(file_with(goal, "tractor-semitrailer"), "s.yaml");
  EXPECT_EQ(scenario_from_yaml(to_yaml(read), "again.yaml").scenario.goal_set,
            read.scenario.goal_set);
}

// ---- What the path passes before the goal ----

std::vector<Via> via_of(const std::string& via) {
  const std::string text = file_with("{x: 40, y: 0, heading: 0}") + "via: " + via + "\n";
  const ScenarioFile read = scenario_from_yaml(text, "s.yaml");
  EXPECT_EQ(scenario_from_yaml(to_yaml(read), "again.yaml").scenario.via, read.scenario.via);
  return read.scenario.via;
}

std::string error_for_via(const std::string& via) {
  try {
    (void)via_of(via);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(GoalFile, ReadsWhatThePathPasses) {
  const GoalRegion pose = region_of_pose({10, 0, 0});
  GoalRegion any = region_of_pose({20, 5, 0});
  any.heading = any_heading;
  EXPECT_TRUE(via_of("[]").empty());
  const std::vector<Via> two = {{{pose}, false}, {{any}, true}};
  EXPECT_EQ(via_of("[{x: 10, y: 0, heading: 0}, {x: 20, y: 5, heading: any, stop: true}]"), two);
  const std::vector<Via> either = {{{pose, any}, true}};
  EXPECT_EQ(via_of("[{any_of: [{x: 10, y: 0, heading: 0}, {x: 20, y: 5, heading: any}], "
                   "stop: true}]"),
            either);
  EXPECT_EQ(error_for_via("[{x: 10, y: 0}]"),
            "s.yaml:7: via[0]: key \"heading\" is missing, expected it");
  EXPECT_EQ(error_for_via("[{x: 10, y: 0, heading: 0, stop: maybe}]"),
            "s.yaml:7: via[0].stop: is \"maybe\", expected true or false");
  EXPECT_EQ(error_for_via("[{x: 10, y: 0, heading: 0, straight: 8}]"),
            "s.yaml:7: via[0].straight: is given, expected it for goals alone");
  EXPECT_EQ(error_for_via("[{x: [3, 2], y: 0, heading: 0}]"),
            "s.yaml:7: via[0].x: is [3, 2], expected the smaller number first");
  EXPECT_EQ(error_for("{x: 1, y: 2, heading: any, stop: true}"),
            "s.yaml:5: goal.stop: is given, expected it for entries of via alone");
}

TEST(GoalFile, SaysWhatIsWrong) {
  EXPECT_EQ(error_for("{x: [3, 2], y: 2, heading: 0}"),
            "s.yaml:5: goal.x: is [3, 2], expected the smaller number first");
  EXPECT_EQ(error_for("{x: [3], y: 2, heading: 0}"),
            "s.yaml:5: goal.x: has 1 element, expected [smallest, largest]");
  EXPECT_EQ(error_for("{x: [3], y: 2, heading: any}"),
            "s.yaml:5: goal.x: has 1 element, expected [smallest, largest]");
  EXPECT_EQ(error_for("{x: 3, y: 2, heading: some, either_way: true}"),
            "s.yaml:5: goal.heading: is \"some\", expected a number");
  EXPECT_EQ(error_for("{x: 3, y: 2, heading: [0, 1, 2]}"),
            "s.yaml:5: goal.heading: has 3 elements, expected [first, last], counter-clockwise");
  EXPECT_EQ(error_for("{x: 3, y: 2, heading: [0, 7]}"),
            "s.yaml:5: goal.heading: spans 7 rad, expected at most a full turn: any");
  EXPECT_EQ(error_for("{x: 3, y: 2, heading: 0, either_way: maybe}"),
            "s.yaml:5: goal.either_way: is \"maybe\", expected true or false");
  EXPECT_EQ(error_for("{x: 3, y: 2, heading: 0, straight: -1}"),
            "s.yaml:5: goal.straight: is -1, expected 0 to 1000 [m]");
  EXPECT_EQ(error_for("{x: 3, y: 2, heading: 0, straight: 8, curvature: 0.1}"),
            "s.yaml:5: goal.curvature: is 0.1 beside straight, expected straight wheels");
  EXPECT_EQ(error_for("{x: 3, area: [[40, 15], [50, 15], [50, 25]], heading: 0}"),
            "s.yaml:5: goal.area: is given beside x, expected one of the two");
  EXPECT_EQ(error_for("{area: [[40, 15], [50, 15], [45, 20], [45, 10]], heading: 0}").substr(0, 19),
            "s.yaml:5: goal.area");
  EXPECT_EQ(error_for("{area: [[40, 15], [50, 15]], heading: 0}"),
            "s.yaml:5: goal.area: has 2 corners, expected at least 3");
  EXPECT_EQ(error_for("{area: [], heading: any}"),
            "s.yaml:5: goal.area: has 0 corners, expected at least 3");
  EXPECT_EQ(error_for("{any_of: []}"),
            "s.yaml:5: goal.any_of: is empty, expected at least one goal");
  EXPECT_EQ(error_for("{any_of: [{x: 1, y: 2, heading: 3}], x: 1}").substr(0, 31),
            "s.yaml:5: goal: unknown key \"x\"");
  EXPECT_EQ(error_for("{any_of: [{x: 1, y: 2, heading: 3}, {x: 1e9, y: 2, heading: 3}]}"),
            "s.yaml:5: goal.any_of[1]: is 1000000000 m from the start, expected at most 100000 m");
  EXPECT_EQ(error_for("{any_of: [{any_of: []}]}"),
            "s.yaml:5: goal.any_of[0].any_of: is given within any_of, expected one region");
  EXPECT_EQ(error_for("{x: 3, y: 2, heading: 0, strait: 8}"),
            "s.yaml:5: goal: unknown key \"strait\", did you mean straight? Expected one of x, y, "
            "area, heading, either_way, trailer, any_of, curvature, hitch_angles, straight, stop");
  EXPECT_EQ(error_for("{x: any, y: 2, heading: any}"),
            "s.yaml:5: goal.x: is \"any\", expected a number");
  EXPECT_EQ(error_for("{x: 1, y: 2, heading: any, hitch_angles: any}"),
            "s.yaml:5: goal.hitch_angles: are given without a trailer, expected trailers of the "
            "vehicle");
  EXPECT_EQ(error_for("{trailer: {x: 1, y: 2, heading: any}}").substr(0, 22),
            "s.yaml:5: goal.trailer");
  EXPECT_EQ(error_for("{x: 1, y: 2, heading: 0, hitch_angles: [[-2, 2]]}", "tractor-semitrailer")
                .substr(0, 27),
            "s.yaml:5: goal.hitch_angles");
  EXPECT_EQ(error_for("{x: 1, y: 2, heading: any, curvature: 3}").substr(0, 24),
            "s.yaml:5: goal.curvature");
}

TEST(GoalFile, WarnsOfDegrees) {
  const auto warnings_of = [](const std::string& goal) {
    return scenario_from_yaml(file_with(goal), "s.yaml").warnings.size();
  };
  EXPECT_EQ(warnings_of("{x: 1, y: 2, heading: any}"), 0U);
  EXPECT_EQ(warnings_of("{x: 1, y: 2, heading: [90, 91]}"), 1U);
  EXPECT_EQ(warnings_of("{any_of: [{x: 1, y: 2, heading: 90}, {x: 1, y: 2, heading: 1}]}"), 1U);
}

TEST(GoalFile, ResultsStateTheGoal) {
  const ScenarioFile file = scenario_from_yaml(
      file_with("{any_of: [{x: 60, y: 2, heading: 3}, {x: [20, 21], y: 2, heading: any}]}"),
      "s.yaml");
  const Problem problem = make_problem(file.scenario);
  PlanOptions options;
  options.budget.max_iterations = 500;
  const ResultRecord record{.scenario = "set",
                            .planner = default_planner().name,
                            .options = complete(default_planner(), options),
                            .result = plan(problem, options)};
  ASSERT_TRUE(record.result.goal);
  EXPECT_EQ(record.result.goal->index, 1U);
  const TemporaryFolder folder;
  const std::string text = results_to_json(file, {record});
  EXPECT_NE(text.find("\"goal\": {\"index\": 1, \"x\": "), std::string::npos)
      << text.substr(0, 500);
  const auto read = [&](const std::string& content) {
    return read_results(folder.put("r.json", content), file).front();
  };
  EXPECT_EQ(read(text).result.goal, record.result.goal);
  const auto is_valid = [&](const std::string& content) {
    const ResultRecord again = read(content);
    return check_path(problem, *again.result.path, again.claims).valid;
  };
  EXPECT_TRUE(is_valid(text));
  std::string other = text;
  other.replace(other.find("\"index\": 1"), 10, "\"index\": 0");
  EXPECT_FALSE(is_valid(other));
}

}  // namespace
}  // namespace vandplan
