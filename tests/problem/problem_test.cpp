// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/problem.h"
#include "support/numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

Scenario yard() {
  return {.name = "yard",
          .description = "",
          .vehicle = {},
          .bounds = {-50.5, 50, -40, 40.25},
          .start = {10.7, -3.2, 0.5},
          .goal = {20, 5.5, -1},
          .obstacles = {{{0, 0}, {1, 0}, {1, 1}}}};
}

TEST(MakeProblem, MovesEverythingNextToTheStart) {
  const Problem problem = make_problem(yard());
  EXPECT_EQ(problem.start(), yard().start);
  EXPECT_EQ(problem.goal(), yard().goal);
  const World& world = *problem.world();
  EXPECT_EQ(world.origin(), (Point{11, -3}));
  EXPECT_EQ(problem.task().start, (Pose{-0.3, -0.2, 0.5}));
  EXPECT_EQ(problem.task().goal, (Pose{9, 8.5, -1}));
  EXPECT_EQ(world.local().bounds, (Bounds{-61.5, 39, -37, 43.25}));
  EXPECT_EQ(world.local().obstacles, (std::vector<Polygon>{{{-11, 3}, {-10, 3}, {-10, 4}}}));
}

TEST(MakeProblem, AScenarioFarAwayIsTheSameProblem) {
  const Problem here = make_problem(yard());
  for (const double distance : {4484378811.0, -8.7e9, 1e10, 1e12 - 100}) {
    SCOPED_TRACE(distance);
    const Scenario scenario = moved_by(yard(), distance, -std::round(distance / 2));
    const Problem there = make_problem(scenario);
    EXPECT_EQ(there.start(), scenario.start);
    EXPECT_EQ(there.goal(), scenario.goal);
    // A coordinate of at most 15 digits comes out exactly; yard() has two after the point.
    EXPECT_EQ(there.task().start, here.task().start);
    EXPECT_EQ(there.task().goal, here.task().goal);
    EXPECT_EQ(there.world()->local().bounds, here.world()->local().bounds);
    EXPECT_EQ(there.world()->local().obstacles, here.world()->local().obstacles);
    EXPECT_EQ(to_scenario(*there.world(), there.task().start), scenario.start);
  }
}

TEST(MakeProblem, WrapsHeadingsAndDropsRepeatedCorners) {
  Scenario scenario = yard();
  scenario.start.heading = 2 * std::numbers::pi + 0.5;
  scenario.obstacles = {{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 0}}};
  const Problem problem = make_problem(scenario);
  EXPECT_NEAR(problem.task().start.heading, 0.5, 1e-15);
  EXPECT_EQ(obstacles_of(problem).front().size(), 3U);
}

TEST(MakeProblem, APolygonOfOnePointStaysAnObstacle) {
  Scenario scenario = yard();
  scenario.obstacles = {{{20, 0}, {20, 0}, {20, 0}}};
  const Problem problem = make_problem(scenario);
  ASSERT_EQ(obstacles_of(problem).size(), 1U);
  const CollisionChecker& checker = *problem.task().checker;
  EXPECT_FALSE(checker.is_free(LocalPose({9.0, 3.0, 0.0})));  // (20, 0) in the yard
  EXPECT_TRUE(checker.is_free(LocalPose({9.0, 3.0 + 2.55 / 2 + 0.002, 0.0})));
}

TEST(MakeProblem, TheWheelsAreTurnedNoFurtherThanTheyCanBe) {
  Scenario scenario = yard();
  const double lock = 1 / scenario.vehicle.min_turning_radius;
  scenario.curvatures = {lock, -lock};
  EXPECT_EQ(make_problem(scenario).curvatures(), scenario.curvatures);
  EXPECT_EQ(make_problem(scenario).task().curvatures, scenario.curvatures);
  const auto place_of = [](const Scenario& spoilt) {
    try {
      check_scenario(spoilt);
      (void)make_problem(spoilt);
    } catch (const InputError& error) {
      return error.where();
    }
    return std::string("none");
  };
  for (const double curvature : {1.0001 * lock, -1.0001 * lock, std::nan("")}) {
    scenario.curvatures = {curvature, 0};
    EXPECT_EQ(place_of(scenario), "start.curvature");
    scenario.curvatures = {0, curvature};
    EXPECT_EQ(place_of(scenario), "goal.curvature");
  }
}

TEST(MakeProblem, CollisionAndBoundsAreForThePlannerToSay) {
  Scenario scenario = yard();
  scenario.start = {0.5, 0.2, 0};  // in the obstacle
  scenario.goal.x = 1000;          // outside the bounds
  EXPECT_NO_THROW((void)make_problem(scenario));
}

TEST(ToLocal, IsUndoneByToScenario) {
  for_each_case(1, 20'000, [](Rng& rng) {
    Scenario scenario = yard();
    scenario.obstacles = {};  // too far away, most of the time
    const double size = std::pow(10.0, uniform(-2, 11.9, rng));
    scenario.start = uniform_pose({-size, size, -size, size}, rng);
    scenario.goal = scenario.start;
    const Problem problem = make_problem(scenario);
    const LocalPose& local = problem.task().start;
    ASSERT_EQ(to_scenario(*problem.world(), local), scenario.start) << as_code(scenario.start);
    ASSERT_EQ(to_local(*problem.world(), scenario.start), local) << as_code(scenario.start);
  });
}

TEST(MakeProblem, CutsBoundsToAMillionMetresAroundTheStart) {
  Scenario scenario = yard();
  scenario.start = {3e9, -7, 0};
  scenario.goal = scenario.start;
  scenario.obstacles = {};
  scenario.bounds = {-1e12, 3e9 + 5, -1e12, 1e12};
  const Bounds bounds = make_problem(scenario).world()->local().bounds;
  EXPECT_EQ(bounds, (Bounds{-1e6, 5, -1e6, 1e6}));
  scenario.bounds = {0, 1, -1e12, 1e12};  // far from the start: nothing is left but a border
  const Problem nowhere = make_problem(scenario);
  EXPECT_FALSE(nowhere.task().checker->is_free(nowhere.task().start));
}

std::string fault_of(const Scenario& scenario) {
  try {
    (void)make_problem(scenario);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(MakeProblem, NamesWhatIsFurtherThanAMillionMetresFromTheStart) {
  Scenario scenario = yard();
  scenario.obstacles.push_back({{0, 0}, {1, 0}, {1, -1e6}});
  scenario.start = {0, 0, 0};
  EXPECT_NO_THROW((void)make_problem(scenario));
  scenario.obstacles.back()[2].y = -1000001;
  EXPECT_EQ(fault_of(scenario),
            "obstacles[1]: has a corner 1000001 m from the start, expected at most 1e+06 m along "
            "each axis");
  scenario.obstacles.pop_back();
  scenario.map = OccupancyGrid{.origin = {6e5, 0, 0}, .resolution = 3e5, .columns = 2, .rows = 1};
  scenario.map->cells = std::vector<Cell>(2);
  EXPECT_EQ(fault_of(scenario),
            "map: has a corner 1200000 m from the start, expected at most 1e+06 m along each axis");
}

TEST(SamplingRegion, SceneIsWhatThereIsPlusTwentyMetresCutToTheBounds) {
  const Problem problem = make_problem(yard());
  const Task& task = problem.task();
  EXPECT_EQ(sampling_region(task, Region::bounds), task.world->local().bounds);
  // In the scenario's frame x: 0 .. 20, y: -3.2 .. 5.5; the origin is (11, -3).
  const Bounds scene = sampling_region(task, Region::scene);
  EXPECT_DOUBLE_EQ(scene.x_min, -31);
  EXPECT_DOUBLE_EQ(scene.x_max, 29);
  EXPECT_DOUBLE_EQ(scene.y_min, -20.2);
  EXPECT_DOUBLE_EQ(scene.y_max, 28.5);
  Scenario narrow = yard();
  narrow.bounds = {-5, 15, -4, 7};
  const Problem cut = make_problem(narrow);
  EXPECT_EQ(sampling_region(cut.task(), Region::scene), cut.world()->local().bounds);
}

struct BadScenario {
  std::function<void(Scenario&)> spoil;
  std::string message;
};

const BadScenario bad_scenarios[] = {
    {[](Scenario& s) { s.vehicle.wheelbase = 0; },
     "vehicle.wheelbase: is 0, expected more than 0 m"},
    {[](Scenario& s) { s.vehicle.width = -2.5; }, "vehicle.width: is -2.5, expected more than 0 m"},
    {[](Scenario& s) { s.vehicle.width = nan; }, "vehicle.width: is nan, expected more than 0 m"},
    {[](Scenario& s) { s.vehicle.min_turning_radius = 1e-300; },
     "vehicle.min_turning_radius: is 1e-300, expected at least 1e-06 m"},
    {[](Scenario& s) { s.vehicle.min_turning_radius = infinity; },
     "vehicle.min_turning_radius: is inf, expected a number between -1e+06 and 1e+06"},
    {[](Scenario& s) { s.vehicle.front_overhang = -1; },
     "vehicle.front_overhang: is -1, expected 0 m or more"},
    {[](Scenario& s) { s.vehicle.rear_overhang = nan; },
     "vehicle.rear_overhang: is nan, expected 0 m or more"},
    {[](Scenario& s) { s.bounds.x_min = 60; },
     "bounds.x: is [60, 50], expected the smaller number first"},
    {[](Scenario& s) { s.bounds.y_max = -40; },
     "bounds.y: is [-40, -40], expected the smaller number first"},
    {[](Scenario& s) { s.bounds.y_max = infinity; },
     "bounds.y: is inf, expected a number between -1e+12 and 1e+12"},
    {[](Scenario& s) { s.start.x = nan; },
     "start.x: is nan, expected a number between -1e+12 and 1e+12"},
    {[](Scenario& s) { s.start.y = 1e13; },
     "start.y: is 1e+13, expected a number between -1e+12 and 1e+12"},
    {[](Scenario& s) { s.goal.heading = infinity; },
     "goal.heading: is inf, expected a number between -1e+06 and 1e+06"},
    {[](Scenario& s) {
       s.obstacles.push_back({{0, 0}, {1, 1}});
     },
     "obstacles[1]: has 2 corners, expected at least 3"},
    {[](Scenario& s) { s.obstacles[0][1].y = nan; },
     "obstacles[0]: is nan, expected a number between -1e+12 and 1e+12"},
    {[](Scenario& s) {
       s.obstacles[0] = {{0, 0}, {1, 1}, {2, 2}};
     },
     "obstacles[0]: has no area, expected corners that are not on one line"},
    {[](Scenario& s) {
       s.obstacles[0] = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
     },
     "obstacles[0]: crosses or touches itself where the sides that begin at [0, 0] and [1, 0] "
     "meet, expected a simple polygon"},
    {[](Scenario& s) { s.goal.x = s.start.x + 3e5; },
     "goal: is 300000 m from the start, expected at most 100000 m"},
};

TEST(CheckScenario, NamesTheKeyThatIsWrong) {
  for (const BadScenario& bad : bad_scenarios) {
    SCOPED_TRACE(bad.message);
    Scenario scenario = yard();
    bad.spoil(scenario);
    try {
      check_scenario(scenario);
      ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), bad.message);
    }
    try {
      (void)make_problem(scenario);
      ADD_FAILURE() << "no error";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), bad.message);
    }
  }
}

TEST(World, ChecksWhatItIsGiven) {
  const auto made = [](const Bounds& bounds, const Polygon& obstacle) {
    return world_of({.bounds = bounds, .obstacles = {obstacle}});
  };
  const Polygon triangle = {{0, 0}, {0, 1}, {1, 0}};
  const Bounds square{-1, 1, -1, 1};
  EXPECT_THROW((void)made({1, -1, -1, 1}, triangle), InputError);
  EXPECT_THROW((void)made(square, {{0, 0}, {nan, 1}, {1, 0}}), InputError);
  EXPECT_THROW((void)made(square, {{0, 0}, {0, 1}}), InputError);
  EXPECT_THROW((void)made(square, triangle)->checker({.width = 0}), InputError);
  EXPECT_NO_THROW((void)made(square, triangle)->checker({}));
}

TEST(InputError, StaysOneLine) {
  EXPECT_STREQ(InputError("a\nb", "is \"\r\x1b\"").what(), "a?b: is \"??\"");
}

}  // namespace
}  // namespace vandplan
