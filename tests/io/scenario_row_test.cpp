// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What is a row of goals, and which problems does it state?

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "support/problems.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

ScenarioFile one_goal() {
  ScenarioFile file;
  file.scenario.name = "yard";
  file.scenario.bounds = {-50.5, 50, -40, 40.25};
  file.scenario.start = {10.7, -3.2, 0.5};
  file.scenario.goal = {20, 0, 0};
  file.scenario.curvatures.start = 0.1;
  file.scenario.obstacles = {{{0, 0}, {1, 0}, {1, 1}}};
  return file;
}

ScenarioFile row_of_three() {
  ScenarioFile file = one_goal();
  file.row = {{20.0, {20, 0, 0}, {}},
              {40.0, {40, 0, 0}, {{{5, 5}, {6, 5}, {6, 6}}}, -0.05},
              {60.0, {45, 0, 0}, {}, 0.125}};
  return file;
}

TEST(ScenarioRow, OneGoalIsNoRow) {
  EXPECT_FALSE(one_goal().is_row());
  EXPECT_EQ(one_goal().size(), 1U);
  EXPECT_EQ(make_problems(one_goal()).size(), 1U);
  EXPECT_TRUE(row_of_three().is_row());
  EXPECT_EQ(row_of_three().size(), 3U);
}

TEST(ScenarioRow, EachGoalIsAScenarioOfItsOwn) {
  EXPECT_EQ(scenario_at(row_of_three(), 0).obstacles.size(), 1U);
  const Scenario second = scenario_at(row_of_three(), 1);
  EXPECT_EQ(second.goal, (Pose{40, 0, 0}));
  EXPECT_EQ(second.curvatures, (EndCurvatures{0.1, -0.05}));
  EXPECT_EQ(second.obstacles,
            (std::vector<Polygon>{{{0, 0}, {1, 0}, {1, 1}}, {{5, 5}, {6, 5}, {6, 6}}}));
}

TEST(ScenarioRow, GoalsWithoutObstaclesOfTheirOwnShareAWorld) {
  const std::vector<Problem> problems = make_problems(row_of_three());
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_EQ(problems[0].world(), problems[2].world());
  EXPECT_NE(problems[0].world(), problems[1].world());
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const Problem alone = make_problem(scenario_at(row_of_three(), i));
    EXPECT_EQ(problems[i].start(), alone.start());
    EXPECT_EQ(problems[i].goal(), alone.goal());
    EXPECT_EQ(problems[i].curvatures(), (EndCurvatures{0.1, row_of_three().row[i].curvature}));
    EXPECT_EQ(alone.curvatures(), problems[i].curvatures());
    EXPECT_EQ(problems[i].task().start, alone.task().start);
    EXPECT_EQ(problems[i].task().goal, alone.task().goal);
    EXPECT_EQ(problems[i].world()->local().bounds, alone.world()->local().bounds);
    EXPECT_EQ(obstacles_of(problems[i]), obstacles_of(alone));
  }
}

struct BadRow {
  std::function<void(ScenarioFile&)> spoil;
  std::string message;
};

const BadRow bad_rows[] = {
    {[](ScenarioFile& file) { file.row[1].goal.x = std::numeric_limits<double>::quiet_NaN(); },
     "goals[1].goal.x: is nan, expected a number between -1e+12 and 1e+12"},
    {[](ScenarioFile& file) { file.row[2].curvature = -0.2; },
     "goals[2].goal.curvature: is -0.2, expected at most 1 / min_turning_radius, "
     "0.14285714285714285 [1/m]"},
    {[](ScenarioFile& file) { file.row[1].distance = -1; },
     "goals[1].distance: is -1, expected 0 m or more"},
    {[](ScenarioFile& file) { file.row[1].obstacles[0].pop_back(); },
     "goals[1].obstacles[0]: has 2 corners, expected at least 3"}};

TEST(ScenarioRow, AGoalThatIsNotThereIsRefused) {
  EXPECT_NO_THROW((void)scenario_at(row_of_three(), row_of_three().size() - 1));
  EXPECT_THROW((void)scenario_at(row_of_three(), row_of_three().size()), InputError);
}

TEST(ScenarioRow, ErrorsNameTheGoal) {
  for (const auto& [spoil, message] : bad_rows) {
    SCOPED_TRACE(message);
    ScenarioFile file = row_of_three();
    spoil(file);
    try {
      (void)make_problems(file);
      ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), message);
    }
  }
}

}  // namespace
}  // namespace vandplan
