// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Problems of MovingAI and in the manner of dynobench.
#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "support/reader_test.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using std::numbers::pi;

const std::string movingai_map = "type octile\nheight 3\nwidth 4\nmap\n.GS@\nOTW.\n....\n";
const std::string problems =
    "version 1\n0\ta.map\t4\t3\t0\t0\t0\t2\t2.0\n1\ta.map\t4\t3\t1\t2\t3\t2\t2.0\n";

class MovingAi : public ReaderTest {
 protected:
  Scenario read(const std::string& map, const std::string& scen, int number) {
    return read_movingai({.map = folder_.put("a.map", map),
                          .problems = folder_.put("a.scen", scen),
                          .number = number,
                          .resolution = 2.0});
  }
  std::string message(const std::string& map, const std::string& scen, int number = 1) {
    return message_of([&] { return read(map, scen, number); });
  }
};

// Row 0 is the upper one: its middle is 2.5 cells high.
TEST_F(MovingAi, CellsCountFromTheUpperLeftCorner) {
  const Scenario first = read(movingai_map, problems, 1);
  EXPECT_EQ(first.name, "a-1");
  EXPECT_EQ(first.start, (Pose{1, 5, -pi / 2}));
  EXPECT_EQ(first.goal, (Pose{1, 1, -pi / 2}));
  EXPECT_EQ(first.bounds, (Bounds{0, 8, 0, 6}));
  EXPECT_EQ(first.vehicle, vehicle_named("tpcap-car"));
  const Scenario second = read(movingai_map, problems, 2);
  EXPECT_EQ(second.start, (Pose{3, 1, 0}));
  EXPECT_EQ(second.goal, (Pose{7, 1, 0}));
}

TEST_F(MovingAi, GroundGrassAndSwampAreFree) {
  const OccupancyGrid grid = *read(movingai_map, problems, 1).map;
  EXPECT_EQ(grid.resolution, 2.0);
  const std::string expected = "....###....#";  // from below
  for (std::int32_t i = 0; i < 12; ++i) {
    EXPECT_EQ(is_blocked(grid, i % 4, i / 4), expected[static_cast<std::size_t>(i)] == '#') << i;
  }
}

TEST_F(MovingAi, TheMapReadsBackFromPgmAndYaml) {
  const OccupancyGrid grid = *read(movingai_map, problems, 1).map;
  folder_.put("b.pgm", map_to_pgm(grid));
  const OccupancyGrid again = read_map(folder_.put("b.yaml", map_to_yaml(grid, "b.pgm")));
  EXPECT_EQ(*again.cells, *grid.cells);
  EXPECT_EQ(again.origin, grid.origin);
  EXPECT_EQ(again.resolution, grid.resolution);
}

TEST_F(MovingAi, WhatIsNotCoveredHasOneLineEach) {
  EXPECT_EQ(message(exchanged(movingai_map, "octile", "tile"), problems),
            "a.map:1: is no map that can be read, expected \"type octile\"");
  EXPECT_EQ(message(exchanged(movingai_map, "height 3", "height x"), problems),
            "a.map:2: is no size, expected height and 1 to 100000");
  EXPECT_EQ(message(exchanged(movingai_map, "3\nwidth 4", "100000\nwidth 100000"), problems),
            "a.map:2: is too large, expected at most 400000000 cells");
  EXPECT_EQ(message(exchanged(movingai_map, "OTW.", "OTX."), problems),
            "a.map:6: has a cell \"X\", expected one of .GS@OTW");
  EXPECT_EQ(message(exchanged(movingai_map, "OTW.", "OTW"), problems),
            "a.map:6: has 3 cells, expected 4");
  EXPECT_EQ(message(exchanged(movingai_map, "....\n", ""), problems),
            "a.map:6: is the last line, expected 3 rows of cells");
  EXPECT_EQ(message(movingai_map, "1 2 3\n"),
            "a.scen:1: is no list of problems, expected \"version 1\"");
  EXPECT_EQ(message(movingai_map, problems, 3), "a.scen: has 2 problems, expected at least 3");
  EXPECT_EQ(message(movingai_map, exchanged(problems, "4\t3\t0", "5\t3\t0")),
            "a.scen:2: is for a map of 5 x 3 cells, expected 4 x 3");
  EXPECT_EQ(message(movingai_map, exchanged(problems, "0\t2\t2.0", "0\t3\t2.0")),
            "a.scen:2: names the cell 3, expected 0 to 2");
  EXPECT_EQ(message(movingai_map, exchanged(problems, "0\ta.map", "0\tmaps/b.map")),
            "a.scen:2: is on the map maps/b.map, expected a.map");
  EXPECT_EQ(message(movingai_map, exchanged(problems, "0\ta.map", "0\tmaps/a.map")), "no error");
  EXPECT_EQ(message(movingai_map, problems, -1), "number: is -1, expected 1 or more");
}

const std::string dynobench =
    "name: boxes\n"
    "environment:\n"
    "  min: [0, 0]\n"
    "  max: [6, 5]\n"
    "  obstacles:\n"
    "    - {type: box, center: [2.5, 1.5], size: [1, 0.5]}\n"
    "robots:\n"
    "  - type: car1_v0\n"
    "    start: [0.7, 0.6, 0]\n"
    "    goal: [1.9, 0.3, 1.5]\n";

class Dynobench : public ReaderTest {
 protected:
  Scenario read(const std::string& text) {
    return read_dynobench(folder_.put("d.yaml", text), "van");
  }
  std::string message(const std::string& part, const std::string& by) {
    return message_of([&] { return read(exchanged(dynobench, part, by)); });
  }
};

TEST_F(Dynobench, ACarAmongBoxesIsRead) {
  const Scenario scenario = read(dynobench);
  EXPECT_EQ(scenario.name, "boxes");
  EXPECT_EQ(scenario.vehicle, vehicle_named("van"));
  EXPECT_EQ(scenario.bounds, (Bounds{0, 6, 0, 5}));
  EXPECT_EQ(scenario.start, (Pose{0.7, 0.6, 0}));
  EXPECT_EQ(scenario.goal, (Pose{1.9, 0.3, 1.5}));
  EXPECT_EQ(scenario.obstacles,
            (std::vector<Polygon>{{{2, 1.25}, {3, 1.25}, {3, 1.75}, {2, 1.75}}}));
}

TEST_F(Dynobench, AFourthElementIsTheHeadingOfATrailer) {
  std::string text = exchanged(dynobench, "start: [0.7, 0.6, 0]", "start: [0.7, 0.6, 3, -3]");
  text = exchanged(text, "goal: [1.9, 0.3, 1.5]", "goal: [1.9, 0.3, 1.5, 1.2]");
  const Scenario scenario = read(text);
  ASSERT_TRUE(scenario.vehicle.trailer);
  EXPECT_NEAR(scenario.vehicle.min_turning_radius, 0.1443, 1e-4);
  EXPECT_EQ(scenario.vehicle.trailer->wheelbase, 0.5);
  EXPECT_NEAR(scenario.hitch_angles.start, 6 - 2 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(scenario.hitch_angles.goal, 0.3, 1e-12);
  const Scenario named = read_dynobench(folder_.put("named.yaml", text), "tractor-semitrailer");
  EXPECT_EQ(named.vehicle, vehicle_named("tractor-semitrailer"));
}

TEST_F(Dynobench, WhatIsNotCoveredHasOneLineEach) {
  EXPECT_EQ(
      message("car1_v0", "quad2d_v0"),
      "d.yaml:8: robots[0].type: is \"quad2d_v0\", expected a car: other robots are not covered");
  EXPECT_EQ(message("start: [0.7, 0.6, 0]", "start: [0.7, 0.6, 0, 0]"),
            "d.yaml:10: robots[0].goal: expected as many elements as start has");
  EXPECT_EQ(
      message("start: [0.7, 0.6, 0]", "start: [0.7, 0.6]"),
      "d.yaml:9: robots[0].start: has 2 elements, expected [x, y, heading] or [x, y, heading, "
      "trailer]");
  EXPECT_EQ(message("type: box", "type: sphere"),
            "d.yaml:6: environment.obstacles[0].type: is \"sphere\", expected box, all that is "
            "covered");
  EXPECT_EQ(
      message("robots:\n", "robots:\n  - {type: car1_v0, start: [0, 0, 0], goal: [0, 0, 0]}\n"),
      "d.yaml:8: robots: has 2 robots, expected one: fleets are not covered");
  EXPECT_EQ(message("min: [0, 0]", "min: [0, 0, 0]"),
            "d.yaml:3: environment.min: has 3 elements, expected [x, y]");
  EXPECT_EQ(message("max: [6, 5]", "max: [-6, 5]"),
            "d.yaml:4: environment.max: is [0, -6], expected the smaller number first");
  EXPECT_EQ(message("size: [1, 0.5]", "size: [1, -0.5]"),
            "d.yaml:6: environment.obstacles[0].size: has a side of -0.5, expected more than 0 m");
  EXPECT_EQ(message("start: [0.7,", "start: [7e20,"),
            "d.yaml:9: robots[0].start: is 7e+20, expected a number between -1e+12 and 1e+12");
}

}  // namespace
}  // namespace vandplan
