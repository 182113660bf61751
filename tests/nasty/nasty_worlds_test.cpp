// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// The library keeps its promises in worlds that nobody looked at.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "nasty/naive_drive.h"
#include "nasty/naive_judge.h"
#include "nasty/naive_zones.h"
#include "nasty/nasty_world.h"
#include "nasty/trial.h"
#include "support/cases.h"
#include "support/grids.h"
#include "support/problems.h"
#include "vandplan/collision.h"
#include "vandplan/vehicle.h"

namespace vandplan::nasty {
namespace {

constexpr int worlds = 250;
constexpr int worlds_of_rigs = 60;
constexpr int worlds_of_goals = 60;
constexpr int worlds_of_zones = 16;
constexpr int worlds_of_movers = 40;
constexpr int patient_worlds = 16;

/// What a share of the worlds brought, with a failure for each fault: `command` repeats it.
struct Share {
  int paths = 0;
  int refused = 0;

  Share(int share, int worlds_of_share, Trial (*try_one)(std::uint64_t),
        const std::string& command) {
    for (int i = 0; i < cases(worlds_of_share); ++i) {
      const int seed = share * worlds_of_share + i;
      const Trial trial = try_one(static_cast<std::uint64_t>(seed));
      paths += trial.paths;
      refused += trial.refused;
      for (const std::string& fault : trial.faults) {
        ADD_FAILURE() << fault << "    (" << command << ' ' << seed << " 1)";
      }
    }
  }
};

/// In shares, so that they can be tried side by side.
class NastyWorlds : public testing::TestWithParam<int> {};

TEST_P(NastyWorlds, KeepNoPromiseFromBeingKept) {
  const Share share(GetParam(), worlds, try_world, "nasty_worlds");
  EXPECT_GT(share.paths, cases(worlds) / 2);
  EXPECT_LE(share.refused, cases(worlds) / 10);
}

TEST_P(NastyWorlds, KeepNoPromiseToARigFromBeingKept) {
  const Share share(GetParam(), worlds_of_rigs, try_world_of_a_rig, "nasty_worlds --rigs");
  EXPECT_GE(share.paths, cases(worlds_of_rigs) / 10);
}

TEST_P(NastyWorlds, KeepNoPromiseToASetOfGoalsFromBeingKept) {
  const Share share(GetParam(), worlds_of_goals, try_world_of_goals, "nasty_worlds --goals");
  EXPECT_GE(share.paths, cases(worlds_of_goals) / 4);
}

TEST_P(NastyWorlds, KeepNoPromiseInZonesFromBeingKept) {
  const Share share(GetParam(), worlds_of_zones, try_world_of_zones, "nasty_worlds --zones");
  EXPECT_GE(share.paths, cases(worlds_of_zones) / 4);
}

TEST_P(NastyWorlds, KeepNoPromiseAmongMoversFromBeingKept) {
  const Share share(GetParam(), worlds_of_movers, try_world_of_movers, "nasty_worlds --movers");
  EXPECT_GE(share.paths, cases(worlds_of_movers) / 4);
}

TEST_P(NastyWorlds, KeepNoPromiseFromBeingKeptInTheLongRun) {
  const Share share(GetParam(), patient_worlds, try_world_patiently, "nasty_worlds --patient");
  EXPECT_GE(share.paths, cases(patient_worlds) / 2);
}

INSTANTIATE_TEST_SUITE_P(Share, NastyWorlds, testing::Range(0, 4));

// Wheels turn at a stop in a via though the vehicle stands there before, to change gear.
TEST(NastyWorlds, StandTwiceInAVia) {
  for (const std::string& fault : try_world_of_goals(503366).faults) ADD_FAILURE() << fault;
}

// Wheels turn at the stop of the second via, and both vias are where the path ends.
TEST(NastyWorlds, StandInTheViaWhereWheelsTurn) {
  for (const std::string& fault : try_world_of_goals(600136).faults) ADD_FAILURE() << fault;
}

// The last of three vias in one place is where wheels turn, not the place where the first one is.
TEST(NastyWorlds, StandOnceForTwoViasAroundAThird) {
  for (const std::string& fault : try_world_of_goals(964149).faults) ADD_FAILURE() << fault;
}

// A detour from the goal back must not turn the wheels where the vehicle rolls on.
TEST(NastyWorlds, RollIntoTheStraightEnd) {
  for (const std::string& fault : try_world_of_goals(501410).faults) ADD_FAILURE() << fault;
}

// The path ends in its via, and turns so tightly that the judge must look at shorter parts.
TEST(NastyWorlds, PassViasInTightTurns) {
  for (const std::string& fault : try_world_of_goals(907167).faults) ADD_FAILURE() << fault;
}

// A mask has cells that are crossed very slowly, and left quickly: the judge samples near both.
TEST(NastyWorlds, LeaveSlowCellsQuickly) {
  for (const std::string& fault : try_world_of_zones(5000205).faults) ADD_FAILURE() << fault;
}

// A detour begins with wheels that are turned further than continuous steering may.
TEST(NastyWorlds, WaitBesideTheWayOfASharpStart) {
  for (const std::string& fault : try_world_of_movers(2518).faults) ADD_FAILURE() << fault;
}

// A detour comes back at the very goal, where the wheels have to be turned.
TEST(NastyWorlds, ComeBackToAGoalWithTurnedWheels) {
  for (const std::string& fault : try_world_of_movers(20230).faults) ADD_FAILURE() << fault;
}

// A short path, where two rules for the sum of what is near were wrong by as much at a kink.
TEST(NastyWorlds, SumWhatIsNearAlikeOnAShortPath) {
  for (const std::string& fault : try_world(30020567).faults) ADD_FAILURE() << fault;
}

// ---- Does the second judge see anything? ----

/// Ten metres straight on, beside a wall that is `gap` [m] from the body.
Scenario along_a_wall(double gap) {
  Scenario scenario{.bounds = wide_bounds, .goal = {10, 0, 0}};
  const double side = scenario.vehicle.width / 2 + gap;
  scenario.obstacles = {box(-5, side, 20, side + 1)};
  return scenario;
}

const Path ten_metres{{}, {{.length = 10}}};

TEST(NaiveJudge, SeesWhatIsDeeperThanItsTolerance) {
  EXPECT_EQ(naive_flaw(along_a_wall(0), ten_metres), "");
  EXPECT_EQ(naive_flaw(along_a_wall(-0.9 * allowed_depth), ten_metres), "");
  EXPECT_NE(naive_flaw(along_a_wall(-1.1 * allowed_depth), ten_metres), "");
}

TEST(NaiveJudge, SeesNeedlesKerbsAndBodiesInsideOfThings) {
  Scenario scenario{.bounds = wide_bounds, .goal = {10, 0, 0}};
  scenario.obstacles = {{{8, -1e3}, {8, 1e3}, {8 + 1e-9, 0}}};
  EXPECT_NE(naive_flaw(scenario, ten_metres), "");
  scenario.obstacles.clear();
  scenario.kerbs = {box(15.5, -1, 16, 1)};  // under the front overhang at the end
  EXPECT_EQ(naive_flaw(scenario, ten_metres), "");
  scenario.kerbs = {box(14.4, -1, 16, 1)};  // under the wheels
  EXPECT_NE(naive_flaw(scenario, ten_metres), "");
  scenario.kerbs.clear();
  scenario.obstacles = {box(-100, -100, 100, 100)};
  EXPECT_NE(naive_flaw(scenario, ten_metres), "");
}

TEST(NaiveJudge, SeesPathsThatAreNone) {
  Scenario scenario{.bounds = wide_bounds, .goal = {10, 0, 0}};
  EXPECT_EQ(naive_flaw(scenario, ten_metres), "");
  EXPECT_NE(naive_flaw(scenario, {{1e-6, 0, 0}, ten_metres.segments}), "");
  EXPECT_NE(naive_flaw(scenario, {{}, {{.length = 10 + 3e-6}}}), "");
  EXPECT_NE(naive_flaw(scenario, {{}, {{.curvature = 1e-6, .length = 10}}}), "");
  scenario.bounds.x_max = 9.99;
  EXPECT_NE(naive_flaw(scenario, ten_metres), "");
  scenario.bounds.x_max = 11;
  scenario.vehicle.min_turning_radius = 100;
  const Path turn{{}, {{.curvature = 1 / 99.0, .length = 10}}};
  scenario.goal = end_pose(turn);
  EXPECT_NE(naive_flaw(scenario, turn), "");
}

TEST(NaiveJudge, SeesTheTrailer) {
  Scenario scenario{.bounds = wide_bounds};
  scenario.vehicle = Vehicle{3.6, 1.4, 0.9, 2.5, 6.0};
  scenario.vehicle.hitch = 0.5;
  scenario.vehicle.trailer = Trailer{7.7, 1.6, 4.3, 2.5};
  const Path turn{{}, {{.curvature = 1 / 6.5, .length = 9}}};
  scenario.goal = end_pose(turn);
  scenario.hitch_angles.goal = hitch_angle_after(scenario.vehicle, 0, turn.segments[0]);
  EXPECT_EQ(naive_flaw(scenario, turn), "");
  scenario.hitch_angles.goal += 1e-5;
  EXPECT_NE(naive_flaw(scenario, turn), "");
  scenario.hitch_angles.goal -= 1e-5;
  scenario.vehicle.max_hitch_angle = scenario.hitch_angles.goal - 1e-5;
  EXPECT_NE(naive_flaw(scenario, turn), "");
  scenario.vehicle.max_hitch_angle = 1.2;
  scenario.obstacles = {box(-3, 1.5, -2, 2)};  // where the trailer cuts the corner
  EXPECT_NE(naive_flaw(scenario, turn), "");
  scenario.vehicle.trailer.reset();
  EXPECT_EQ(naive_flaw(scenario, turn), "");
}

TEST(NaiveJudge, SeesCellsAndTheEndOfTheMap) {
  Scenario scenario{.bounds = wide_bounds, .goal = {10, 0, 0}};
  std::vector<Cell> cells(20 * 20, Cell::free);
  const auto map_of = [&] {
    return OccupancyGrid{.origin = {12, -6, 0.7},
                         .resolution = 2,
                         .columns = 20,
                         .rows = 20,
                         .cells = cells,
                         .unknown_is_free = true};
  };
  scenario.map = map_of();
  EXPECT_EQ(naive_flaw(scenario, ten_metres), "");
  cells.assign(cells.size(), Cell::occupied);
  scenario.map = map_of();
  EXPECT_NE(naive_flaw(scenario, ten_metres), "");
  cells.assign(cells.size(), Cell::free);
  scenario.map = map_of();
  scenario.map->unknown_is_free = false;  // the start lies outside
  EXPECT_NE(naive_flaw(scenario, ten_metres), "");
}

/// What is wrong with a drive of ten metres in ten seconds, if from time `begin` on somebody drives
/// across the way at x = 12, for 20 s.
std::string flaw_past(double begin, double margin, double inflate = 0.0) {
  Scenario scenario{.bounds = wide_bounds, .goal = {10, 0, 0}};
  const MovingObstacle across{.outline = box(-1, -1, 1, 1),
                              .trajectory = {{begin, {12, -20, 0}}, {begin + 20, {12, 20, 0}}},
                              .after = Afterwards::leaves,
                              .inflate = inflate};
  scenario.moving = {across};
  const SpeedProfile even{
      .knots = {{.v = 1}, {.t = 10, .s = 10}}, .stops = {}, .duration = 10, .standing = 0};
  return naive_flaw_of_drive(scenario, {ten_metres, even}, margin);
}

TEST(NaiveJudge, SeesWhoIsMet) {
  EXPECT_NE(flaw_past(0, 0), "");
  EXPECT_NE(flaw_past(30, 0), "") << "the vehicle stands in the way";
  EXPECT_EQ(flaw_past(-20, 0), "") << "the other is gone before";
  // The front is at x = 5.9 + t. The other is nearest when it has just passed: 2.7 m after 2.7 s.
  EXPECT_EQ(flaw_past(-9, 0), "");
  EXPECT_NE(flaw_past(-9, 3), "");
  EXPECT_NE(flaw_past(-9, 0, 1), "");
}

TEST(NaiveJudge, SeesTimesThatAreWrong) {
  Scenario scenario{.bounds = wide_bounds, .goal = {10, 0, 0}};
  const auto flaw_of = [&](const std::vector<SpeedKnot>& knots) {
    return naive_flaw_of_drive(
        scenario, {ten_metres, {.knots = knots, .stops = {}, .duration = 10, .standing = 0}}, 0);
  };
  EXPECT_EQ(flaw_of({{.v = 1}, {.t = 10, .s = 10}}), "");
  EXPECT_NE(flaw_of({{.v = 0.9}, {.t = 10, .s = 9}}), "");
  EXPECT_NE(flaw_of({{.v = 2}, {.t = 5, .s = 10, .v = -1}, {.t = 6, .s = 9, .v = 0.25}}), "");
}

/// Ten metres straight on, over a zone.
Scenario over(const Zone& zone) {
  Scenario scenario{.bounds = wide_bounds, .goal = {10, 0, 0}};
  scenario.zones = {zone};
  return scenario;
}

TEST(NaiveJudge, SeesRulesOfZonesThatAreBroken) {
  const Polygon area = box(4, -1, 5, 1);
  EXPECT_NE(naive_flaw(over({.area = area, .closed = true}), ten_metres), "");
  EXPECT_EQ(naive_flaw(over({.area = box(4, 1e-5, 5, 1), .closed = true}), ten_metres), "");
  EXPECT_NE(
      naive_flaw(over({.area = box(4, 1e-5, 5, 1), .closed = true, .body = true}), ten_metres), "");
  EXPECT_EQ(naive_flaw(over({.area = area, .gears = AllowedGears::forward}), ten_metres), "");
  EXPECT_NE(naive_flaw(over({.area = area, .gears = AllowedGears::reverse}), ten_metres), "");
  EXPECT_EQ(naive_flaw(over({.area = area, .direction = HeadingRange{0, 1}}), ten_metres), "");
  EXPECT_NE(naive_flaw(over({.area = area, .direction = HeadingRange{0.1, 1}}), ten_metres), "");
}

TEST(NaiveJudge, SumsThePricesOfZonesAndMasks) {
  Scenario scenario = over({.area = box(4, -1, 6, 1), .cost = 11});
  OccupancyGrid map = grid_of({"#."}, 2.0, {1, -1, 0});
  scenario.masks = {cost_mask(map, 4)};
  const ZoneLook look = naive_look_at_zones(scenario, ten_metres);
  EXPECT_NEAR(look.priced_length, 10 + 2 * 10 + 2 * 4, 0.05);
  scenario.zones[0].max_speed = 0.1;
  EXPECT_NEAR(naive_look_at_zones(scenario, ten_metres).least_duration, 20, 0.1);
}

TEST(NaiveJudge, DoubtsThePriceWhereABodyPassesWithinTheCheckersTolerance) {
  const double side = Vehicle{}.width / 2;
  const auto unsure_past = [&](double gap) {
    const Polygon area = box(4, side + gap, 5, side + 9);
    return naive_look_at_zones(over({.area = area, .cost = 11, .body = true}), ten_metres).unsure;
  };
  EXPECT_GT(unsure_past(0.9 * CollisionChecker::tolerance), 10);
  EXPECT_EQ(unsure_past(1.3 * CollisionChecker::tolerance), 0);
}

}  // namespace
}  // namespace vandplan::nasty
