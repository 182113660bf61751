// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What a recording holds. That others read it: read_back.
#include "vandplan/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "support/mcap_reader.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using Json = nlohmann::json;

Scenario yard_of_recording() {
  Scenario scenario;
  scenario.name = "yard";
  scenario.bounds = {-50, 50, -50, 50};
  scenario.start = {1, 2, 0.5};
  scenario.goal = {20, 0, 0};
  scenario.obstacles = {{{30, 0}, {32, 0}, {32, 3}}, {{-30, 0}, {-28, 0}, {-28, 3}}};
  return scenario;
}

/// Ten metres ahead and five back, with two improvements: the drive begins after 0.3 s.
PlanResult plan_of_recording(const Scenario& scenario) {
  PlanResult plan;
  plan.status = PlanStatus::solved;
  plan.path = Path{scenario.start, {{0.05, 10}, {0, -5}}};
  plan.anytime = {{0.1, 10, 40}, {0.25, 70, 15}};
  plan.lower_bound = 12;
  plan.time_total = 0.5;
  return plan;
}

/// Messages of a recording, with their JSON.
struct Recorded {
  std::vector<McapMessage> messages;

  [[nodiscard]] std::vector<Json> of(std::string_view topic) const {
    std::vector<Json> found;
    for (const McapMessage& message : messages) {
      if (message.topic == topic) found.push_back(Json::parse(message.data));
    }
    return found;
  }
  [[nodiscard]] std::set<std::string> topics() const {
    std::set<std::string> all;
    for (const McapMessage& message : messages) all.insert(message.topic);
    return all;
  }
  [[nodiscard]] std::vector<std::string> log() const {
    std::vector<std::string> texts;
    for (const Json& json : of("/log")) texts.push_back(json.at("message"));
    return texts;
  }
  /// The entity of that id in the first message of a topic.
  [[nodiscard]] Json entity(std::string_view topic, std::string_view id) const {
    const Json scene = of(topic).front();
    for (const Json& entity : scene.at("entities")) {
      if (entity.at("id") == id) return entity;
    }
    return nullptr;
  }
};

double seconds_of(const Json& message) {
  const Json& time = message.at("timestamp");
  return time.at("sec").get<double>() + 1e-9 * time.at("nsec").get<double>();
}

class RecordingTest : public testing::Test {
 protected:
  Recorded recorded(const Recording& recording) {
    record(file_, recording);
    return {mcap_messages(read_file(file_, 1 << 30))};
  }
  std::string message(const Recording& recording) {
    try {
      record(file_, recording);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  TemporaryFolder folder_;
  const std::string file_ = folder_ / "r.mcap";
  Scenario scenario_ = yard_of_recording();
};

TEST_F(RecordingTest, AScenarioAloneHasItsGround) {
  scenario_.kerbs = {{{0, -20}, {9, -20}, {9, -21}}};
  scenario_.inside = {{{-40, -40}, {40, -40}, {40, 40}, {-40, 40}}};
  const Recorded all = recorded({.scenario = &scenario_});
  EXPECT_EQ(all.topics(), (std::set<std::string>{"/ground", "/tf/site", "/vehicle"}));
  for (const McapMessage& message : all.messages) EXPECT_EQ(message.time, 0U);
  for (const char* const id : {"bounds", "obstacles[1]", "kerbs[0]", "inside[0]", "start", "goal"})
    EXPECT_FALSE(all.entity("/ground", id).is_null()) << id;
  const Json obstacle = all.entity("/ground", "obstacles[1]").at("triangles").at(0);
  EXPECT_EQ(obstacle.at("points").at(0), (Json{{"x", -30}, {"y", 0}, {"z", 0}}));
}

TEST_F(RecordingTest, APlanIsRecordedWithItsRunAndItsDrive) {
  const PlanResult plan = plan_of_recording(scenario_);
  const Recorded all = recorded({.scenario = &scenario_, .plan = &plan});
  EXPECT_EQ(all.topics(),
            (std::set<std::string>{"/cost", "/ground", "/improvement", "/log", "/motion", "/path",
                                   "/plan", "/pose", "/tf/site", "/tf/vehicle", "/vehicle"}));
  EXPECT_EQ(all.of("/improvement").at(1).at("cost"), 15);
  EXPECT_EQ(all.of("/improvement").at(1).at("time"), 0.25);
  EXPECT_DOUBLE_EQ(seconds_of(all.of("/improvement").at(1)), 0.2);
  EXPECT_EQ(all.of("/cost").at(1).at("entities").at(0).at("texts").at(0).at("text"),
            "cost 15.00 m");
  const std::vector<std::string> log = all.log();
  ASSERT_EQ(log.size(), 9U);
  EXPECT_EQ(log[2], "cost 15.00 m, iteration 70");
  EXPECT_EQ(log[3], "solved, lower bound 12.00 m");
  EXPECT_EQ(log[4], "drive begins forward");
  EXPECT_EQ(log[5], "stops after 10.00 m");
  EXPECT_EQ(log[6], "gear change, goes on in reverse");
  EXPECT_EQ(log[7], "stops after 15.00 m");
  EXPECT_TRUE(log.back().starts_with("arrives after "));

  const SpeedProfile speeds = speed_profile(*plan.path, scenario_.vehicle);
  const Json last = all.of("/motion").back();
  EXPECT_NEAR(seconds_of(last), 0.3 + speeds.duration, 1e-8);
  const Pose end = end_pose(*plan.path);
  EXPECT_NEAR(last.at("x"), end.x, 1e-9);
  EXPECT_EQ(last.at("direction"), -1);
  const std::vector<Json> motions = all.of("/motion");
  const Json& braking = motions[motions.size() - 2];
  EXPECT_LT(braking.at("v"), 0);
  EXPECT_LT(braking.at("wanted_acceleration"), 0);
  const Json transform = all.of("/tf/vehicle").back();
  EXPECT_EQ(transform.at("translation").at("y"), last.at("y"));
  EXPECT_NEAR(2 * std::asin(transform.at("rotation").at("z").get<double>()), end.heading, 1e-9);
  EXPECT_EQ(all.of("/pose").size(), all.of("/motion").size());
  // A line for each gear.
  EXPECT_EQ(all.of("/plan").front().at("entities").at(0).at("lines").size(), 2U);
}

TEST_F(RecordingTest, TimesNeverDecrease) {
  const PlanResult plan = plan_of_recording(scenario_);
  std::uint64_t before = 0;
  for (const McapMessage& message : recorded({.scenario = &scenario_, .plan = &plan}).messages) {
    EXPECT_GE(message.time, before);
    before = message.time;
  }
}

TEST_F(RecordingTest, ARunWithoutAPathSaysWhy) {
  PlanResult plan;
  plan.status = PlanStatus::goal_in_collision;
  plan.reason = "the footprint hits obstacles[0]";
  plan.hit = Hit{.kind = HitKind::obstacle, .index = 0};
  const Recorded all = recorded({.scenario = &scenario_, .plan = &plan});
  EXPECT_EQ(all.log().back(), "goal_in_collision: the footprint hits obstacles[0]");
  EXPECT_EQ(all.of("/log").back().at("level"), 4);
  const auto red = [&](const char* id) {
    return all.entity("/ground", id).at("triangles").at(0).at("color").at("r").get<double>();
  };
  EXPECT_GT(red("obstacles[0]"), red("obstacles[1]"));
  EXPECT_FALSE(all.topics().contains("/path"));
}

TEST_F(RecordingTest, ADriveHasItsMomentsItsEventsAndTheLineThatWasDriven) {
  const PlanResult plan = plan_of_recording(scenario_);
  const std::vector<DriveMoment> log = {{.t = 0, .pose = {1, 2, 0.5}},
                                        {.t = 0.02, .pose = {1.1, 2, 0.5}, .v = 1}};
  const Contact contact{.t = 0.01, .what = "the footprint hits \"x\"\n"};
  const Recorded all = recorded(
      {.scenario = &scenario_, .plan = &plan, .drive = RecordedDrive{log, false, contact}});
  EXPECT_FALSE(all.topics().contains("/improvement"));
  EXPECT_EQ(seconds_of(all.of("/path").front()), 0.0);
  EXPECT_EQ(all.of("/driven").front().at("entities").at(0).at("lines").at(0).at("points").size(),
            2U);
  EXPECT_EQ(all.of("/motion").size(), 2U);
  EXPECT_EQ(all.of("/motion").at(1).at("v"), 1);
  EXPECT_EQ(all.log(),
            (std::vector<std::string>{"drive begins forward", "contact: the footprint hits \"x\"\n",
                                      "does not arrive after 0.02 s"}));
  EXPECT_EQ(all.of("/log").at(2).at("level"), 3);
}

TEST_F(RecordingTest, ATrailerHasItsOwnFrame) {
  scenario_.vehicle.trailer = Trailer{};
  scenario_.hitch_angles.start = 0.3;
  const PlanResult plan = plan_of_recording(scenario_);
  const Recorded all = recorded({.scenario = &scenario_, .plan = &plan});
  EXPECT_FALSE(all.entity("/vehicle", "trailer").is_null());
  const double angle = sampled_hitch_angles(scenario_.vehicle, *plan.path, 0.3, 100).back();
  const Pose end = trailer_pose(scenario_.vehicle, {end_pose(*plan.path), angle});
  const Json last = all.of("/tf/trailer").back();
  EXPECT_EQ(last.at("parent_frame_id"), "site");
  EXPECT_NEAR(last.at("translation").at("x"), end.x, 1e-9);
  EXPECT_NEAR(last.at("translation").at("y"), end.y, 1e-9);
  EXPECT_EQ(all.of("/pose").back().at("poses").size(), 2U);
  const std::vector<Json> motions = all.of("/motion");
  EXPECT_NEAR(motions.front().at("hitch_angle"), 0.3, 1e-12);
  EXPECT_NEAR(motions.back().at("hitch_angle"), angle, 1e-9);
}

TEST_F(RecordingTest, WhatMovesMovesGrowsAndLeaves) {
  scenario_.moving = {{.outline = {{-1, -1}, {1, -1}, {0, 1}},
                       .trajectory = {{0, {10, 30, 0}}, {2, {14, 30, 0}}},
                       .after = Afterwards::leaves,
                       .inflate = 0.25}};
  const PlanResult plan = plan_of_recording(scenario_);
  const Recorded all = recorded({.scenario = &scenario_, .plan = &plan});
  const auto at = [&](double t) {  // t: since the drive began
    Json last;
    for (const Json& scene : all.of("/moving")) {
      if (!scene.at("entities").empty() && seconds_of(scene.at("entities").at(0)) > 0.3 + t + 1e-6)
        break;
      last = scene;
      if (scene.at("entities").empty()) break;
    }
    return last;
  };
  const Json entity = at(1.0).at("entities").at(0);
  EXPECT_EQ(entity.at("id"), "moving[0]");
  const Json position = entity.at("triangles").at(0).at("pose").at("position");
  EXPECT_NEAR(position.at("x"), 12.0, 0.05);
  EXPECT_NEAR(entity.at("lines").at(0).at("thickness"), 0.5, 0.02);
  EXPECT_EQ(all.of("/moving").back().at("deletions").at(0).at("id"), "moving[0]");
  EXPECT_TRUE(all.of("/moving").back().at("entities").empty());
}

TEST_F(RecordingTest, FarFromTheOriginValuesAreSmallAndTheFrameSaysWhere) {
  const PlanResult near = plan_of_recording(scenario_);
  const Recorded here = recorded({.scenario = &scenario_, .plan = &near});
  const Point far{674'000, 6'580'000};
  const auto move = [&](Pose& pose) { pose = {pose.x + far.x, pose.y + far.y, pose.heading}; };
  move(scenario_.start);
  move(scenario_.goal);
  scenario_.bounds = {far.x - 50, far.x + 50, far.y - 50, far.y + 50};
  for (Polygon& polygon : scenario_.obstacles) {
    for (Point& corner : polygon) corner = {corner.x + far.x, corner.y + far.y};
  }
  const PlanResult plan = plan_of_recording(scenario_);
  const Recorded there = recorded({.scenario = &scenario_, .plan = &plan});
  const Json frame = there.of("/tf/site").front();
  EXPECT_EQ(frame.at("parent_frame_id"), "map");
  EXPECT_EQ(frame.at("translation"), (Json{{"x", far.x}, {"y", far.y}, {"z", 0}}));
  EXPECT_EQ(there.of("/ground"), here.of("/ground"));
  ASSERT_EQ(there.messages.size(), here.messages.size());
  const Json at_end = there.of("/tf/vehicle").back().at("translation");
  EXPECT_NEAR(at_end.at("x"), here.of("/tf/vehicle").back().at("translation").at("x"), 1e-6);
}

TEST_F(RecordingTest, AMapIsAGridOfBytes) {
  // 0 free, 50 unknown, 100 occupied, in base64: 00 64 32 00 00 64.
  const std::vector<Cell> cells = {Cell::free, Cell::occupied, Cell::unknown,
                                   Cell::free, Cell::free,     Cell::occupied};
  scenario_.map = OccupancyGrid{.origin = {-20, -30, 0.5},
                                .resolution = 0.25,
                                .columns = 3,
                                .rows = 2,
                                .cells = std::make_shared<const std::vector<Cell>>(cells)};
  const Json grid = recorded({.scenario = &scenario_}).of("/map").front();
  EXPECT_EQ(grid.at("data"), "AGQyAABk");
  EXPECT_EQ(grid.at("column_count"), 3);
  EXPECT_EQ(grid.at("row_stride"), 3);
  EXPECT_EQ(grid.at("cell_size").at("x"), 0.25);
  EXPECT_EQ(grid.at("pose").at("position").at("x"), -20);
}

TEST_F(RecordingTest, ALargeMapHasBlocksThatShowTheirWorstCell) {
  std::vector<Cell> cells(5000 * 2, Cell::free);
  cells[3 + 5000] = Cell::occupied;
  cells[4] = Cell::unknown;
  scenario_.map = OccupancyGrid{.origin = {-20, -30, 0},
                                .resolution = 0.1,
                                .columns = 5000,
                                .rows = 2,
                                .cells = std::make_shared<const std::vector<Cell>>(cells)};
  const Json grid = recorded({.scenario = &scenario_}).of("/map").front();
  EXPECT_EQ(grid.at("column_count"), 1667);
  EXPECT_DOUBLE_EQ(grid.at("cell_size").at("x"), 0.1 * 3);
  EXPECT_TRUE(grid.at("data").get<std::string>().starts_with("AGQA"));  // 00 64 00
  EXPECT_EQ(grid.at("data").get<std::string>().size(), (1667 + 2) / 3 * 4);
}

TEST_F(RecordingTest, ATreeAndASetOfGoalsAreShown) {
  scenario_.goal_set = {region_of_pose({20, 0, 0}), {.x = {5, 9}, .y = {3, 4}}};
  PlanResult plan = plan_of_recording(scenario_);
  plan.tree = TreeSnapshot{.poses = {{1, 2, 0}, {5, 5, 0}, {6, 7, 0}}, .parents = {-1, 0, 1}};
  const Recorded all = recorded({.scenario = &scenario_, .plan = &plan});
  EXPECT_EQ(all.of("/tree").front().at("entities").at(0).at("lines").at(0).at("points").size(), 4U);
  EXPECT_FALSE(all.entity("/ground", "goal.any_of[0]").is_null());
  EXPECT_EQ(all.entity("/ground", "goal.any_of[1]").at("lines").at(0).at("points").size(), 4U);
}

TEST_F(RecordingTest, ViasAndZonesAreShownWhereTheyAre) {
  const Point far{674'000, 6'580'000};
  const auto at = [&](double x, double y) { return Point{far.x + x, far.y + y}; };
  scenario_.start = {far.x, far.y, 0};
  scenario_.goal = {far.x + 20, far.y, 0};
  scenario_.bounds = {far.x - 50, far.x + 50, far.y - 50, far.y + 50};
  scenario_.obstacles.clear();
  scenario_.zones = {{.area = {at(-9, -9), at(-5, -9), at(-5, -6)}, .closed = true}};
  const GoalRegion place = region_of_pose({far.x + 5, far.y + 3, 0});
  scenario_.via = {{.any_of = {place}}, {.any_of = {place, place}}};
  const Recorded all = recorded({.scenario = &scenario_});
  const Json corner = all.entity("/ground", "zones[0]").at("lines").at(0).at("points").at(0);
  EXPECT_EQ(corner.at("x"), -9);
  EXPECT_EQ(all.entity("/ground", "via[0]").at("lines").at(0).at("pose").at("position").at("x"), 5);
  EXPECT_FALSE(all.entity("/ground", "via[1].any_of[1]").is_null());
}

TEST_F(RecordingTest, NamesThatAreNoUtf8BecomeValidJson) {
  PlanResult plan;
  plan.status = PlanStatus::rejected;
  plan.reason = "\xff\x01";
  EXPECT_NE(recorded({.scenario = &scenario_, .plan = &plan}).log().back().find("\x01"),
            std::string::npos);
}

TEST_F(RecordingTest, EqualContentGivesEqualBytes) {
  const PlanResult plan = plan_of_recording(scenario_);
  record(file_, {.scenario = &scenario_, .plan = &plan});
  const std::string once = read_file(file_, 1 << 30);
  record(file_, {.scenario = &scenario_, .plan = &plan});
  EXPECT_EQ(read_file(file_, 1 << 30), once);
}

TEST_F(RecordingTest, TheClockIsSeenInTheTimesOfImprovementsAlone) {
  PlanResult plan = plan_of_recording(scenario_);
  const Recorded quick = recorded({.scenario = &scenario_, .plan = &plan});
  for (CostSample& sample : plan.anytime) sample.time *= 3;
  plan.time_total *= 3;
  const Recorded slow = recorded({.scenario = &scenario_, .plan = &plan});
  ASSERT_EQ(slow.messages.size(), quick.messages.size());
  for (std::size_t i = 0; i < slow.messages.size(); ++i) {
    const McapMessage& message = slow.messages[i];
    EXPECT_EQ(message.time, quick.messages[i].time);
    if (message.topic == "/improvement") continue;
    EXPECT_EQ(message.data, quick.messages[i].data);
  }
}

TEST_F(RecordingTest, WrongContentIsRefusedAndLeavesTheOldFile) {
  record(file_, {.scenario = &scenario_});
  const std::string old = read_file(file_, 1 << 30);
  EXPECT_EQ(message({}), "scenario: is null, expected a scenario");
  EXPECT_EQ(message({.scenario = &scenario_, .drive = RecordedDrive{}}),
            "drive: has no moments, expected its log");
  std::vector<DriveMoment> log = {{.t = 1}, {.t = 0.5}};
  EXPECT_EQ(message({.scenario = &scenario_, .drive = RecordedDrive{log}}),
            "drive: has times that decrease, or one below 0");
  log[1] = {.t = 2, .v = std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(message({.scenario = &scenario_, .drive = RecordedDrive{log}}),
            "drive: has a number that is not finite");
  PlanResult plan = plan_of_recording(scenario_);
  plan.path->segments[0].length = std::numeric_limits<double>::infinity();
  EXPECT_NE(message({.scenario = &scenario_, .plan = &plan}), "no error");
  plan = plan_of_recording(scenario_);
  plan.anytime[1].cost = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message({.scenario = &scenario_, .plan = &plan}),
            "plan: has a number that is not finite");
  EXPECT_EQ(read_file(file_, 1 << 30), old);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"r.mcap"});
  scenario_.vehicle.width = -1;
  EXPECT_TRUE(message({.scenario = &scenario_}).starts_with("vehicle.width: "));
}

}  // namespace
}  // namespace vandplan
