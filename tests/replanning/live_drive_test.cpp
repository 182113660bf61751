// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/replanner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "replanning/sensor.h"
#include "support/place_of_error.h"
#include "support/problems.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"

namespace vandplan {
namespace {

Scenario yard() {
  Scenario scenario;
  scenario.bounds = {-20, 60, -20, 20};
  scenario.goal = {35, 0, 0};
  return scenario;
}

LiveDriveOptions with_margin(double margin) {
  LiveDriveOptions options;
  options.replan.plan.clearance.margin = margin;
  return options;
}

TEST(LiveDrive, Arrives) {
  const LiveDriveOptions options;
  const LiveDriveResult result = drive_live(yard(), options);
  EXPECT_TRUE(result.has_arrived);
  EXPECT_FALSE(result.contact);
  EXPECT_LT(result.end_distance, 0.03);
  EXPECT_LT(result.end_heading, 0.02);
  EXPECT_EQ(result.ticks_without_answer, 0);
  EXPECT_EQ(result.new_ways, 0);
  EXPECT_EQ(result.stops, 0);
  // 35 m at 2.5 m/s, gained and lost at 0.9 m/s^2.
  EXPECT_NEAR(result.duration, 35 / 2.5 + 2.5 / 0.9, 0.3);
}

TEST(LiveDrive, IsFarFromASetOfGoalsIfItStays) {
  Scenario scenario = yard();
  scenario.goal_set = {{.x = {35, 35}, .y = {0, 0}, .heading = {0, 0}},
                       {.x = {38, 38}, .y = {0, 0}, .heading = {0, 0}}};
  scenario.obstacles = {box(20, -20, 21, 20)};
  LiveDriveOptions options;
  options.longest = 1.0;
  const LiveDriveResult result = drive_live(scenario, options);
  EXPECT_FALSE(result.has_arrived);
  EXPECT_NEAR(result.end_distance, 35, 1e-6);
}

TEST(LiveDrive, LetsPassWhoIsForetold) {
  Scenario scenario = yard();
  scenario.moving = {
      {box(-1, -1, 3, 1), {{0, {18, -30, 1.5708}}, {16, {18, 30, 1.5708}}}, Afterwards::leaves}};
  const LiveDriveResult result = drive_live(scenario, with_margin(0.2));
  EXPECT_TRUE(result.has_arrived);
  EXPECT_FALSE(result.contact) << result.contact->what;
  EXPECT_GT(result.moving_clearance, 0.1);
  EXPECT_LT(result.moving_clearance, 20);
  EXPECT_EQ(result.ticks_without_answer, 0);
}

TEST(LiveDrive, SeesWhoIsHitThoughNobodyToldIt) {
  Scenario scenario = yard();
  scenario.moving = {
      {box(-1, -1, 3, 1), {{0, {18, -30, 1.5708}}, {16, {18, 30, 1.5708}}}, Afterwards::leaves}};
  LiveDriveOptions options = with_margin(0);
  options.sensor_range = 0.5;  // from its rear axle: it sees nobody
  const LiveDriveResult result = drive_live(scenario, options);
  ASSERT_TRUE(result.contact);
  EXPECT_EQ(result.contact->what, "the footprint hits moving[0]");
  EXPECT_GT(result.contact->t, 4);
  EXPECT_LT(result.contact->t, 9);
}

TEST(LiveDrive, GoesRoundWhatItSeesOnItsWay) {
  Scenario scenario = yard();
  scenario.obstacles = {box(20, -3, 22, 3)};
  LiveDriveOptions options = with_margin(0.2);
  options.sensor_range = 14;
  const LiveDriveResult result = drive_live(scenario, options);
  EXPECT_TRUE(result.has_arrived);
  EXPECT_FALSE(result.contact);
  EXPECT_GE(result.new_ways, 1);
  EXPECT_EQ(drive_live(scenario, with_margin(0.2)).new_ways, 0);  // whoever knows it all goes round
}

TEST(LiveDrive, StaysFreeWithNoiseAndDelay) {
  Scenario scenario = yard();
  scenario.obstacles = {box(15, 2.5, 20, 6), box(15, -6, 20, -2.5)};
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    LiveDriveOptions options = with_margin(0.4);
    options.drive.noise = 1;
    options.drive.delay = 0.1;
    options.drive.seed = seed;
    const LiveDriveResult result = drive_live(scenario, options);
    EXPECT_TRUE(result.has_arrived) << seed;
    EXPECT_FALSE(result.contact) << seed;
    EXPECT_LT(result.end_distance, 0.3) << seed;
  }
}

TEST(LiveDrive, RepeatsBitForBit) {
  Scenario scenario = yard();
  scenario.obstacles = {box(20, -3, 22, 3)};
  LiveDriveOptions options = with_margin(0.2);
  options.sensor_range = 14;
  options.drive.noise = 1;
  const LiveDriveResult a = drive_live(scenario, options);
  const LiveDriveResult b = drive_live(scenario, options);
  EXPECT_EQ(a.driven.path, b.driven.path);
}

TEST(LiveDrive, HandsOutActionsAtTheirRate) {
  LiveDriveOptions options = with_margin(0);
  options.action_rate = 20;
  std::vector<Action> actions;
  const LiveDriveResult result =
      drive_live(yard(), options, [&](const Action& action) { actions.push_back(action); });
  ASSERT_NEAR(static_cast<double>(actions.size()), 20 * result.duration, 2);
  for (std::size_t i = 0; i < actions.size(); ++i) {
    EXPECT_NEAR(actions[i].t, static_cast<double>(i) / 20, 1e-9);
  }
  EXPECT_NEAR(actions[20].v, 0.9, 1e-6);
}

TEST(LiveDrive, RefusesOptionsThatAreNone) {
  LiveDriveOptions options = with_margin(0);
  options.period = 0.03;
  EXPECT_THROW((void)drive_live(yard(), options), InputError);
}

LiveDriveOptions for_rig(double margin) {
  LiveDriveOptions options = with_margin(margin);
  options.replan.plan.budget.max_iterations = 2000;
  options.drive.spare_steering = 0.1;
  return options;
}

TEST(LiveDrive, GoesRoundWhatARigSeesOnItsWay) {
  Scenario scenario = yard();
  scenario.vehicle = semitrailer();
  scenario.bounds = {-40, 90, -25, 25};
  scenario.goal = {70, 0, 0};
  scenario.hitch_angles.start = 0.3;
  scenario.obstacles = {box(40, -3, 42, 3)};
  for (const double noise : {0.0, 1.0}) {
    LiveDriveOptions options = for_rig(0.3);
    options.sensor_range = 30;
    options.drive.noise = noise;
    options.drive.keep_log = true;
    const LiveDriveResult result = drive_live(scenario, options);
    EXPECT_TRUE(result.has_arrived) << noise;
    EXPECT_FALSE(result.contact) << noise << ": " << result.contact->what;
    EXPECT_GE(result.new_ways, 1) << noise;
    EXPECT_EQ(result.ticks_without_answer, 0) << noise;
    EXPECT_LT(result.end_distance, noise == 0.0 ? 0.1 : 0.4) << noise;
    ASSERT_TRUE(result.log.front().hitch_angle);
    EXPECT_NEAR(*result.log.front().hitch_angle, 0.3, 0.01);
    EXPECT_NEAR(*result.log.back().hitch_angle, 0.0, noise == 0.0 ? 0.02 : 0.1) << noise;
  }
}

TEST(LiveDrive, ReversesARigIntoADock) {
  LiveDriveOptions options = for_rig(0.05);
  options.replan.plan.budget.max_iterations = 6000;
  const LiveDriveResult result = drive_live(dock_for(semitrailer()), options);
  EXPECT_TRUE(result.has_arrived);
  EXPECT_FALSE(result.contact) << result.contact->what;
  EXPECT_EQ(result.ticks_without_answer, 0);
  EXPECT_LT(result.end_distance, 0.1);
}

TEST(LiveDrive, RefusesAControllerThatSteersNoTrailer) {
  Scenario scenario = yard();
  scenario.vehicle = semitrailer();
  LiveDriveOptions options = for_rig(0);
  options.drive.controller = "pure-pursuit";
  EXPECT_EQ(place_of_error([&] { (void)drive_live(scenario, options); }), "controller");
}

TEST(Sensor, SeesWhatARayMeetsAndNothingBehindIt) {
  Scenario scenario = yard();
  scenario.obstacles = {box(10, -9, 11, 9), box(14, -1, 15, 1), box(-15, 0, -14, 1)};
  replanning::Sensor sensor(scenario, 20);
  const WorldPatch first = sensor.look({0, 0, 0});
  ASSERT_EQ(first.added.size(), 2u);
  EXPECT_EQ(first.added[0].name, 0);
  EXPECT_EQ(first.added[1].name, 2);
  EXPECT_TRUE(sensor.look({0, 0, 0}).is_empty());
  EXPECT_EQ(sensor.look({12, 12, 0}).added.size(), 1u);
}

TEST(Sensor, RevealsCellsUpToTheFirstThatIsBlocked) {
  Scenario scenario = yard();
  scenario.map = OccupancyGrid{.origin = {0, -10, 0}, .resolution = 1, .columns = 20, .rows = 20};
  std::vector<Cell> cells(400, Cell::free);
  for (std::size_t row = 0; row < 20; ++row) cells[row * 20 + 10] = Cell::occupied;
  scenario.map->cells = cells;
  replanning::Sensor sensor(scenario, 30);
  const WorldPatch patch = sensor.look({2, 0, 0});
  ASSERT_EQ(patch.cells.size(), 1u);
  const CellPatch& seen = patch.cells.front();
  EXPECT_EQ(seen.column, 0);
  EXPECT_EQ(seen.column + seen.columns, 11);  // the wall, and nothing beyond it
  EXPECT_EQ(seen.cells[10], Cell::occupied);
  EXPECT_EQ(seen.cells[9], Cell::free);
}

TEST(Prediction, GoesOnAtTheSpeedThatWasSeen) {
  const std::vector<MovingObstacle> moving = {
      {box(-1, -1, 1, 1), {{0, {0, 0, 0}}, {10, {20, 0, 0}}, {20, {20, 20, 0}}}}};
  LiveDriveOptions options = with_margin(0);
  options.prediction = Prediction::constant_velocity;
  options.horizon = 4;
  const auto seen = replanning::predicted(moving, {}, 5, options);
  ASSERT_EQ(seen.size(), 1u);
  const std::vector<TimedPose> rows = {{5, {10, 0, 0}}, {9, {18, 0, 0}}};
  ASSERT_EQ(seen[0].trajectory.size(), 2u);
  EXPECT_NEAR(seen[0].trajectory[1].pose.x, 18, 1e-9);
  EXPECT_EQ(seen[0].trajectory[0], rows[0]);
  options.sensor_range = 9;
  EXPECT_TRUE(replanning::predicted(moving, {}, 5, options).empty());
}

}  // namespace
}  // namespace vandplan
