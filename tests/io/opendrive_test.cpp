// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Maps of OpenDRIVE.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "io/road_line.h"
#include "support/reader_test.h"
#include "support/shared_files.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using std::numbers::pi;

std::string road_example() {
  return read_file((repository() / "examples" / "road.xodr").string(), 1 << 20);
}

/// A map of one road with a plan view and what stands in its lane section.
std::string map_of(const std::string& view, const std::string& section,
                   const std::string& rule = "RHT") {
  return "<OpenDRIVE>\n<road id=\"7\" rule=\"" + rule + "\"><planView>" + view +
         "</planView>\n<lanes>\n<laneSection s=\"0\">" + section +
         "</laneSection></lanes></road></OpenDRIVE>\n";
}

std::string lane(int id, const std::string& width, const std::string& more = "") {
  return "<lane id=\"" + std::to_string(id) + "\" type=\"driving\"" + more +
         "><width sOffset=\"0\" " + width + "/></lane>";
}

const std::string straight =
    R"(<geometry s="0" x="0" y="0" hdg="0" length="50"><line/></geometry>)";
const std::string wide = R"(a="3" b="0" c="0" d="0")";

class OpenDrive : public ReaderTest {
 protected:
  RoadScenario read(const std::string& text, const Pose& start = {5, -1.75, 0},
                    const Pose& goal = {15, -1.75, 0}) {
    return read_opendrive({.file = folder_.put("a.xodr", text),
                           .vehicle = vehicle_named("tpcap-car"),
                           .start = start,
                           .goal = goal});
  }
  /// A straight road with objects, without the walls around it.
  RoadScenario read_with_objects(const std::string& objects) {
    RoadScenario made = read(exchanged(map_of(straight, "<right>" + lane(-1, wide) + "</right>"),
                                       "</road>", "<objects>" + objects + "</objects></road>"));
    std::erase_if(made.file.scenario.obstacles, [](const Polygon& polygon) {
      const Bounds box = bounding_box(polygon);
      return box.x_max - box.x_min < 0.01 || box.y_max - box.y_min < 0.01;
    });
    return made;
  }
  std::string message(const std::string& text) {
    return message_of([&] { return read(text); });
  }
  /// Reference line of a road with this geometry.
  io::RoadLine line_of(const std::string& kind, double length) {
    const std::string geometry = "<geometry s=\"0\" x=\"3\" y=\"4\" hdg=\"0.5\" length=\"" +
                                 std::to_string(length) + "\">" + kind + "</geometry>";
    const io::XmlFile file(
        folder_.put("line.xodr", "<road><planView>" + geometry + "</planView></road>"), "road",
        "a road");
    return {file, file.root()};
  }
};

void expect_near(const Pose& pose, const Pose& expected, double tolerance) {
  EXPECT_NEAR(pose.x, expected.x, tolerance);
  EXPECT_NEAR(pose.y, expected.y, tolerance);
  EXPECT_NEAR(wrap_angle(pose.heading - expected.heading), 0, tolerance);
}

TEST_F(OpenDrive, LinesArcsAndSpiralsAreExact) {
  const Pose begin{3, 4, 0.5};
  expect_near(line_of("<line/>", 10).at(4), compose(begin, {4, 0, 0}), 1e-12);
  expect_near(line_of(R"(<arc curvature="-0.1"/>)", 10).at(5 * pi),
              compose(begin, {10 * std::sin(1.0), -10 * (1 - std::cos(1.0)), -1}), 1e-9);
  // A spiral from no curvature to 0.2, by its heading's integral.
  const io::RoadLine spiral = line_of(R"(<spiral curvStart="0" curvEnd="0.2"/>)", 10);
  double x = 0.0;
  double y = 0.0;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double s = (i + 0.5) * 10 / steps;
    x += std::cos(0.01 * s * s) * 10 / steps;
    y += std::sin(0.01 * s * s) * 10 / steps;
  }
  expect_near(spiral.at(10), compose(begin, {x, y, 1}), 1e-6);
  expect_near(spiral.at(20), spiral.at(10), 0);  // The end of the line.
}

TEST_F(OpenDrive, PolynomialsAreReadByLengthOrShare) {
  const Pose begin{3, 4, 0.5};
  const std::string curve =
      R"(<paramPoly3 aU="0" bU="B" cU="0" dU="0" aV="0" bV="0" cV="C" dV="0")";
  const io::RoadLine by_length =
      line_of(exchanged(exchanged(curve, "B", "1"), "C", "0.01") + " pRange=\"arcLength\"/>", 10);
  expect_near(by_length.at(4), compose(begin, {4, 0.16, std::atan(0.08)}), 1e-12);
  const io::RoadLine by_share =
      line_of(exchanged(exchanged(curve, "B", "10"), "C", "1") + " pRange=\"normalized\"/>", 10);
  expect_near(by_share.at(4), compose(begin, {4, 0.16, std::atan(0.08)}), 1e-12);
  // A graph: after 5 m along the line v = 0.75 u it is at u = 4.
  const io::RoadLine graph = line_of(R"(<poly3 a="0" b="0.75" c="0" d="0"/>)", 10);
  expect_near(graph.at(5), compose(begin, {4, 3, std::atan(0.75)}), 1e-9);
  const io::RoadLine parabola = line_of(R"(<poly3 a="0" b="0" c="0.05" d="0"/>)", 12);
  const double length = 5 * std::sqrt(2.0) + 5 * std::asinh(1.0);  // of v = u^2 / 20 up to u = 10
  expect_near(parabola.at(length), compose(begin, {10, 5, pi / 4}), 1e-8);
}

TEST_F(OpenDrive, ARoadWithAParkingSpaceBecomesAScenario) {
  const RoadScenario made = read(road_example(), {5, -1.75, 0}, {51.75, 50, pi / 2});
  const Scenario& scenario = made.file.scenario;
  EXPECT_EQ(scenario.name, "a");
  EXPECT_EQ(made.notes[0].substr(0, 19), "lanes: 2, areas: 1,");
  EXPECT_EQ(made.file.warnings, std::vector<std::string>{"left out: lane sidewalk (1)"});
  // The parking space is open to the lane, and the lanes are open to each other.
  const Problem problem = make_problem(scenario);
  const CollisionChecker checker(Footprint{0.1, 0.1, 0.1}, scenario.bounds, scenario.obstacles);
  EXPECT_TRUE(checker.is_free(LocalPose(Pose{15, 3.3, -pi / 2}), Segment{0, 9.6, 0}));
  EXPECT_FALSE(checker.is_free(LocalPose(Pose{15, 3, -pi / 2}), Segment{0, 10, 0}));
  EXPECT_FALSE(checker.is_free(LocalPose(Pose{10, 3, -pi / 2}), Segment{0, 7, 0}));
  for (double s = 0.5; s < 101; s += 0.25) {  // From one lane to the other.
    const Pose on_line = s < 30 ? Pose{s, 0, 0}
                         : s < 61.4
                             ? compose({30, 20, 0}, {20 * std::sin((s - 30) / 20),
                                                     -20 * std::cos((s - 30) / 20), (s - 30) / 20})
                             : Pose{50, 20 + s - 61.4, pi / 2};
    const LocalPose beside(compose(on_line, {0, -2, pi / 2}));
    EXPECT_TRUE(checker.is_free(beside, Segment{0, 4, 0})) << s;
  }
  PlanOptions options;
  options.budget.max_iterations = 3000;
  EXPECT_EQ(plan(scenario, options).status, PlanStatus::solved);
}

TEST_F(OpenDrive, EdgesAreNearTheirCurves) {
  const Scenario scenario = read(road_example(), {5, -1.75, 0}, {51.75, 50, pi / 2}).file.scenario;
  int corners = 0;
  for (const Zone& zone : scenario.zones) {
    for (std::size_t i = 0; i < zone.area.size(); ++i) {
      const Point& a = zone.area[i];
      const Point& b = zone.area[(i + 1) % zone.area.size()];
      if (a.x < 30.1 || b.x < 30.1 || a.y > 19.9 || b.y > 19.9) continue;  // Not of the arc.
      const double radius = std::hypot(a.x - 30, a.y - 20);
      const double other = std::hypot(b.x - 30, b.y - 20);
      const double edge = std::abs(radius - 20) < 1 ? 20 : radius < 20 ? 16.5 : 23.5;
      EXPECT_NEAR(radius, edge, 2e-4);
      if (std::abs(radius - other) > 1) continue;
      const double middle = std::hypot((a.x + b.x) / 2 - 30, (a.y + b.y) / 2 - 20);
      EXPECT_NEAR(middle, edge, 0.0051);
      ++corners;
    }
  }
  EXPECT_GT(corners, 20);
  EXPECT_LT(corners, 400);
}

TEST_F(OpenDrive, LanesAreDrivenOnTheSideOfTheirRule) {
  const std::string both =
      "<left>" + lane(1, wide) + "</left><right>" + lane(-1, wide) + "</right>";
  const auto heading = [](const Zone& zone) {
    return std::abs(wrap_angle((zone.direction->from + zone.direction->to) / 2));
  };
  const auto zones = [&](const std::string& section, const std::string& rule) {
    return read(map_of(straight, section, rule)).file.scenario.zones;
  };
  EXPECT_EQ(zones(both, "RHT")[0].name, "road 7 lane 1");
  EXPECT_NEAR(heading(zones(both, "RHT")[0]), pi, 1e-3);
  EXPECT_EQ(heading(zones(both, "RHT")[1]), 0);
  EXPECT_EQ(heading(zones(both, "LHT")[0]), 0);
  EXPECT_NEAR(heading(zones(both, "LHT")[1]), pi, 1e-3);
  const auto right = [&](const std::string& direction) {
    return zones("<right>" + lane(-1, wide, direction) + "</right>", "RHT");
  };
  EXPECT_NEAR(heading(right(" direction=\"reversed\"")[0]), pi, 1e-3);
  EXPECT_TRUE(right(" direction=\"both\"").empty());
  const std::string parking =
      exchanged("<right>" + lane(-1, wide) + "</right>", "driving", "parking");
  EXPECT_TRUE(zones(parking, "RHT").empty());
}

TEST_F(OpenDrive, WidthsBordersAndOffsetsPlaceTheEdges) {
  const auto box = [&](const std::string& section, const std::string& offset = "") {
    const std::string text =
        exchanged(map_of(straight, section), "<laneSection", offset + "<laneSection");
    const Scenario scenario = read(text, {5, -2.5, 0}, {15, -2.5, 0}).file.scenario;
    Polygon corners;
    for (const Zone& zone : scenario.zones) {
      corners.insert(corners.end(), zone.area.begin(), zone.area.end());
    }
    return bounding_box(corners);
  };
  const std::string two =
      "<right>" + lane(-1, wide) + lane(-2, R"(a="2" b="0.02" c="0" d="0")") + "</right>";
  EXPECT_EQ(box(two), (Bounds{0, 50, -6, 0}));
  EXPECT_EQ(box(two, R"(<laneOffset s="0" a="1" b="0" c="0" d="0"/>)"), (Bounds{0, 50, -5, 1}));
  const std::string border =
      R"(<right><lane id="-1" type="driving"><border sOffset="0" a="-4" b="0" c="0" d="0"/></lane></right>)";
  EXPECT_EQ(box(border), (Bounds{0, 50, -4, 0}));
}

TEST_F(OpenDrive, ALaneEndsWhereItHasNoWidth) {
  // 3 m wide at the begin, none from 30 m on, and again from 40 m on.
  const std::string width =
      R"(<lane id="-1" type="driving"><width sOffset="0" a="3" b="-0.1" c="0" d="0"/>)"
      R"(<width sOffset="30" a="0" b="0" c="0" d="0"/><width sOffset="40" a="0" b="0.3" c="0" d="0"/></lane>)";
  const Scenario scenario =
      read(map_of(straight, "<right>" + width + "</right>"), {5, -1, 0}, {10, -1, 0}).file.scenario;
  ASSERT_EQ(scenario.zones.size(), 2U);
  EXPECT_EQ(bounding_box(scenario.zones[0].area), (Bounds{0, 30, -3, 0}));
  EXPECT_EQ(bounding_box(scenario.zones[1].area), (Bounds{40, 50, -3, 0}));
}

TEST_F(OpenDrive, ParkingSpacesHaveOutlinesOrSizes) {
  const auto areas = [&](const std::string& object) {
    const std::string text = exchanged(map_of(straight, "<right>" + lane(-1, wide) + "</right>"),
                                       "</road>", "<objects>" + object + "</objects></road>");
    return read(text).file.scenario.bounds;
  };
  const std::string begin = R"(<object type="parkingSpace" s="20" t="-6" hdg="0" )";
  EXPECT_EQ(areas(begin + R"(length="8" width="6"/>)").y_min, -29);
  EXPECT_EQ(areas(begin + R"(><outline><cornerLocal u="0" v="0"/><cornerLocal u="4" v="0"/>)"
                          R"(<cornerLocal u="0" v="-5"/></outline></object>)")
                .y_min,
            -31);
  EXPECT_EQ(areas(begin + R"(><outlines><outline><cornerRoad s="1" t="-3"/><cornerRoad s="9" )"
                          R"(t="-3"/><cornerRoad s="9" t="-10"/></outline></outlines></object>)")
                .y_min,
            -30);
}

TEST_F(OpenDrive, ObjectsAreObstaclesAndMayBeRepeated) {
  const auto read_with = [&](const std::string& objects) { return read_with_objects(objects); };
  const auto obstacles = [&](const std::string& object) {
    return read_with(object).file.scenario.obstacles;
  };
  EXPECT_EQ(obstacles(R"(<object type="barrier" s="20" t="-2" length="4" width="1"/>)"),
            (std::vector<Polygon>{{{18, -2.5}, {22, -2.5}, {22, -1.5}, {18, -1.5}}}));
  const std::vector<Polygon> trees =
      obstacles(R"(<object type="tree" s="0" t="9" radius="1"><repeat s="10" length="20" )"
                R"(distance="10" tStart="5" tEnd="7"/></object>)");
  ASSERT_EQ(trees.size(), 3U);
  EXPECT_EQ(trees[0].size(), 32U);
  EXPECT_NEAR(bounding_box(trees[1]).x_min, 19, 0.01);
  EXPECT_NEAR(bounding_box(trees[1]).y_max, 7, 0.01);
  // Corners along the road are moved with their object.
  const std::vector<Polygon> boxes = obstacles(
      R"(<object type="building" s="5" t="3"><repeat s="10" length="4" distance="4"/><outlines>)"
      R"(<outline><cornerRoad s="5" t="3"/><cornerRoad s="7" t="3"/><cornerRoad s="7" t="6"/>)"
      R"(</outline><outline outer="false"/></outlines></object>)");
  EXPECT_EQ(boxes,
            (std::vector<Polygon>{{{10, 3}, {12, 3}, {12, 6}}, {{14, 3}, {16, 3}, {16, 6}}}));
  const RoadScenario rest =
      read_with(R"(<object type="crosswalk" s="1" t="0"/><object type="pole" s="1" t="0"/>)");
  EXPECT_TRUE(rest.file.scenario.obstacles.empty());
  EXPECT_EQ(
      rest.file.warnings,
      std::vector<std::string>{"left out: object crosswalk (1), object pole without a size (1)"});
}

TEST_F(OpenDrive, AContinuousObjectFollowsTheRoad) {
  const auto railing = [](const std::string& repeat) {
    return R"(<object type="railing" s="0" t="0"><repeat distance="0" )" + repeat + "/></object>";
  };
  const auto parts = [&](const std::string& repeat) {
    return read_with_objects(railing(repeat)).file.scenario.obstacles;
  };
  EXPECT_EQ(parts(R"(s="10" length="20" tStart="2" tEnd="2" widthStart="1" widthEnd="1")"),
            (std::vector<Polygon>{{{10, 1.5}, {30, 1.5}, {30, 2.5}, {10, 2.5}}}));
  EXPECT_EQ(parts(R"(s="10" length="20" tStart="2" tEnd="5" widthStart="1" widthEnd="2")"),
            (std::vector<Polygon>{{{10, 1.5}, {30, 4}, {30, 6}, {10, 2.5}}}));
  // One without a width is as thin as a wall. Along a circle all of it is within 5 mm.
  const std::string circle =
      R"(<geometry s="0" x="0" y="0" hdg="0" length="188"><arc curvature="0.02"/></geometry>)";
  const RoadScenario made =
      read(exchanged(map_of(circle, "<right>" + lane(-1, wide) + "</right>"), "</road>",
                     "<objects>" + railing(R"(s="0" length="188" tStart="5" tEnd="5")") +
                         "</objects></road>"),
           {5, -1.75, 0}, {10, -0.5, 0});
  const Scenario& scenario = made.file.scenario;
  const CollisionChecker checker(Footprint{0.02, 0.02, 0.02}, scenario.bounds, scenario.obstacles);
  for (int i = 1; i < 188; ++i) {
    const double angle = (i - 0.3) * 0.02;
    const auto is_free_at = [&](double radius) {
      const Pose pose{radius * std::sin(angle), 50 - radius * std::cos(angle), 0};
      return checker.is_free(LocalPose(pose), Segment{0, 0, 0});
    };
    EXPECT_FALSE(is_free_at(45)) << i;
    EXPECT_TRUE(is_free_at(44.94)) << i;
    EXPECT_TRUE(is_free_at(45.06)) << i;
  }
}

TEST_F(OpenDrive, WhatHangsAboveAVehicleOrLiesBelowTheRoadIsNotInTheWay) {
  const auto count = [&](const std::string& heights) {
    const RoadScenario made = read_with_objects(
        R"(<object type="barrier" s="20" t="-2" length="4" width="1" )" + heights + "/>");
    const std::size_t obstacles = made.file.scenario.obstacles.size();
    EXPECT_EQ(made.file.warnings.empty(), obstacles == 1);
    return obstacles;
  };
  EXPECT_EQ(count(R"(zOffset="4.4" height="1")"), 1U);
  EXPECT_EQ(count(R"(zOffset="4.5" height="1")"), 0U);
  EXPECT_EQ(count(R"(zOffset="-2" height="2.1")"), 1U);
  EXPECT_EQ(count(R"(zOffset="-2" height="2")"), 0U);
  EXPECT_EQ(count(R"(zOffset="-2")"), 1U) << "nobody says how high it is";
  const RoadScenario made = read_with_objects(
      R"(<object type="railing" s="0" t="-1"><repeat s="5" length="9" distance="0" )"
      R"(zOffsetStart="5" zOffsetEnd="6" heightStart="1" heightEnd="1"/></object>)");
  EXPECT_TRUE(made.file.scenario.obstacles.empty());
  EXPECT_EQ(made.file.warnings,
            std::vector<std::string>{"left out: object railing above or below the road (1)"});
}

TEST_F(OpenDrive, ABridgeIsNoCrossing) {
  // A second road crosses the first one at x = 30, at a height that the elevation says.
  const auto map_with = [&](const std::string& elevation) {
    return exchanged(
        map_of(straight, "<right>" + lane(-1, wide) + "</right>"), "</OpenDRIVE>",
        R"(<road id="8"><planView><geometry s="0" x="30" y="-40" hdg="1.5707963267948966" )"
        R"(length="80"><line/></geometry></planView><elevationProfile>)" +
            elevation + R"(</elevationProfile><lanes><laneSection s="0"><right>)" + lane(-1, wide) +
            "</right></laneSection></lanes></road></OpenDRIVE>");
  };
  const auto lanes = [&](const std::string& elevation, const Pose& start, const Pose& goal) {
    return read(map_with(elevation), start, goal).notes[0].substr(0, 8);
  };
  const Pose below{5, -1.75, 0}, beyond{45, -1.75, 0}, on{31.5, 20, 1}, above{31.5, -1.5, 1};
  const std::string six = R"(<elevation s="0" a="6" b="0" c="0" d="0"/>)";
  const std::string two = R"(<elevation s="0" a="2" b="0" c="0" d="0"/>)";
  // From -40 at 0 m it rises to 6 m where it crosses, and falls again.
  const std::string arched = R"(<elevation s="0" a="0" b="0.3" c="-0.00375" d="0"/>)";
  EXPECT_EQ(lanes(six, below, beyond), "lanes: 1");
  EXPECT_EQ(lanes(arched, below, beyond), "lanes: 1");
  EXPECT_EQ(lanes(two, below, beyond), "lanes: 2");
  EXPECT_EQ(read(map_with(six), below, beyond).file.warnings,
            std::vector<std::string>{"left out: lane on another level (1)"});
  // Below the bridge the road goes on straight ahead, and nowhere else.
  const Scenario street = read(map_with(six), below, beyond).file.scenario;
  const CollisionChecker checker(Footprint{0.1, 0.1, 0.1}, street.bounds, street.obstacles);
  EXPECT_TRUE(checker.is_free(LocalPose(below), Segment{0, 40, 0}));
  EXPECT_FALSE(checker.is_free(LocalPose(Pose{31.5, -1.5, pi / 2}), Segment{0, 10, 0}));
  EXPECT_FALSE(checker.is_free(LocalPose(Pose{31.5, -1.5, -pi / 2}), Segment{0, 10, 0}));
  // Where both roads are, the goal says which one it is; or else it is the lower one.
  EXPECT_EQ(bounding_box(read(map_with(six), above, on).file.scenario.zones[0].area).y_max, 40);
  EXPECT_EQ(bounding_box(read(map_with(six), above, above).file.scenario.zones[0].area).y_max, 0);
}

// Heights that no road has divide it no finer than every two metres or so.
TEST_F(OpenDrive, AWallOfARoadHasFewCorners) {
  const std::string steep = exchanged(
      map_of(straight, "<right>" + lane(-1, wide) + "</right>"), "<lanes>",
      R"(<elevationProfile><elevation s="0" a="0" b="1e6" c="0" d="9"/></elevationProfile><lanes>)");
  EXPECT_LT(read(steep).file.scenario.obstacles.size(), 200U);
}

TEST_F(OpenDrive, SpeedLimitsOfLanesComeBeforeThoseOfRoads) {
  const auto zones = [&](const std::string& more, const std::string& type) {
    const std::string lanes =
        "<right>" + exchanged(lane(-1, wide), "</lane>", more + "</lane>") + "</right>";
    return read(exchanged(map_of(straight, lanes), "<planView>", type + "<planView>"))
        .file.scenario.zones;
  };
  const std::string slow = R"(<type s="20" type="town"><speed max="36" unit="km/h"/></type>)";
  const std::vector<Zone> two = zones("", R"(<type s="0" type="rural"/>)" + slow);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].max_speed, std::nullopt);
  EXPECT_EQ(bounding_box(two[0].area), (Bounds{0, 20, -3, 0}));
  EXPECT_EQ(two[1].max_speed, 10);
  EXPECT_EQ(bounding_box(two[1].area), (Bounds{20, 50, -3, 0}));
  const std::vector<Zone> three =
      zones(R"(<speed sOffset="30" max="5"/><speed sOffset="40" max="no limit"/>)", slow);
  ASSERT_EQ(three.size(), 4U);
  EXPECT_EQ(three[1].max_speed, 10);
  EXPECT_EQ(three[2].max_speed, 5);
  EXPECT_EQ(bounding_box(three[2].area), (Bounds{30, 40, -3, 0}));
  EXPECT_EQ(three[3].max_speed, std::nullopt);
  // A limit of the road that begins behind the lane's first one does not count.
  const std::vector<Zone> own = zones(R"(<speed sOffset="10" max="5"/>)", slow);
  ASSERT_EQ(own.size(), 2U);
  EXPECT_EQ(bounding_box(own[1].area), (Bounds{10, 50, -3, 0}));
  EXPECT_EQ(own[1].max_speed, 5);
}

TEST_F(OpenDrive, WhatIsNotReadIsAWarning) {
  const std::string text =
      exchanged(exchanged(map_of(straight, "<right>" + lane(-1, wide) + "</right>"), "<lanes>",
                          R"(<lateralProfile><superelevation s="0" a="0.1" b="0" c="0" d="0"/>)"
                          R"(</lateralProfile><lanes>)"),
                "</road>", "<signals><signal/><signal/></signals></road>");
  EXPECT_EQ(read(text).file.warnings,
            std::vector<std::string>{"left out: signal (2), superelevation (1)"});
}

TEST_F(OpenDrive, WhatIsWrongHasOneLine) {
  const std::string good = map_of(straight, "<right>" + lane(-1, wide) + "</right>");
  const auto with = [&](const std::string& part, const std::string& by) {
    return message(exchanged(good, part, by));
  };
  EXPECT_EQ(message(good), "no error");
  EXPECT_EQ(with("<line/>", "<circle/>"),
            "a.xodr:2: geometry: is of no known kind, expected line, arc, spiral, paramPoly3 or "
            "poly3 in it");
  EXPECT_EQ(with("length=\"50\"", "length=\"-50\""),
            "a.xodr:2: geometry: has length -50, expected 0 to 1000000 m");
  EXPECT_EQ(with(straight, ""), "a.xodr:2: planView: has no geometry, expected one at least");
  EXPECT_EQ(with("<laneSection s=\"0\">", "<laneSection s=\"60\">"),
            "a.xodr:4: laneSection: begins at s = 60, expected 0 to less than 50, where the next "
            "one or the end of the road is");
  EXPECT_EQ(with("id=\"-1\"", "id=\"1\""), "a.xodr:4: lane: has id 1, expected a negative number");
  EXPECT_EQ(with("a=\"3\"", "a=\"3m\""), "a.xodr:4: width: has a \"3m\", expected a number");
  EXPECT_EQ(with("driving", "sidewalk"),
            "a.xodr:1: OpenDRIVE: has no lane or parking space, expected one at least");
  EXPECT_EQ(with("<lanes>", "<lane>"),
            "a.xodr:4: is no XML (Start-end tags mismatch), expected a "
            "map of OpenDRIVE");
  EXPECT_EQ(with("</lane>", R"(<speed sOffset="0" max="9" unit="knots"/></lane>)"),
            "a.xodr:4: speed: has max 9 and unit \"knots\", expected a positive number of m/s, mph "
            "or km/h");
  EXPECT_EQ(with("</lane>", R"(<speed sOffset="9" max="9"/><speed sOffset="3" max="9"/></lane>)"),
            "a.xodr:4: speed: holds from s = 3, expected at least that of the one before, 9");
  EXPECT_EQ(
      with("</road>", R"(<objects><object type="tree" s="0" t="0"><repeat s="0" length="9e9" )"
                      R"(distance="1"/></object></objects></road>)"),
      "a.xodr:4: repeat: has 9000000001 copies, expected at most 10000");
  EXPECT_EQ(message("<osm/>"),
            "a.xodr:1: osm: is the root, expected a map of OpenDRIVE with the root OpenDRIVE");
  EXPECT_EQ(message_of([&] {
              return read(good, {5, 5, 0});
            }),
            "--start: is at 5, 5, beside all lanes and areas, expected a place on one of them");
}

// Maps of esmini, if they are there: what is in lanes can be driven.
TEST_F(OpenDrive, MapsOfOthersAreRead) {
  const auto folder = shared_folder() / "scenarios" / "roads";
  if (!std::filesystem::is_directory(folder))
    GTEST_SKIP() << "no shared maps beside the repository";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".xodr") continue;
    SCOPED_TRACE(entry.path());
    RoadMap map{.file = entry.path().string(), .vehicle = vehicle_named("tpcap-car")};
    map.rules.open_edges = true;
    EXPECT_FALSE(read_opendrive(map).file.scenario.zones.empty());
    ++count;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace vandplan
