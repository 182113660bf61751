// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Maps of Lanelet2.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/reader_test.h"
#include "support/shared_files.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using std::numbers::pi;

std::string lanelet_example() {
  return read_file((repository() / "examples" / "lanelets.osm").string(), 1 << 20);
}

class Lanelet2 : public ReaderTest {
 protected:
  RoadScenario read(const std::string& text, const Pose& start = {5, -1.75, 0},
                    const Pose& goal = {30, -9, 0}) {
    return read_lanelet2({.file = folder_.put("a.osm", text),
                          .vehicle = vehicle_named("tpcap-car"),
                          .start = start,
                          .goal = goal});
  }
  std::string message(const std::string& text) {
    return message_of([&] { return read(text); });
  }
};

TEST_F(Lanelet2, ARoadWithACarParkBecomesAScenario) {
  const RoadScenario made = read(lanelet_example());
  const Scenario& scenario = made.file.scenario;
  EXPECT_EQ(scenario.name, "a");
  EXPECT_EQ(scenario.vehicle, vehicle_named("tpcap-car"));
  EXPECT_EQ(scenario.start, (Pose{5, -1.75, 0}));
  EXPECT_EQ(scenario.goal, (Pose{30, -9, 0}));
  EXPECT_EQ(scenario.bounds, (Bounds{-20, 80, -35, 23.5}));
  // The edge of the road stands left and right of the car park, which is open to the road.
  EXPECT_EQ(scenario.obstacles.size(), 10U);
  ASSERT_EQ(scenario.zones.size(), 2U);
  EXPECT_EQ(scenario.zones[0].name, "lanelet 21");
  EXPECT_EQ(scenario.zones[0].direction, (HeadingRange{-1.5708, 1.5708}));
  EXPECT_EQ(scenario.zones[1].name, "lanelet 22");
  EXPECT_NEAR(scenario.zones[1].direction->from, pi / 2, 1e-3);
  EXPECT_EQ(made.notes, std::vector<std::string>{"lanes: 2, areas: 1, zones: 2"});
  EXPECT_EQ(made.file.origin, std::nullopt);
  PlanOptions options;
  options.budget.max_iterations = 3000;
  EXPECT_EQ(plan(scenario, options).status, PlanStatus::solved);
}

TEST_F(Lanelet2, EdgesMayHaveAnyDirection) {
  const Scenario as_is = read(lanelet_example()).file.scenario;
  const std::string middle = "<nd ref='5'/><nd ref='6'/>";
  const Scenario turned =
      read(exchanged(lanelet_example(), middle, "<nd ref='6'/><nd ref='5'/>")).file.scenario;
  ASSERT_EQ(turned.zones.size(), 2U);
  EXPECT_EQ(turned.zones[0].direction, as_is.zones[0].direction);
  EXPECT_EQ(turned.zones[1].direction, as_is.zones[1].direction);
}

TEST_F(Lanelet2, TagsSayWhoDrivesThere) {
  const std::string road = "<tag k='type' v='lanelet'/><tag k='subtype' v='road'/>";
  const std::string lanelet = "<tag k='type' v='lanelet'/>";
  const auto zones = [&](const std::string& by) {
    return read(exchanged(lanelet_example(), road, lanelet + by)).file.scenario.zones.size();
  };
  EXPECT_EQ(zones("<tag k='subtype' v='road'/><tag k='one_way' v='no'/>"), 1U);
  EXPECT_EQ(zones("<tag k='subtype' v='bicycle_lane'/><tag k='participant:vehicle' v='yes'/>"), 2U);
  EXPECT_EQ(zones("<tag k='subtype' v='bus_lane'/>"), 2U);
  // Now the start is beside the ground.
  EXPECT_EQ(message(exchanged(lanelet_example(), road, lanelet + "<tag k='subtype' v='walkway'/>")),
            "--start: is at 5, -1.75, beside all lanes and areas, expected a place on one of them");
  const std::string no_cars =
      lanelet + "<tag k='subtype' v='road'/><tag k='participant:vehicle' v='no'/>";
  EXPECT_NE(message(exchanged(lanelet_example(), road, no_cars)), "no error");
  const RoadScenario crosswalk =
      read(exchanged(lanelet_example(), "</osm>",
                     "<relation id='9'><tag k='type' v='lanelet'/><tag k='subtype' v='crosswalk'/>"
                     "</relation></osm>"));
  EXPECT_EQ(crosswalk.file.warnings, std::vector<std::string>{"left out: lanelet crosswalk (1)"});
}

TEST_F(Lanelet2, SpeedLimitsHaveUnits) {
  const std::string road = "<tag k='type' v='lanelet'/><tag k='subtype' v='road'/>";
  const auto limited = [&](const std::string& limit) {
    return exchanged(lanelet_example(), road, road + "<tag k='speed_limit' v='" + limit + "'/>");
  };
  const auto zones = [&](const std::string& limit) {
    return read(limited(limit)).file.scenario.zones;
  };
  EXPECT_EQ(zones("36")[0].max_speed, 10);
  EXPECT_EQ(zones("36.0 km/h")[0].max_speed, 10);
  EXPECT_EQ(zones("7m/s")[0].max_speed, 7);
  EXPECT_EQ(zones("7m/s")[1].max_speed, std::nullopt);
  EXPECT_EQ(message(limited("walk")), "a.osm:22: tag: has v \"\", expected a number");
  EXPECT_EQ(message(limited("0")),
            "a.osm:22: tag: has v \"0\", expected a positive number of km/h, mph or m/s");
  EXPECT_EQ(message(limited("9 knots")),
            "a.osm:22: tag: has v \"9 knots\", expected a positive number of km/h, mph or m/s");
}

TEST_F(Lanelet2, WhatIsNotReadIsAWarning) {
  const RoadScenario made = read(exchanged(
      exchanged(lanelet_example(), "<tag k='local_x' v='20'/>",
                "<tag k='local_x' v='20'/><tag k='ele' v='1'/><tag k='type' v='pole'/>"),
      "</osm>",
      "<node id='50'><tag k='local_x' v='1'/><tag k='local_y' v='1'/><tag k='ele' v='2'/></node>"
      "<way id='31'><nd ref='9'/><nd ref='10'/><tag k='type' v='stop_line'/></way>"
      "<relation id='9'><tag k='type' v='regulatory_element'/><tag k='subtype' "
      "v='traffic_light'/></relation></osm>"));
  EXPECT_EQ(made.file.warnings,
            std::vector<std::string>{"left out: node ele (2), node pole (1), regulatory_element "
                                     "traffic_light (1), way stop_line (1)"});
}

TEST_F(Lanelet2, ABridgeIsNoCrossing) {
  // A lanelet from (30, -40) to (30, 40) over the road of the example, whose nodes are at 100 m.
  const auto notes_at = [&](const std::string& height, const std::string& wall = "") {
    std::string text = lanelet_example();
    const std::string end = "'/></node>";
    for (std::size_t at = text.find(end); at != std::string::npos; at = text.find(end, at + 30)) {
      text.replace(at, end.size(), "'/><tag k='ele' v='100'/></node>");
    }
    const auto node = [&](int id, double x, double y) {
      return "<node id='" + std::to_string(id) + "'><tag k='local_x' v='" + std::to_string(x) +
             "'/><tag k='local_y' v='" + std::to_string(y) + "'/><tag k='ele' v='" + height +
             "'/></node>";
    };
    const RoadScenario made = read(exchanged(
        text, "</osm>",
        node(51, 30, -40) + node(52, 30, 40) + node(53, 33, -40) + node(54, 33, 40) +
            "<way id='61'><nd ref='51'/><nd ref='52'/>" + wall + "</way>" +
            "<way id='62'><nd ref='53'/><nd ref='54'/></way>" +
            "<relation id='63'><member type='way' ref='61' role='left'/><member type='way' "
            "ref='62' role='right'/><tag k='type' v='lanelet'/><tag k='subtype' v='road'/>"
            "</relation></osm>"));
    return made.notes[0].substr(0, 18) +
           (made.file.warnings.empty() ? "" : ", " + made.file.warnings[0]);
  };
  EXPECT_EQ(notes_at("104"), "lanes: 3, areas: 1");
  EXPECT_EQ(notes_at("106"), "lanes: 2, areas: 1, left out: lane on another level (1)");
  EXPECT_EQ(
      notes_at("106", "<tag k='type' v='wall'/>"),
      "lanes: 2, areas: 1, left out: lane on another level (1), obstacle on another level (1)");
  EXPECT_EQ(
      notes_at("94", "<tag k='type' v='wall'/>"),
      "lanes: 2, areas: 1, left out: lane on another level (1), obstacle on another level (1)");
}

TEST_F(Lanelet2, AreasAndWaysAreGroundOrObstacles) {
  const std::string parking = "<tag k='subtype' v='parking'/>";
  // 10 walls; without the car park 8: the edge of the road has three sides.
  const auto obstacles = [&](const std::string& from, const std::string& to) {
    const Pose goal{40, -1.75, 0};
    return read(exchanged(lanelet_example(), from, to), {5, -1.75, 0}, goal)
        .file.scenario.obstacles;
  };
  EXPECT_EQ(obstacles(parking, "<tag k='subtype' v='walkway'/>").size(), 8U);
  const std::vector<Polygon> building = obstacles(parking, "<tag k='subtype' v='building'/>");
  ASSERT_EQ(building.size(), 9U);
  EXPECT_EQ(building[0].size(), 4U);
  const std::vector<Polygon> fence = obstacles("<nd ref='3'/></way>",
                                               "<nd ref='3'/></way><way id='31'><nd ref='9'/>"
                                               "<nd ref='10'/><tag k='type' v='fence'/></way>");
  EXPECT_EQ(fence.size(), 11U);
  const std::string curb = "<tag k='type' v='curbstone'/></way>\n  <way id='12'>";
  EXPECT_TRUE(read(lanelet_example()).file.scenario.kerbs.empty());
  EXPECT_EQ(read(exchanged(lanelet_example(), curb, "<tag k='subtype' v='high'/>" + curb))
                .file.scenario.kerbs.size(),
            3U);
  // Autoware's ways: a lot, and a space along its middle line with a width.
  const std::string ways =
      "<way id='31'><nd ref='5'/><nd ref='9'/><nd ref='1'/><tag k='type' v='parking_lot'/></way>"
      "<way id='32'><nd ref='9'/><nd ref='10'/><tag k='type' v='parking_space'/>"
      "<tag k='width' v='3'/></way></osm>";
  const RoadScenario made = read(exchanged(lanelet_example(), "</osm>", ways));
  EXPECT_EQ(made.notes[0], "lanes: 2, areas: 3, zones: 2");
}

TEST_F(Lanelet2, DegreesBecomeMetres) {
  if (!reads_longitudes()) GTEST_SKIP() << "built without GeographicLib";
  std::string text = lanelet_example();
  // 0.0001 degrees are 11.1 m at the equator: the same road at another scale.
  for (std::size_t at = text.find("lat='0' lon='0'"); at != std::string::npos;
       at = text.find("lat='0' lon='0'")) {
    const auto value = [&](const std::string& key) {
      const std::size_t begin = text.find("v='", text.find(key, at)) + 3;
      return std::stod(text.substr(begin)) * 1e-5;
    };
    const std::string place = "lat='" + std::to_string(value("local_y") + 0.1) + "' lon='" +
                              std::to_string(value("local_x") + 0.2) + "'";
    const std::size_t end = text.find("</node>", at);
    text.replace(at, end - at, place + ">");
  }
  const RoadScenario made = read(text, {0.20005, 0.0999825, 0}, {0.2003, 0.09991, 0});
  ASSERT_TRUE(made.file.origin);
  EXPECT_EQ(made.file.origin->longitude, 0.20005);
  EXPECT_NEAR(made.file.scenario.goal.x, 27.8, 0.1);
  EXPECT_NEAR(made.file.scenario.goal.y, -7.7, 0.2);
  EXPECT_EQ(made.file.scenario.zones.size(), 2U);
  EXPECT_EQ(message_of([&] {
              return read(text, {0.20005, 95, 0});
            }),
            "--start: is 0.20005,95, expected longitude and latitude in degrees of a place within "
            "100 km of the start");
}

TEST_F(Lanelet2, WhatIsWrongHasOneLine) {
  const auto with = [&](const std::string& part, const std::string& by) {
    return message(exchanged(lanelet_example(), part, by));
  };
  EXPECT_EQ(message("osm"),
            "a.osm:1: is no XML (No document element found), expected a map of "
            "Lanelet2");
  EXPECT_EQ(message("<OSM/>"),
            "a.osm:1: OSM: is the root, expected a map of Lanelet2 with the root osm");
  EXPECT_EQ(message_of([&] {
              return read("<osm>\n</osm>", {5, 1, 0}, {5, 1, 0});
            }),
            "a.osm:1: osm: has no lanelet or area for vehicles, expected one at least");
  EXPECT_EQ(with("<nd ref='5'/>", "<nd ref='55'/>"),
            "a.osm:15: nd: is node 55, expected one of the file");
  EXPECT_EQ(with("ref='12' role='left'", "ref='52' role='left'"),
            "a.osm:20: member: is way 52, expected one of the file");
  EXPECT_EQ(with("ref='12' role='left'", "ref='12' role='right'"),
            "a.osm:19: relation: has 0 left ways, expected one");
  EXPECT_EQ(with("<nd ref='5'/><nd ref='6'/>", "<nd ref='5'/>"),
            "a.osm:15: way: has 1 nodes, expected at least 2");
  EXPECT_EQ(with("<nd ref='10'/><nd ref='3'/>", "<nd ref='10'/>"),
            "a.osm:29: relation: has an open ring, expected ways that close it");
  EXPECT_EQ(with("k='local_x' v='20'", "k='local_x' v='x'"),
            "a.osm:5: tag: has v \"x\", expected a number");
  EXPECT_EQ(with("<tag k='local_x' v='20'/>", ""),
            "a.osm:5: node: has no local_x and local_y, expected both, as other nodes have them");
  EXPECT_EQ(with("<way id='15'>", "<way>"), "a.osm:18: way: has no attribute id, expected one");
  EXPECT_EQ(with("</osm>",
                 "<way id='31'><nd ref='1'/><nd ref='2'/><tag k='type' "
                 "v='parking_space'/></way></osm>"),
            "a.osm:34: way: has width 0, expected more than 0 m");
}

// The example of Lanelet2's own repository, if it is there.
TEST_F(Lanelet2, TheExampleOfItsAuthorsIsRead) {
  const auto file = shared_folder() / "scenarios" / "roads" / "mapping_example.osm";
  if (!std::filesystem::exists(file) || !reads_longitudes())
    GTEST_SKIP() << "no shared maps beside the repository";
  RoadMap map{.file = file.string(), .vehicle = vehicle_named("tpcap-car")};
  map.rules.open_edges = true;
  map.start = {8.42427590707, 49.00345654351, 0};
  map.goal = map.start;
  const RoadScenario made = read_lanelet2(map);
  EXPECT_GT(made.file.scenario.zones.size(), 50U);
  EXPECT_GT(made.file.scenario.obstacles.size(), 30U);  // Buildings, islands, walls and fences.
}

}  // namespace
}  // namespace vandplan
