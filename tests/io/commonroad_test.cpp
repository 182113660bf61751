// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Scenarios and solutions of CommonRoad.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <pugixml.hpp>
#include <string>

#include "support/reader_test.h"
#include "support/shared_files.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using std::numbers::pi;

std::string street_example() {
  return read_file((repository() / "examples" / "street.xml").string(), 1 << 20);
}

class CommonRoad : public ReaderTest {
 protected:
  CommonRoadCase one(const std::string& text) { return {.file = folder_.put("a.xml", text)}; }
  RoadScenario read(const std::string& text) { return read_commonroad(one(text)); }
  Scenario with(const std::string& part, const std::string& by) {
    return read(exchanged(street_example(), part, by)).file.scenario;
  }
  std::string message(const std::string& part, const std::string& by) {
    return message_of([&] { return read(exchanged(street_example(), part, by)); });
  }
};

TEST_F(CommonRoad, AStreetBecomesAScenario) {
  const RoadScenario made = read(street_example());
  const Scenario& scenario = made.file.scenario;
  EXPECT_EQ(scenario.name, "ZAM_Street-1_1_T-1");
  EXPECT_EQ(scenario.start, (Pose{6, -2, 0}));
  EXPECT_EQ(scenario.bounds, (Bounds{-20, 100, -24, 24}));
  ASSERT_EQ(scenario.goal_set.size(), 1U);
  EXPECT_EQ(scenario.goal_set[0].area, (Polygon{{63, -3}, {73, -3}, {73, -1}, {63, -1}}));
  EXPECT_EQ(scenario.goal_set[0].heading, (HeadingRange{-0.2, 0.2}));
  EXPECT_EQ(scenario.obstacles.size(), 1U + 6);  // Two lanes have six walls.
  EXPECT_EQ(scenario.obstacles[0],
            (Polygon{{37.75, -3.4}, {42.25, -3.4}, {42.25, -1.6}, {37.75, -1.6}}));
  EXPECT_TRUE(scenario.zones.empty());  // Both lanes are for both directions.
  ASSERT_EQ(scenario.moving.size(), 1U);
  EXPECT_EQ(scenario.moving[0].outline,
            (Polygon{{-2.25, -0.9}, {2.25, -0.9}, {2.25, 0.9}, {-2.25, 0.9}}));
  EXPECT_EQ(
      scenario.moving[0].trajectory,
      (std::vector<TimedPose>{{0, {75, 2, 3.1416}}, {4, {55, 2, 3.1416}}, {12, {5, 2, 3.1416}}}));
  EXPECT_EQ(scenario.moving[0].after, Afterwards::leaves);
  EXPECT_NEAR(scenario.vehicle.wheelbase, 2.5789, 1e-4);  // A BMW 320i.
  EXPECT_NEAR(
      scenario.vehicle.front_overhang + scenario.vehicle.rear_overhang + scenario.vehicle.wheelbase,
      4.508, 1e-9);
  EXPECT_EQ(made.file.warnings,
            std::vector<std::string>{
                "left out: times and speeds of goals; a drive ends where it stands"});
  EXPECT_EQ(made.notes, std::vector<std::string>{"lanes: 2, areas: 0, zones: 0"});
}

TEST_F(CommonRoad, LaneletsAreOneWayUnlessVehiclesDriveBothWays) {
  const std::string both = "<userBidirectional>vehicle</userBidirectional>";
  const Scenario scenario = with(both, "");
  ASSERT_EQ(scenario.zones.size(), 1U);
  EXPECT_EQ(scenario.zones[0].name, "lanelet 1");
  EXPECT_EQ(scenario.zones[0].direction, (HeadingRange{-1.5708, 1.5708}));
  EXPECT_EQ(with(both, "<userBidirectional>bicycle</userBidirectional>").zones.size(), 1U);
  CommonRoadCase given = one(exchanged(street_example(), both, ""));
  given.rules = {.both_ways = true, .open_edges = true};
  given.vehicle = vehicle_named("van");
  const Scenario open = read_commonroad(given).file.scenario;
  EXPECT_TRUE(open.zones.empty());
  EXPECT_EQ(open.obstacles.size(), 1U);
  EXPECT_EQ(open.vehicle, vehicle_named("van"));
  EXPECT_EQ(message("urban", "sidewalk"),
            "a.xml:43: initialState: start is at 6, -2, beside all lanes and areas, expected a "
            "place on one of them");
}

TEST_F(CommonRoad, SpeedLimitsAreOfLaneletsOrSigns) {
  const std::string both =
      "<userBidirectional>vehicle</userBidirectional>\n  </lanelet>\n  <static";
  const std::string signs =
      "<trafficSign id=\"8\"><trafficSignElement><trafficSignID>274</trafficSignID>"
      "<additionalValue>13.5</additionalValue></trafficSignElement></trafficSign>"
      "<trafficSign id=\"9\"><trafficSignElement><trafficSignID>206</trafficSignID>"
      "</trafficSignElement></trafficSign><intersection id=\"7\"/></commonRoad>";
  const RoadScenario made = read(exchanged(
      exchanged(street_example(), "</commonRoad>", signs), both,
      "<userBidirectional>vehicle</userBidirectional><trafficSignRef ref=\"9\"/><trafficSignRef "
      "ref=\"8\"/><stopLine/></lanelet><static"));
  ASSERT_EQ(made.file.scenario.zones.size(), 1U);
  EXPECT_EQ(made.file.scenario.zones[0].name, "lanelet 2");
  EXPECT_EQ(made.file.scenario.zones[0].max_speed, 13.5);
  EXPECT_EQ(made.file.scenario.zones[0].direction, std::nullopt);
  EXPECT_EQ(made.file.warnings.back(),
            "left out: intersection (1), stopLine (1), trafficSign 206 (1)");
  const std::string urban = "<laneletType>urban</laneletType>";
  EXPECT_EQ(with(urban, urban + "<speedLimit>8</speedLimit>").zones[0].max_speed, 8);
  EXPECT_EQ(message(urban, urban + "<speedLimit>0</speedLimit>"),
            "a.xml:13: speedLimit: is 0, expected a speed limit of more than 0 m/s");
  EXPECT_EQ(message(urban, urban + "<trafficSignRef ref=\"8\"/>"),
            "a.xml:13: trafficSignRef: has a ref to no trafficSign of the file");
}

TEST_F(CommonRoad, GoalsHaveAllKindsOfPlaces) {
  const std::string place =
      "<rectangle><length>10</length><width>2</width><center><x>68</x><y>-2</y></center></"
      "rectangle>";
  const auto goals = [&](const std::string& by) { return with(place, by).goal_set; };
  const std::vector<GoalRegion> two =
      goals("<point><x>60</x><y>-2</y></point><lanelet ref=\"2\"/>");
  ASSERT_EQ(two.size(), 2U);
  EXPECT_TRUE(two[0].area.empty());
  EXPECT_EQ(two[0].x, (Interval{60, 60}));
  EXPECT_EQ(two[0].y, (Interval{-2, -2}));
  EXPECT_EQ(two[1].area, (Polygon{{80, 0}, {0, 0}, {0, 4}, {80, 4}}));
  EXPECT_EQ(two[1].heading, (HeadingRange{-0.2, 0.2}));
  // A circle's corners are within it, those of an obstacle around it.
  const std::string circle =
      "<circle><radius>2</radius><center><x>60</x><y>-2</y></center></circle>";
  const Polygon within = goals(circle)[0].area;
  for (const Point& corner : within) {
    EXPECT_NEAR(std::hypot(corner.x - 60, corner.y + 2), 2, 1e-9);
  }
  const std::string box = "<rectangle><length>4.5</length><width>1.8</width></rectangle>";
  const Polygon round = with(box, "<circle><radius>1</radius></circle>").obstacles[0];
  for (std::size_t i = 0; i < round.size(); ++i) {
    const Point& a = round[i];
    const Point& b = round[(i + 1) % round.size()];
    EXPECT_NEAR(std::hypot((a.x + b.x) / 2 - 40, (a.y + b.y) / 2 + 2.5), 1, 1e-9);
  }
  const Scenario any_heading_at_all = with(
      "<orientation><intervalStart>-0.2</intervalStart><intervalEnd>0.2</intervalEnd></"
      "orientation>",
      "");
  EXPECT_EQ(any_heading_at_all.goal_set[0].heading, any_heading);
}

TEST_F(CommonRoad, TimesCountFromTheStartOfTheVehicle) {
  const std::string text =
      exchanged(street_example(), "<exact>0</exact></time><velocity><exact>0</exact></velocity>",
                "<exact>10</exact></time><velocity><exact>3</exact></velocity>");
  const RoadScenario made = read(text);
  EXPECT_DOUBLE_EQ(made.file.scenario.moving[0].trajectory[1].t, 3);
  EXPECT_EQ(made.file.warnings[1],
            "left out: the initial velocity of 3 m/s; a drive starts from rest");
}

TEST_F(CommonRoad, ObstaclesOf2018AreRead) {
  const std::string role = "<obstacle id=\"3\"><role>static</role>";
  std::string text = exchanged(street_example(), "<staticObstacle id=\"3\">", role);
  text = exchanged(text, "</staticObstacle>", "</obstacle>");
  text = exchanged(text, "<dynamicObstacle id=\"4\">", "<obstacle id=\"4\"><role>dynamic</role>");
  text = exchanged(text, "</dynamicObstacle>", "</obstacle>");
  const Scenario scenario = read(text).file.scenario;
  EXPECT_EQ(scenario.obstacles, read(street_example()).file.scenario.obstacles);
  EXPECT_EQ(scenario.moving, read(street_example()).file.scenario.moving);
}

TEST_F(CommonRoad, WhatIsWrongHasOneLine) {
  EXPECT_EQ(message_of([&] { return read("<xml/>"); }),
            "a.xml:1: xml: is the root, expected a scenario of CommonRoad with the root "
            "commonRoad");
  EXPECT_EQ(message("timeStepSize=\"0.1\"", ""),
            "a.xml:3: commonRoad: has no attribute timeStepSize, expected one");
  EXPECT_EQ(message("timeStepSize=\"0.1\"", "timeStepSize=\"0\""),
            "a.xml:3: commonRoad: has timeStepSize 0, expected more than 0 s");
  EXPECT_EQ(message("<planningProblem id=\"5\">", "<planningProblem>"),
            "a.xml:42: planningProblem: has no attribute id, expected one");
  EXPECT_EQ(message("</commonRoad>", "<planningProblem id=\"6\"/></commonRoad>"),
            "a.xml:3: commonRoad: has planning problems 5, 6, expected --problem with one of "
            "these");
  EXPECT_EQ(message("<length>4.5</length>", "<length>0</length>"),
            "a.xml:30: length: is 0, expected more than 0 m");
  EXPECT_EQ(message("<length>4.5</length>", ""),
            "a.xml:30: rectangle: has no length, expected one");
  EXPECT_EQ(message("<rectangle><length>4.5</length><width>1.8</width></rectangle>", ""),
            "a.xml:30: shape: has no or several shapes, expected one");
  EXPECT_EQ(message("<exact>40</exact>", "<exact>-1</exact>"),
            "a.xml:33: dynamicObstacle: moving[0].trajectory[1] has the time -0.1, expected more "
            "than that of the row before, 0");
  EXPECT_EQ(message("trajectory>", "occupancySet>").substr(0, 40),
            "a.xml:40: is no XML (Start-end tags mism");
  EXPECT_EQ(message("<rectangle><length>10</length>",
                    "<lanelet ref=\"9\"/><rectangle><length>1</length>"),
            "a.xml:46: lanelet: has a ref to no lanelet of the file");
  EXPECT_EQ(message("<intervalStart>-0.2</intervalStart>", ""),
            "a.xml:48: orientation: has no intervalStart, expected one");
}

TEST_F(CommonRoad, ADriveBecomesASolution) {
  const CommonRoadCase street = one(street_example());
  const Scenario scenario = read_commonroad(street).file.scenario;
  PlanOptions options;
  options.budget.max_iterations = 3000;
  const PlanResult result = plan(scenario, options);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  const CommonRoadSolution solution = commonroad_solution(street, result);
  EXPECT_TRUE(solution.warnings.empty());
  pugi::xml_document xml;
  ASSERT_TRUE(xml.load_string(solution.text.c_str()));
  const pugi::xml_node root = xml.child("CommonRoadSolution");
  EXPECT_STREQ(root.attribute("benchmark_id").value(), "KS2:SM1:ZAM_Street-1_1_T-1:2020a");
  const pugi::xml_node drive = root.child("ksTrajectory");
  EXPECT_STREQ(drive.attribute("planningProblem").value(), "5");
  // Model KS between two states, by the mean of their speeds and steering angles.
  int steps = 0;
  for (pugi::xml_node state = drive.child("ksState"); state; state = state.next_sibling()) {
    const auto number = [](const pugi::xml_node& node, const char* name) {
      return node.child(name).text().as_double();
    };
    EXPECT_EQ(number(state, "time"), steps);
    ++steps;
    const pugi::xml_node next = state.next_sibling();
    if (!next) break;
    const double v = (number(state, "velocity") + number(next, "velocity")) / 2;
    const double angle = (number(state, "steeringAngle") + number(next, "steeringAngle")) / 2;
    const double heading = (number(state, "orientation") + number(next, "orientation")) / 2;
    EXPECT_NEAR(number(next, "x") - number(state, "x"), 0.1 * v * std::cos(heading), 0.03);
    EXPECT_NEAR(number(next, "y") - number(state, "y"), 0.1 * v * std::sin(heading), 0.03);
    EXPECT_NEAR(number(next, "orientation") - number(state, "orientation"),
                0.1 * v * std::tan(angle) / scenario.vehicle.wheelbase, 0.02);
    EXPECT_LE(std::abs(number(next, "steeringAngle") - number(state, "steeringAngle")), 0.0401);
  }
  EXPECT_GE(steps, 101);  // The goal begins at time step 100.
  const pugi::xml_node last = drive.last_child();
  const Pose end = end_pose(*result.path);
  EXPECT_NEAR(last.child("x").text().as_double(), end.x, 1e-9);
  EXPECT_EQ(last.child("velocity").text().as_double(), 0);
}

TEST_F(CommonRoad, ASolutionSaysWhatCommonRoadMayRefuse) {
  const auto warnings = [&](const std::string& part, const std::string& by) {
    const CommonRoadCase street = one(exchanged(street_example(), part, by));
    const Pose start = read_commonroad(street).file.scenario.start;
    PlanResult result;
    result.path = Path{start, {Segment{0, 60, 0}}};
    std::string text;
    for (const std::string& warning : commonroad_solution(street, result).warnings) {
      text += warning.substr(warning.find("a.xml"));
    }
    return text;
  };
  EXPECT_EQ(warnings("<intervalEnd>400</intervalEnd>", "<intervalEnd>100</intervalEnd>"), "");
  EXPECT_EQ(warnings("<intervalStart>100</intervalStart><intervalEnd>400</intervalEnd>",
                     "<intervalStart>1</intervalStart><intervalEnd>20</intervalEnd>"),
            "a.xml:49: the drive is at the goal at time step 55, expected at most 20");
  EXPECT_EQ(warnings("<velocity><exact>0</exact>", "<velocity><exact>8</exact>"),
            "a.xml:43: the drive begins at rest, expected 8 m/s");
  EXPECT_EQ(warnings("    </goalState>",
                     "<velocity><intervalStart>3</intervalStart><intervalEnd>9</intervalEnd>"
                     "</velocity></goalState>"),
            "a.xml:50: the drive ends at rest, expected 3 to 9 m/s");
  CommonRoadCase street = one(street_example());
  EXPECT_EQ(message_of([&] { return commonroad_solution(street, {}); }),
            "result: has no path, expected one");
  street.vehicle = vehicle_named("van");
  EXPECT_EQ(message_of([&] { return commonroad_solution(street, {}); }),
            "vehicle: is given, expected none: solutions are of CommonRoad's vehicle 2");
}

// Scenarios of CommonRoad's own repository, if they are there.
TEST_F(CommonRoad, ScenariosOfItsAuthorsAreRead) {
  const auto folder = shared_folder() / "scenarios" / "roads";
  if (!std::filesystem::is_directory(folder))
    GTEST_SKIP() << "no shared maps beside the repository";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".xml") continue;
    SCOPED_TRACE(entry.path());
    pugi::xml_document xml;
    ASSERT_TRUE(xml.load_file(entry.path().c_str()));
    const pugi::xml_node problem = xml.first_child().child("planningProblem");
    if (!problem.child("goalState").child("position")) continue;  // a goal of time or speed alone
    CommonRoadCase given{.file = entry.path().string(), .problem = problem.attribute("id").value()};
    given.rules.open_edges = true;
    const Scenario scenario = read_commonroad(given).file.scenario;
    EXPECT_FALSE(scenario.goal_set.empty());
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace vandplan
