// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "support/reader_test.h"
#include "support/shared_files.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

// A scenario with every key; the tests of errors exchange a part of it.
const std::string valid = R"(name: yard
description: "a test"
vehicle: {wheelbase: 4.5, front_overhang: 1.4, rear_overhang: 1.6, width: 2.55, min_turning_radius: 7}
bounds: {x: [-50, 50], y: [-40, 40.5]}
start: {x: 0, y: 1e-1, heading: -0.5}
goal:
  x: +20
  y: 5.25   # metres
  heading: .5
obstacles:
  - [[1, 2], [3, 2], [3, 4]]
  - - [-1, -2]
    - [-3, -2]
    - [-3, -4]
)";

const std::string valid_row = R"(name: row
vehicle: {wheelbase: 4.5, front_overhang: 1.4, rear_overhang: 1.6, width: 2.55, min_turning_radius: 7}
bounds: {x: [-50, 50], y: [-40, 40]}
start: {x: 0, y: 0, heading: 0}
goals:
  - distance: 20
    goal: {x: 20, y: 0, heading: 0}
  - {distance: 40, goal: {x: 40, y: 0, heading: 0}, obstacles: [[[1, 2], [3, 2], [3, 4]]]}
obstacles: []
)";

std::string message_for_scenario(const std::string& text) {
  try {
    (void)scenario_from_yaml(text, "s.yaml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void expect_equal(const ScenarioFile& one, const ScenarioFile& other) {
  const Scenario& a = one.scenario;
  const Scenario& b = other.scenario;
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.vehicle, b.vehicle);
  EXPECT_EQ(a.bounds, b.bounds);
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.goal, b.goal);
  EXPECT_EQ(a.curvatures, b.curvatures);
  EXPECT_EQ(a.obstacles, b.obstacles);
  EXPECT_EQ(a.zones, b.zones);
  EXPECT_EQ(a.moving, b.moving);
  EXPECT_EQ(one.options, other.options);
  ASSERT_EQ(one.row.size(), other.row.size());
  for (std::size_t i = 0; i < one.row.size(); ++i) {
    EXPECT_EQ(one.row[i].distance, other.row[i].distance);
    EXPECT_EQ(one.row[i].goal, other.row[i].goal);
    EXPECT_EQ(one.row[i].curvature, other.row[i].curvature);
    EXPECT_EQ(one.row[i].obstacles, other.row[i].obstacles);
  }
}

TEST(ScenarioFile, EveryKeyIsRead) {
  const ScenarioFile file = scenario_from_yaml(valid, "s.yaml");
  const Scenario& scenario = file.scenario;
  EXPECT_EQ(scenario.name, "yard");
  EXPECT_EQ(scenario.description, "a test");
  EXPECT_EQ(scenario.vehicle, (Vehicle{4.5, 1.4, 1.6, 2.55, 7}));
  EXPECT_EQ(scenario.bounds, (Bounds{-50, 50, -40, 40.5}));
  EXPECT_EQ(scenario.start, (Pose{0, 0.1, -0.5}));
  EXPECT_FALSE(file.is_row());
  EXPECT_EQ(file.size(), 1U);
  EXPECT_TRUE(file.warnings.empty());
  EXPECT_EQ(scenario.goal, (Pose{20, 5.25, 0.5}));
  EXPECT_EQ(scenario.curvatures, EndCurvatures{});
  EXPECT_EQ(scenario.obstacles,
            (std::vector<Polygon>{{{1, 2}, {3, 2}, {3, 4}}, {{-1, -2}, {-3, -2}, {-3, -4}}}));
}

// A map of 4 x 2 cells of 5 m: the lower left one is occupied, the upper right one unknown.
class ScenarioWithMap : public testing::Test {
 protected:
  void SetUp() override {
    folder_.put("map.yaml",
                "image: m.pgm\nresolution: 5\norigin: [-10, 2.5, 0]\nnegate: 0\n"
                "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    folder_.put("m.pgm", "P2 4 2 255 255 255 255 205 0 255 255 255");
  }

  [[nodiscard]] Scenario read(const std::string& rest) const {
    return read_scenario(folder_.put("s.yaml", lines + rest));
  }

  std::string message(const std::string& rest) const {
    try {
      (void)read(rest);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.path().size() + 1);
    }
    return "no error";
  }

  const std::string lines =
      "name: yard\n"
      "vehicle: {wheelbase: 4.5, front_overhang: 1.4, rear_overhang: 1.6, width: 2.55, "
      "min_turning_radius: 7}\n"
      "start: {x: 0, y: 0, heading: 0}\ngoal: {x: 5, y: 5, heading: 0}\n";
  TemporaryFolder folder_;
};

TEST_F(ScenarioWithMap, ZonesAndMasksAreReadAndWritten) {
  const Scenario scenario = read(
      "bounds: {x: [-50, 50], y: [-40, 40]}\nobstacles: []\nzones:\n"
      "  - {name: a \"lawn\", area: [[1, 2], [3, 2], [3, 4]], closed: true, max_speed: 1.2, body: "
      "true}\n"
      "  - {area: [[1, 2], [3, 2], [3, 4]], gears: reverse, direction: [0.5, 1.1], cost: 2.5}\n"
      "masks:\n  - {map: map.yaml, as: obstacles}\n");
  const Polygon area{{1, 2}, {3, 2}, {3, 4}};
  ASSERT_EQ(scenario.zones.size(), 2U);
  EXPECT_EQ(
      scenario.zones[0],
      (Zone{.name = "a \"lawn\"", .area = area, .closed = true, .max_speed = 1.2, .body = true}));
  EXPECT_EQ(scenario.zones[1], (Zone{.area = area,
                                     .gears = AllowedGears::reverse,
                                     .direction = HeadingRange{0.5, 1.1},
                                     .cost = 2.5}));
  ASSERT_EQ(scenario.masks.size(), 1U);
  EXPECT_EQ(scenario.masks[0].map_file, "map.yaml");
  EXPECT_EQ(scenario.masks[0].map.columns, 4);
  const Scenario again = read_scenario(folder_.put("again.yaml", to_yaml(scenario)));
  EXPECT_EQ(again.zones, scenario.zones);
  ASSERT_EQ(again.masks.size(), 1U);
  EXPECT_EQ(*again.masks[0].map.cells, *scenario.masks[0].map.cells);
}

/// Three cells of a gray image: black, in the middle, white.
TEST_F(ScenarioWithMap, MasksHaveGradesAsNav2PublishesThem) {
  folder_.put("grey.pgm", std::string("P5\n5 1\n255\n") + '\0' + '\x7f' + '\xff' + '\x32' + '\x64');
  const auto masks = [&](const std::string& mode, const std::string& keys) {
    folder_.put("grey.yaml",
                "image: grey.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\n"
                "occupied_thresh: 0.9\nfree_thresh: 0.1\nmode: " +
                    mode + "\n");
    return read(
               "bounds: {x: [-50, 50], y: [-40, 40]}\nobstacles: []\nmasks:\n  - {map: "
               "grey.yaml, " +
               keys + "}\n")
        .masks;
  };
  const auto percents = [&](const std::string& mode) {
    const Mask mask = masks(mode, "as: cost, of: 5").front();
    return std::vector<int>(mask.percents->begin(), mask.percents->end());
  };
  EXPECT_EQ(percents("scale"), (std::vector<int>{100, 50, 0, 88, 63}));
  EXPECT_EQ(percents("raw"), (std::vector<int>{0, 255, 255, 50, 100}));
  EXPECT_EQ(percents("trinary"), (std::vector<int>{100, 255, 0, 255, 255}));
  const auto as_is = [&](const std::string& keys) {
    const Mask mask = masks("raw", keys).front();
    return std::tuple(mask.use, mask.base, mask.multiplier);
  };
  using Values = std::tuple<MaskUse, double, double>;
  EXPECT_EQ(as_is("as: cost, of: 5"), Values(MaskUse::cost, 1, 0.05));
  EXPECT_EQ(as_is("as: obstacles"), Values(MaskUse::obstacles, 0, 0));
  EXPECT_EQ(as_is("type: 0, base: 0, multiplier: 1"), Values(MaskUse::obstacles, 0, 0));
  EXPECT_EQ(as_is("type: 2, base: 3, multiplier: -0.02"), Values(MaskUse::max_speed, 3, -0.02));
  const double fastest = Vehicle{}.limits.max_speed.forward;
  EXPECT_EQ(as_is("type: 1, base: 100, multiplier: -0.5"),
            Values(MaskUse::max_speed, fastest, -0.5 * fastest / 100));
}

TEST_F(ScenarioWithMap, MasksAreWrittenAsTheyAre) {
  OccupancyGrid map = read("map: map.yaml\n").map.value();
  Scenario scenario = read("bounds: {x: [-50, 50], y: [-40, 40]}\nobstacles: []\n");
  scenario.masks = {cost_mask(map, 7),
                    speed_mask(map, 3),
                    {.map = map, .use = MaskUse::max_speed, .base = 2, .multiplier = -0.01}};
  for (std::size_t i = 0; i < scenario.masks.size(); ++i) {
    Mask& mask = scenario.masks[i];
    std::vector<std::uint8_t> percents(mask.map.cells->size(), Mask::unknown);
    for (std::size_t k = 0; k < percents.size(); k += 2) {
      percents[k] = static_cast<std::uint8_t>(17 * k % 99);
    }
    mask.percents = std::make_shared<const std::vector<std::uint8_t>>(percents);
    const std::string name = "mask" + std::to_string(i);
    folder_.put(name + ".pgm", mask_to_pgm(mask));
    mask.map_file = name + ".yaml";
    folder_.put(mask.map_file, mask_to_yaml(mask, name + ".pgm"));
  }
  const Scenario again = read_scenario(folder_.put("again.yaml", to_yaml(scenario)));
  ASSERT_EQ(again.masks.size(), 3U);
  for (std::size_t i = 0; i < again.masks.size(); ++i) {
    EXPECT_EQ(again.masks[i].use, scenario.masks[i].use);
    EXPECT_DOUBLE_EQ(again.masks[i].base, scenario.masks[i].base);
    EXPECT_DOUBLE_EQ(again.masks[i].multiplier, scenario.masks[i].multiplier);
    EXPECT_EQ(*again.masks[i].percents, *scenario.masks[i].percents);
  }
}

TEST_F(ScenarioWithMap, FaultsOfZonesAndMasksNameTheirLine) {
  const auto fault = [&](const std::string& zones) { return message("map: map.yaml\n" + zones); };
  EXPECT_EQ(
      fault("zones:\n  - {area: [[0, 0], [1, 0], [1, 1]]}\n"),
      "s.yaml:7: zones[0]: has no rule, expected closed, gears, direction, cost or max_speed");
  EXPECT_EQ(fault("zones:\n  - {area: [[0, 0], [1, 0], [1, 1]], gears: fast}\n"),
            "s.yaml:7: zones[0].gears: \"fast\" is not both, forward or reverse");
  EXPECT_EQ(fault("zones:\n  - {area: [[0, 0], [1, 0], [1, 1]], closed: 1}\n"),
            "s.yaml:7: zones[0].closed: is \"1\", expected true or false");
  EXPECT_EQ(fault("zones:\n  - {area: [[0, 0], [1, 0]], closed: true}\n"),
            "s.yaml:7: zones[0].area: has 2 corners, expected at least 3");
  EXPECT_EQ(fault("zones:\n  - {closed: true}\n"),
            "s.yaml:7: zones[0]: key \"area\" is missing, expected it");
  EXPECT_EQ(fault("masks:\n  - {map: map.yaml, as: walls}\n"),
            "s.yaml:7: masks[0].as: is \"walls\", expected obstacles, max_speed or cost");
  EXPECT_EQ(fault("masks:\n  - {map: map.yaml, as: cost}\n"),
            "s.yaml:7: masks[0]: key \"of\" is missing, expected it");
  EXPECT_EQ(fault("masks:\n  - {map: map.yaml, as: obstacles, of: 3}\n"),
            "s.yaml:7: masks[0].of: is given for obstacles, expected max_speed or cost");
  EXPECT_EQ(fault("masks:\n  - {map: map.yaml, type: 3}\n"),
            "s.yaml:7: masks[0].type: is 3, expected 0 (keepout), 1 (speed in %) or 2 (in m/s)");
  EXPECT_EQ(fault("masks:\n  - {map: map.yaml, type: 1, as: cost}\n"),
            "s.yaml:7: masks[0].as: is given beside type, expected one of them");
  EXPECT_EQ(fault("masks:\n  - {map: map.yaml, as: cost, base: 1}\n"),
            "s.yaml:7: masks[0].base: is given without type, expected type 0, 1 or 2 beside it");
  EXPECT_EQ(fault("masks:\n  - {map: none.yaml, as: obstacles}\n").substr(0, 24),
            "s.yaml:7: masks[0].map: ");
}

TEST_F(ScenarioWithMap, TheMapLiesBesideTheScenario) {
  const Scenario scenario = read("map: map.yaml\n");
  EXPECT_EQ(scenario.map_file, "map.yaml");
  ASSERT_TRUE(scenario.map);
  EXPECT_TRUE(is_blocked(*scenario.map, 0, 0));
  EXPECT_FALSE(is_blocked(*scenario.map, 1, 0));
  EXPECT_TRUE(is_blocked(*scenario.map, 3, 1));
  EXPECT_TRUE(is_blocked(*scenario.map, 4, 1));
  EXPECT_EQ(scenario.bounds, (Bounds{-10, 10, 2.5, 12.5}));
  EXPECT_TRUE(scenario.obstacles.empty());
}

TEST_F(ScenarioWithMap, UnknownGroundMayBeFree) {
  const Scenario scenario = read("map: map.yaml\nunknown: free\n");
  EXPECT_TRUE(is_blocked(*scenario.map, 0, 0));
  EXPECT_FALSE(is_blocked(*scenario.map, 3, 1));
  EXPECT_FALSE(is_blocked(*scenario.map, 4, 1));
}

TEST_F(ScenarioWithMap, ObstaclesAndBoundsMayStandBesideIt) {
  const Scenario scenario = read(
      "map: map.yaml\nbounds: {x: [0, 3], y: [1, 4]}\nobstacles: [[[1, 2], [3, 2], [3, 4]]]\n");
  EXPECT_EQ(scenario.bounds, (Bounds{0, 3, 1, 4}));
  EXPECT_EQ(scenario.obstacles.size(), 1U);
}

TEST_F(ScenarioWithMap, IsWrittenAndReadBack) {
  const Scenario scenario = read("map: map.yaml\nunknown: free\n");
  const Scenario again = read_scenario(folder_.put("again.yaml", to_yaml(scenario)));
  expect_equal({again}, {scenario});
  ASSERT_TRUE(again.map);
  EXPECT_EQ(again.map_file, "map.yaml");
  EXPECT_TRUE(again.map->unknown_is_free);
  EXPECT_EQ(*again.map->cells, *scenario.map->cells);
}

TEST_F(ScenarioWithMap, MistakesHaveOneLineEach) {
  EXPECT_EQ(message("map: gone.yaml\n"), "s.yaml:5: map: " + folder_.path() +
                                             "/gone.yaml: cannot open: No such file or directory");
  EXPECT_EQ(message("map: map.yaml\nunknown: grey\n"),
            "s.yaml:6: unknown: is \"grey\", expected free or obstacle");
  EXPECT_EQ(message("bounds: {x: [0, 3], y: [1, 4]}\nunknown: free\nobstacles: []\n"),
            "s.yaml:6: unknown: is given without a map, expected map beside it");
  EXPECT_EQ(message("obstacles: []\n"), "s.yaml:1: key \"bounds\" is missing, expected it");
}

TEST(ScenarioFile, KerbsAreReadAndWritten) {
  const std::string text = valid + "kerbs: [[[10, 2], [12, 2], [12, 4]]]\n";
  const ScenarioFile file = scenario_from_yaml(text, "s.yaml");
  const Scenario& scenario = file.scenario;
  EXPECT_EQ(scenario.kerbs, (std::vector<Polygon>{{{10, 2}, {12, 2}, {12, 4}}}));
  EXPECT_EQ(scenario_from_yaml(to_yaml(file), "s.yaml").scenario.kerbs, scenario.kerbs);
  EXPECT_EQ(message_for_scenario(valid + "kerbs: [[[10, 2], [12, 2]]]\n"),
            "s.yaml:15: kerbs[0]: has 2 corners, expected at least 3");
}

TEST(ScenarioFile, WhatMovesIsReadAndWritten) {
  const std::string text =
      valid +
      "moving:\n"
      "  - {outline: [[-2, -1], [2, -1], [2, 1]], trajectory: [[0, 10, 5, 0]]}\n"
      "  - outline: [[0, 0], [1, 0], [1, 0.1]]\n"
      "    trajectory: [[-1.5, 10, 5, 0], [8, 40, 5, 0.1]]\n"
      "    after: leaves\n"
      "    inflate: 0.25\n";
  const ScenarioFile file = scenario_from_yaml(text, "s.yaml");
  const std::vector<MovingObstacle> expected = {
      {.outline = {{-2, -1}, {2, -1}, {2, 1}}, .trajectory = {{0, {10, 5, 0}}}},
      {.outline = {{0, 0}, {1, 0}, {1, 0.1}},
       .trajectory = {{-1.5, {10, 5, 0}}, {8, {40, 5, 0.1}}},
       .after = Afterwards::leaves,
       .inflate = 0.25}};
  EXPECT_EQ(file.scenario.moving, expected);
  EXPECT_EQ(scenario_from_yaml(to_yaml(file), "s.yaml").scenario.moving, expected);
  EXPECT_EQ(message_for_scenario(exchanged(text, "leaves", "gone")),
            "s.yaml:19: moving[1].after: is \"gone\", expected stays or leaves");
  EXPECT_EQ(
      message_for_scenario(exchanged(text, "[8, 40, 5, 0.1]", "[8, 40, 5]")),
      "s.yaml:18: moving[1].trajectory[1]: has 3 elements, expected a row [t, x, y, heading]");
  EXPECT_EQ(message_for_scenario(exchanged(text, "[8, 40", "[-2, 40")),
            "s.yaml:18: moving[1].trajectory[1]: has the time -2, expected more than that of the "
            "row before, -1.5");
  EXPECT_EQ(message_for_scenario(exchanged(text, "inflate", "inflated")),
            "s.yaml:20: moving[1]: unknown key \"inflated\", did you mean inflate? Expected one of "
            "outline, trajectory, "
            "after, inflate");
}

std::string with_vehicle(const std::string& vehicle) {
  const std::size_t begin = valid.find("{wheelbase");
  return valid.substr(0, begin) + vehicle + valid.substr(valid.find('\n', begin));
}

TEST(ScenarioFile, AVehicleMayBeNamed) {
  const Scenario scenario = scenario_from_yaml(with_vehicle("city-bus"), "s.yaml").scenario;
  EXPECT_TRUE(same_lengths(scenario.vehicle, {7.6, 2.1, 2.4, 2.6, 8.66}));
  EXPECT_EQ(scenario.vehicle.limits.max_steering_rate, 0.71);
  EXPECT_EQ(message_for_scenario(with_vehicle("city-buss")),
            "s.yaml:3: vehicle: is \"city-buss\", did you mean city-bus? Expected one of "
            "car-caravan, city-bus, coach, "
            "three-axle-truck, tpcap-car, tractor-semitrailer, truck-drawbar-trailer, "
            "two-axle-truck, van, a map of lengths, or a file (.yaml)");
}

TEST(ScenarioFile, AVehicleMayBeAFileBesideTheScenario) {
  const TemporaryFolder folder;
  folder.put("truck.yaml", to_yaml(vehicle_named("city-bus")));
  const std::string file = folder.put("s.yaml", with_vehicle("truck.yaml"));
  EXPECT_EQ(read_scenario(file).vehicle, vehicle_named("city-bus"));
  folder.put("truck.yaml", "{wheelbase: far}");
  try {
    (void)read_scenario(file);
    FAIL() << "was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "wheelbase: is \"far\", expected a number");
    EXPECT_TRUE(error.where().ends_with("truck.yaml:1")) << error.where();
  }
}

TEST(ScenarioFile, EveryVehicleOfTheCatalogueIsOne) {
  for (const std::string& name : vehicle_names()) {
    SCOPED_TRACE(name);
    EXPECT_EQ(scenario_from_yaml(with_vehicle(name), "s.yaml").scenario.vehicle,
              vehicle_named(name));
  }
  EXPECT_EQ(vehicle_names().size(), 9U);
  EXPECT_THROW((void)vehicle_named("tank"), InputError);
}

TEST(ScenarioFile, SteeringAndTrackMayBeGiven) {
  const std::string lengths =
      "{wheelbase: 2.8, front_overhang: 0.96, rear_overhang: 0.929, "
      "width: 1.942";
  const Vehicle car =
      scenario_from_yaml(with_vehicle(lengths + ", max_steering_angle: 0.75, track_width: 1.7}"),
                         "s.yaml")
          .scenario.vehicle;
  EXPECT_NEAR(car.min_turning_radius, 3.005593, 1e-6);
  EXPECT_EQ(car.track_width, 1.7);
  EXPECT_EQ(message_for_scenario(with_vehicle(lengths + ", max_steering_angle: 1.6}")),
            "s.yaml:3: vehicle.max_steering_angle: is 1.6, expected more than 0 and less than "
            "1.5707 rad");
  EXPECT_EQ(message_for_scenario(
                with_vehicle(lengths + ", max_steering_angle: 1, min_turning_radius: 7}")),
            "s.yaml:3: vehicle.max_steering_angle: is given beside min_turning_radius, expected "
            "one of the two");
  EXPECT_EQ(message_for_scenario(with_vehicle(lengths + "}")),
            "s.yaml:3: vehicle: key \"min_turning_radius\" is missing, expected either it or "
            "max_steering_angle");
  EXPECT_EQ(
      message_for_scenario(with_vehicle(lengths + ", min_turning_radius: 7, track_width: 0}")),
      "s.yaml:3: vehicle.track_width: is 0, expected more than 0 m");
  EXPECT_EQ(
      message_for_scenario(with_vehicle(lengths + ", min_turning_radius: 7, track_width: 2}")),
      "s.yaml:3: vehicle.track_width: is 2, expected at most the width, 1.942");
}

TEST(ScenarioFile, ARowOfGoalsIsRead) {
  const ScenarioFile file = scenario_from_yaml(valid_row, "s.yaml");
  EXPECT_TRUE(file.is_row());
  ASSERT_EQ(file.size(), 2U);
  EXPECT_EQ(file.scenario.goal, file.row[0].goal);
  EXPECT_EQ(file.row[1].distance, 40);
  EXPECT_EQ(file.row[1].goal, (Pose{40, 0, 0}));
  EXPECT_EQ(file.row[1].obstacles.size(), 1U);
  EXPECT_EQ(scenario_at(file, 1).goal, (Pose{40, 0, 0}));
  EXPECT_EQ(scenario_at(file, 1).obstacles.size(), 1U);
}

TEST(ScenarioFile, AHeadingBeyondAFullTurnIsDoubtedAndItsLineNamed) {
  const auto warnings_for = [](const std::string& text) {
    return scenario_from_yaml(text, "s.yaml").warnings;
  };
  const std::string doubt = "is 90 rad, more than a full turn; 90 degrees are 1.5708 rad";
  EXPECT_EQ(warnings_for(exchanged(valid, "heading: .5", "heading: 90")),
            std::vector{"s.yaml:9: goal.heading: " + doubt});
  EXPECT_EQ(warnings_for(exchanged(valid, "heading: -0.5", "heading: 90")),
            std::vector{"s.yaml:5: start.heading: " + doubt});
  EXPECT_EQ(warnings_for(exchanged(valid_row, "40, y: 0, heading: 0", "40, y: 0, heading: 90")),
            std::vector{"s.yaml:8: goals[1].goal.heading: " + doubt});
  EXPECT_TRUE(warnings_for(exchanged(valid, "heading: .5", "heading: -6.2831853")).empty());
}

TEST(ScenarioFile, WindowsLinesAndAByteOrderMarkAreRead) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : valid) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_equal(scenario_from_yaml(text, "s.yaml"), scenario_from_yaml(valid, "s.yaml"));
}

struct BadFile {
  std::string text;
  std::string message;
};

BadFile spoilt(const std::string& part, const std::string& by, const std::string& message) {
  return {exchanged(valid, part, by), "s.yaml:" + message};
}

BadFile spoilt_row(const std::string& part, const std::string& by, const std::string& message) {
  return {exchanged(valid_row, part, by), "s.yaml:" + message};
}

std::vector<BadFile> bad_files() {
  const std::string no_text = "is not a text file, expected YAML in UTF-8";
  return {
      // Not YAML at all
      {"", "s.yaml:1: is empty, expected keys and values"},
      {"# nothing\n", "s.yaml:1: is empty, expected keys and values"},
      {std::string("\x7f"
                   "ELF\0\1",
                   6),
       "s.yaml:1: " + no_text},
      {valid + "\x04", "s.yaml:15: " + no_text},
      {exchanged(valid, "a test", "caf\xE9"), "s.yaml:2: " + no_text},
      {"hello", "s.yaml:1: is \"hello\", expected a map of keys"},
      {"[1, 2]", "s.yaml:1: is a list, expected a map of keys"},
      {valid + "---\n" + valid, "s.yaml:16: begins a second document, expected one"},
      spoilt("[3, 4]]", "[3, 4]", "12: "),
      spoilt("[3, 4]]", "[3, 4]]]", "11: "),
      // Tricks
      {"a: &a [1]\nb: *a\n", "s.yaml:2: uses an alias (*name), expected the value itself"},
      spoilt("40.5", "!!float 40.5", "4: has a tag (!name), expected the value alone"),
      spoilt("name: yard", "? [a]\n: b", "1: a key is a list, expected a word"),
      {std::string(100, '['),
       "s.yaml:1: lists and maps are nested too deep, expected at most 64 levels"},
      // Keys
      spoilt("width:", "widht:",
             "3: vehicle: unknown key \"widht\", did you mean width? Expected one of wheelbase, "
             "front_overhang, "
             "rear_overhang, width, min_turning_radius, max_steering_angle, track_width, "
             "max_steering_rate, max_curvature_rate, max_speed, max_acceleration, max_braking, "
             "max_lateral_acceleration, max_jerk, hitch, max_hitch_angle, trailers, outline"),
      spoilt("name: yard", "title: yard",
             "1: unknown key \"title\", expected one of name, description, vehicle, bounds, start, "
             "goal, goals, via, obstacles, kerbs, inside, zones, map, unknown, masks, moving, "
             "options, origin"),
      spoilt("name: yard\n", "", "1: key \"name\" is missing, expected it"),
      spoilt("width: 2.55, ", "", "3: vehicle: key \"width\" is missing, expected it"),
      spoilt("  y: 5.25   # metres\n", "", "7: goal: key \"y\" is missing, expected it"),
      spoilt("goal:\n  x: +20\n  y: 5.25   # metres\n  heading: .5\n", "",
             "1: key \"goal\" is missing, expected either goal or goals"),
      spoilt("goal:", "gaol:",
             "6: unknown key \"gaol\", did you mean goal? Expected one of name, description, "
             "vehicle, bounds, start, "
             "goal, goals, via, obstacles, kerbs, inside, zones, map, unknown, masks, moving, "
             "options, origin"),
      spoilt("heading: .5", "y: 6",
             "9: key \"y\" is given again, expected it once (first on line 8)"),
      spoilt("start:", "map: yard.yaml\nstart:",
             "5: map: yard.yaml: cannot open: No such file or directory"),
      spoilt(
          "start:", "goals: []\nstart:", "5: goals: is given beside goal, expected one of the two"),
      // Types
      spoilt("+20", "\"20\"", "7: goal.x: is \"20\", expected a number without quotes"),
      spoilt("+20", "20 m", "7: goal.x: is \"20 m\", expected a number"),
      spoilt("+20", "1,5",
             "7: goal.x: is \"1,5\", expected a number, with a point instead of the comma"),
      spoilt("+20", "0x10", "7: goal.x: is \"0x10\", expected a number"),
      spoilt("+20", "+-20", "7: goal.x: is \"+-20\", expected a number"),
      spoilt("+20", "", "7: goal.x: is empty, expected a number"),
      spoilt("+20", "[20]", "7: goal.x: has 1 element, expected [smallest, largest]"),
      spoilt("+20", ".nan", "7: goal.x: is \".nan\", expected a finite number"),
      spoilt("+20", "-.INF", "7: goal.x: is \"-.INF\", expected a finite number"),
      spoilt("+20", "nan", "7: goal.x: is \"nan\", expected a finite number"),
      spoilt("+20", "1e999", "7: goal.x: is \"1e999\", expected a number that fits a double"),
      spoilt("name: yard", "name: [yard]", "1: name: is a list, expected a text"),
      spoilt("{x: 0, y: 1e-1, heading: -0.5}", "[0, 0.1, 0]",
             "5: start: is a list, expected a map of keys"),
      spoilt("[-50, 50]", "[-50]", "4: bounds.x: has 1 element, expected [smallest, largest]"),
      spoilt("[-50, 50]", "50", "4: bounds.x: is \"50\", expected [smallest, largest]"),
      spoilt("[-1, -2]", "[-1, -2, 0]",
             "12: obstacles[1][0]: has 3 elements, expected a corner [x, y]"),
      spoilt("[-3, -2]", "[-3, here]", "13: obstacles[1][1][1]: is \"here\", expected a number"),
      spoilt("[[1, 2], [3, 2], [3, 4]]", "7",
             "11: obstacles[0]: is \"7\", expected a polygon [[x, y], ...]"),
      {valid.substr(0, valid.find("  - [[1")),
       "s.yaml:10: obstacles: is empty, expected a list of polygons"},
      // One pair of brackets too few
      spoilt("[[1, 2], [3, 2], [3, 4]]", "[1, 2]",
             "11: obstacles[0][0]: is \"1\", expected a corner [x, y]"),
      spoilt("  - - [-1, -2]\n    - [-3, -2]\n    - [-3, -4]\n", "  - {x: 1, y: 2}\n",
             "12: obstacles[1]: is a map of keys, expected a polygon [[x, y], ...]"),
      // Meaning; more of it in problem_test
      spoilt("2.55", "-2.55", "3: vehicle.width: is -2.55, expected more than 0 m"),
      spoilt("[-40, 40.5]", "[40.5, -40]",
             "4: bounds.y: is [40.5, -40], expected the smaller number first"),
      spoilt("heading: .5", "heading: 1e7",
             "9: goal.heading: is 1e+07, expected a number between -1e+06 and 1e+06"),
      spoilt("    - [-3, -4]\n", "", "12: obstacles[1]: has 2 corners, expected at least 3"),
      spoilt("[[1, 2], [3, 2], [3, 4]]", "[[0, 0], [1, 1], [1, 0], [0, 1]]",
             "11: obstacles[0]: crosses or touches itself where the sides that begin at [0, 0] and "
             "[1, 0] meet, expected a simple polygon"),
      // Curvatures, of a radius of 7 m
      spoilt("heading: -0.5", "heading: -0.5, curvature: 0.15",
             "5: start.curvature: is 0.15, expected at most 1 / min_turning_radius, "
             "0.14285714285714285 [1/m]"),
      spoilt("heading: .5", "heading: .5\n  curvature: -.15",
             "10: goal.curvature: is -0.15, expected at most 1 / min_turning_radius, "
             "0.14285714285714285 [1/m]"),
      spoilt("heading: -0.5", "heading: -0.5, curvature: left",
             "5: start.curvature: is \"left\", expected a number"),
      // Options
      spoilt("bounds:", "options: [margin]\nbounds:",
             "4: options: is no map, expected options by their names"),
      spoilt("bounds:", "options: {margin: -1}\nbounds:",
             "4: options.margin: -1 is not a number from 0 to 1000 [m]"),
      spoilt("bounds:", "options: {margin: [1]}\nbounds:",
             "4: options.margin: is a list, expected a text"),
      spoilt(
          "bounds:", "options: {margn: 1}\nbounds:",
          "4: options.margn: unknown option, did you mean margin? Expected one of style, seed, "
          "time_limit, "
          "max_iterations, threads, target_gap, forward_weight, reverse_weight, gear_change_cost, "
          "curvature_change_cost, clearance_weight, clearance_distance, initial_gear, gears, "
          "cost, "
          "margin, "
          "margin_ramp, steering, region, min_stroke"),
      spoilt("bounds:", "options: {seed: 7}\nbounds:",
             "4: options.seed: is an option of the budget, expected one of what is planned: --set "
             "seed=7"),
      spoilt("bounds:", "options: {cost: time, reverse_weight: 2}\nbounds:",
             "4: options.reverse_weight: is a price, expected none beside cost=time"),
      spoilt("bounds:", "zones: [{area: [[1, 2], [3, 2], [3, 4]], direction: 0.5}]\nbounds:",
             "4: zones[0].direction: is \"0.5\", expected [first, last], counter-clockwise"),
      // Rows
      spoilt_row("  - distance: 20\n    goal: {x: 20, y: 0, heading: 0}\n"
                 "  - {distance: 40, goal: {x: 40, y: 0, heading: 0}, obstacles: [[[1, 2], [3, 2], "
                 "[3, 4]]]}\n",
                 "  []\n", "6: goals: is empty, expected at least one goal"),
      spoilt_row("distance: 20\n    ", "", "6: goals[0]: key \"distance\" is missing, expected it"),
      spoilt_row("distance: 20", "distance: far",
                 "6: goals[0].distance: is \"far\", expected a number"),
      spoilt_row("distance: 40", "distance: -40",
                 "8: goals[1].distance: is -40, expected 0 m or more"),
      spoilt_row("x: 40", "x: 1e13",
                 "8: goals[1].goal.x: is 1e+13, expected a number between -1e+12 and 1e+12"),
      spoilt_row("x: 40, y: 0, heading: 0", "x: 40, y: 0, heading: 0, curvature: 1",
                 "8: goals[1].goal.curvature: is 1, expected at most 1 / min_turning_radius, "
                 "0.14285714285714285 [1/m]"),
      spoilt_row("[3, 2], [3, 4]", "[3, 2]",
                 "8: goals[1].obstacles[0]: has 2 corners, expected at least 3"),
      spoilt_row("goals:", "goal:", "6: goal: is a list, expected a map of keys"),
  };
}

TEST(ScenarioFile, EveryErrorNamesLineKeyAndWhatWasExpected) {
  for (const BadFile& bad : bad_files()) {
    const std::string message = message_for_scenario(bad.text);
    // Where the wording is the parser's own only the place is promised.
    if (bad.message.ends_with(": ")) {
      EXPECT_EQ(message.substr(0, bad.message.size()), bad.message);
      EXPECT_NE(message.find("is not YAML ("), std::string::npos) << message;
    } else {
      EXPECT_EQ(message, bad.message);
    }
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(ScenarioFile, WritingAndReadingBackChangesNothing) {
  for (const std::string& text : {valid, valid_row}) {
    ScenarioFile file = scenario_from_yaml(text, "s.yaml");
    Scenario& scenario = file.scenario;
    scenario.name = "quotes \" and \\ and\nlines\tand \x01 v\xC3\xA4nd: #1";
    scenario.start = {1.0 / 3, 984378.24645, -6.11698657169903};
    scenario.goal.y = 984378.5;
    for (RowGoal& goal : file.row) goal.goal.y = 984378.5;
    scenario.curvatures.start = 0.1 / 3;
    scenario.bounds.y_max = 1e10;
    scenario.vehicle.width = 0.1 + 0.2;
    expect_equal(scenario_from_yaml(to_yaml(file), "s.yaml"), file);
  }
}

TEST(ScenarioFile, CurvaturesAtTheEndsAreReadAndWritten) {
  const std::string text =
      exchanged(exchanged(valid, "heading: -0.5", "heading: -0.5, curvature: 0.1"), "heading: .5",
                "heading: .5\n  curvature: -.125");
  const ScenarioFile file = scenario_from_yaml(text, "s.yaml");
  EXPECT_EQ(file.scenario.curvatures, (EndCurvatures{0.1, -0.125}));
  EXPECT_EQ(make_problem(file.scenario).curvatures(), (EndCurvatures{0.1, -0.125}));
  expect_equal(scenario_from_yaml(to_yaml(file), "s.yaml"), file);
  // Straight wheels are not mentioned.
  EXPECT_EQ(to_yaml(scenario_from_yaml(valid, "s.yaml")).find("curvature"), std::string::npos);
}

TEST(ScenarioFile, EachGoalOfARowHasACurvature) {
  const std::string text = exchanged(exchanged(valid_row, "start: {x: 0, y: 0, heading: 0}",
                                               "start: {x: 0, y: 0, heading: 0, curvature: .1}"),
                                     "goal: {x: 40, y: 0, heading: 0}",
                                     "goal: {x: 40, y: 0, heading: 0, curvature: -.125}");
  const ScenarioFile file = scenario_from_yaml(text, "s.yaml");
  EXPECT_EQ(scenario_at(file, 0).curvatures, (EndCurvatures{0.1, 0}));
  EXPECT_EQ(scenario_at(file, 1).curvatures, (EndCurvatures{0.1, -0.125}));
  expect_equal(scenario_from_yaml(to_yaml(file), "s.yaml"), file);
}

TEST(ScenarioFile, OptionsAreReadAndWritten) {
  const std::string text = exchanged(
      valid, "bounds:", "options: {margin: 0.3, initial_gear: forward, goal_bias: .1}\nbounds:");
  const ScenarioFile file = scenario_from_yaml(text, "s.yaml");
  EXPECT_EQ(
      file.options,
      (std::vector<Setting>{{"margin", "0.3"}, {"initial_gear", "forward"}, {"goal_bias", ".1"}}));
  expect_equal(scenario_from_yaml(to_yaml(file), "s.yaml"), file);
  PlanOptions options;
  set_honoured(options, planner_named("rrt-bsc-rs"), file.options);  // which knows no prices
  EXPECT_EQ(options.clearance.margin, 0.3);
  EXPECT_EQ(options.cost.initial_gear, InitialGear::any);
  EXPECT_EQ(options.planner.number("goal_bias"), 0.1);
}

TEST(ScenarioFile, OurScenariosReadBackUnchanged) {
  const auto files = yaml_files(repository() / "scenarios" / "thesis");
  ASSERT_EQ(files.size(), 9U);
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const ScenarioFile scenario = read_scenario_file(file);
    expect_equal(scenario_from_yaml(to_yaml(scenario), "s.yaml"), scenario);
  }
}

TEST(ScenarioFile, OtherPeoplesScenariosAreRead) {
  for (const std::string folder : {"tpcap", "dlp", "maps"}) {
    const auto files = yaml_files(shared_folder() / "scenarios" / folder);
    if (files.empty()) GTEST_SKIP() << "no shared scenarios beside the repository";
    for (const std::string& file : files) {
      SCOPED_TRACE(file);
      if (read_file(file, 1 << 20).find("\nimage: ") != std::string::npos)
        continue;  // a map itself
      EXPECT_NO_THROW((void)read_problems(file));
    }
  }
}

TEST(ScenarioFile, TheFarCaseIsTheSameProblemAsTheNearOne) {
  const auto folder = shared_folder() / "scenarios" / "tpcap";
  if (yaml_files(folder).empty()) GTEST_SKIP() << "no shared scenarios beside the repository";
  const Problem far = make_problem(read_scenario(folder / "case13.yaml"));
  const Problem near = make_problem(read_scenario(folder / "case13-local.yaml"));
  EXPECT_EQ(far.task().start, near.task().start);
  EXPECT_EQ(far.task().goal, near.task().goal);
  EXPECT_EQ(far.world()->local().bounds, near.world()->local().bounds);
  EXPECT_EQ(far.world()->local().obstacles, near.world()->local().obstacles);
}

// 64 MiB of commas asked for 12 GB.
TEST(ScenarioFile, TooManyValuesAreRefused) {
  const auto message = [](const std::string& text) {
    try {
      (void)scenario_from_yaml(text, "s.yaml");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const std::string expected = ": has more than 4000000 values, expected no more";
  EXPECT_EQ(message("name: x\nobstacles: [" + std::string(4'000'000, ',') + "]"),
            "s.yaml:2" + expected);
  EXPECT_EQ(message(std::string(4'000'001, '[')), "s.yaml:1" + expected);
}

}  // namespace
}  // namespace vandplan
