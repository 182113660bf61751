// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Sites that somebody drew on a map.
#include "vandplan/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "io/site_shapes.h"
#include "support/cases.h"
#include "support/problems.h"
#include "support/shared_files.h"
#include "support/temporary_folder.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

/// A feature on a line of its own, `coordinates` with the type of the geometry before them.
std::string feature(const std::string& properties, const std::string& type,
                    const std::string& coordinates) {
  return ",\n{\"type\": \"Feature\", \"properties\": " + properties +
         ", \"geometry\": {\"type\": \"" + type + "\", \"coordinates\": " + coordinates + "}}";
}

const std::string ends =
    feature(R"({"kind": "start", "heading": 0.5})", "Point", "[1, 2]").substr(2) +
    feature(R"({"kind": "goal", "heading_deg": 90})", "Point", "[30, 4]");

std::string collection(const std::string& features, const std::string& member = "") {
  return "{\"type\": \"FeatureCollection\"," + member + " \"features\": [\n" + features + "\n]}\n";
}

PlanStatus planned(const Scenario& scenario) {
  PlanOptions options;
  options.budget.max_iterations = 2000;
  return plan(scenario, options).status;
}

class GeoJson : public testing::Test {
 protected:
  GeoJsonScenario read(const std::string& text, bool is_in_metres = true) {
    GeoJsonSite site{.file = folder_.put("a.geojson", text), .vehicle = vehicle_named("van")};
    site.is_in_metres = is_in_metres;
    return read_geojson(site);
  }
  GeoJsonScenario with(const std::string& more) { return read(collection(ends + more)); }

  std::string message(const std::string& text, bool is_in_metres = true) {
    try {
      (void)read(text, is_in_metres);
    } catch (const InputError& error) {
      std::string line = error.what();
      const std::size_t at = line.find(folder_.path());
      if (at != std::string::npos) line.erase(at, folder_.path().size() + 1);
      return line;
    }
    return "no error";
  }
  std::string message_with(const std::string& more) { return message(collection(ends + more)); }

  TemporaryFolder folder_;
};

const std::string square = "[[[10, 10], [14, 10], [14, 14], [10, 14], [10, 10]]]";

TEST_F(GeoJson, StartGoalVehicleAndNameAreTakenOver) {
  const GeoJsonScenario made = read(collection(ends, "\"name\": \"yard\","));
  EXPECT_EQ(made.scenario.name, "yard");
  EXPECT_EQ(made.scenario.start, (Pose{1, 2, 0.5}));
  EXPECT_EQ(made.scenario.goal, (Pose{30, 4, std::numbers::pi / 2}));
  EXPECT_EQ(made.scenario.vehicle, vehicle_named("van"));
  EXPECT_EQ(made.scenario.bounds, (Bounds{-19, 50, -18, 24}));  // 20 m around both
  EXPECT_EQ(made.origin, std::nullopt);
  EXPECT_TRUE(made.notes.empty());
  EXPECT_EQ(with("").scenario.name, "a");
}

TEST_F(GeoJson, KindTagOrShapeSayWhatAFeatureIs) {
  const auto counts = [&](const std::string& properties, const std::string& type,
                          const std::string& coordinates) {
    const Scenario scenario = with(feature(properties, type, coordinates)).scenario;
    return std::pair(scenario.obstacles.size(), scenario.kerbs.size());
  };
  using Counts = std::pair<std::size_t, std::size_t>;
  const std::string line = "[[10, 10], [14, 10], [14, 14]]";
  const std::string two = "[" + square + ", [[[20, 10], [24, 10], [24, 14], [20, 10]]]]";
  EXPECT_EQ(counts("null", "Polygon", square), Counts(1, 0));
  EXPECT_EQ(counts("{}", "MultiPolygon", two), Counts(2, 0));
  EXPECT_EQ(counts(R"({"kind": "kerb"})", "MultiPolygon", two), Counts(0, 2));
  EXPECT_EQ(counts(R"({"kind": "obstacle", "landuse": "forest"})", "Polygon", square),
            Counts(1, 0));
  EXPECT_EQ(counts(R"({"building": "yes", "amenity": "school"})", "Polygon", square), Counts(1, 0));
  EXPECT_EQ(counts(R"({"building": "no", "amenity": "parking"})", "Polygon", square), Counts(0, 0));
  EXPECT_EQ(counts(R"({"building": null, "landuse": null, "surface": ""})", "Polygon", square),
            Counts(1, 0));
  EXPECT_EQ(counts(R"({"barrier": "kerb"})", "LineString", line), Counts(0, 2));
  EXPECT_EQ(counts(R"({"barrier": "fence"})", "MultiLineString", "[" + line + "]"), Counts(2, 0));
  EXPECT_EQ(counts(R"({"barrier": "no"})", "LineString", line), Counts(0, 0));
  EXPECT_EQ(counts(R"({"width": 0.5})", "LineString", line), Counts(2, 0));
  EXPECT_EQ(counts(R"({"power": "line"})", "LineString", line), Counts(0, 0));
  EXPECT_EQ(counts(R"({"barrier": "bollard"})", "Point", "[10, 10]"), Counts(1, 0));
  EXPECT_EQ(counts(R"({"barrier": "gate"})", "Point", "[10, 10]"), Counts(0, 0));
  EXPECT_EQ(counts(R"({"building": "yes"})", "Point", "[10, 10]"), Counts(0, 0));
  EXPECT_EQ(counts(R"({"kind": "obstacle"})", "MultiPoint", "[[10, 10], [12, 12]]"), Counts(2, 0));
  EXPECT_EQ(counts(R"({"natural": "tree"})", "Point", "[10, 10]"), Counts(0, 0));
}

TEST_F(GeoJson, WhatIsLeftOutIsSaid) {
  const GeoJsonScenario made =
      with(feature(R"({"highway": "service"})", "LineString", "[[0, 0], [9, 0]]") +
           feature(R"({"highway": "footway"})", "LineString", "[[0, 0], [9, 0]]") +
           feature(R"({"power": "line"})", "LineString", "[[0, 0], [9, 0]]") +
           ",\n{\"type\": \"Feature\", \"properties\": {}, \"geometry\": null}");
  EXPECT_EQ(made.notes,
            (std::vector<std::string>{"left out: highway (2), line without kind or width "
                                      "(1), without geometry (1)"}));
}

TEST_F(GeoJson, LinesAndPointsAreAsWideAsTheySay) {
  const auto one = [&](const std::string& width) {
    return with(feature(R"({"barrier": "wall", "width": )" + width + "}", "LineString",
                        "[[10, 10], [14, 10]]"))
        .scenario.obstacles.at(0);
  };
  const Polygon expected = {{10, 9.75}, {14, 9.75}, {14, 10.25}, {10, 10.25}};
  EXPECT_EQ(one("0.5"), expected);
  EXPECT_EQ(one("\"0.5\""), expected);
  EXPECT_EQ(one("\"0.5 m\""), expected);
  EXPECT_EQ(one("null"), (Polygon{{10, 9.9}, {14, 9.9}, {14, 10.1}, {10, 10.1}}));
  const Scenario point =
      with(feature(R"({"kind": "obstacle", "width": 2})", "Point", "[10, 12]")).scenario;
  EXPECT_EQ(point.obstacles.at(0), (Polygon{{9, 11}, {11, 11}, {11, 13}, {9, 13}}));
}

TEST_F(GeoJson, BoundsAreTheBoxAroundTheirPolygon) {
  const GeoJsonScenario made = with(feature(
      R"({"kind": "bounds"})", "Polygon", "[[[-5, -6], [40, -7], [41, 20], [-5, 20], [-5, -6]]]"));
  EXPECT_EQ(made.scenario.bounds, (Bounds{-5, 41, -7, 20}));
  EXPECT_TRUE(made.scenario.obstacles.empty());
}

const std::string ring =
    "[[[-50, -50], [50, -50], [50, 50], [-50, 50], [-50, -50]],"
    " [[-40, -40], [40, -40], [40, 40], [-40, 40], [-40, -40]]]";

TEST_F(GeoJson, TheBodyStaysInBoundsThatAreNoBox) {
  const auto drawn = [&](const std::string& corners) {
    return with(feature(R"({"kind": "bounds"})", "Polygon", corners));
  };
  const GeoJsonScenario triangle = drawn("[[[0,0],[60,0],[0,60],[0,0]]]");
  EXPECT_EQ(triangle.scenario.inside, (std::vector<Polygon>{{{0, 0}, {60, 0}, {0, 60}}}));
  EXPECT_EQ(triangle.scenario.bounds, (Bounds{0, 60, 0, 60}));
  EXPECT_TRUE(triangle.warnings.empty());
  EXPECT_TRUE(drawn("[[[0,0],[60,0],[60,50],[0,50],[0,0]]]").scenario.inside.empty());
}

TEST_F(GeoJson, AnObstacleAroundStartOrGoalIsSaid) {
  const auto drawn = [&](const std::string& corners) {
    return with(feature(R"({"building": "yes"})", "Polygon", corners)).warnings;
  };
  const std::vector<std::string> field = drawn("[[[0,0],[60,0],[60,50],[0,50],[0,0]]]");
  ASSERT_EQ(field.size(), 1U);
  EXPECT_NE(field[0].find("is an obstacle with start and goal in it"), std::string::npos);
  EXPECT_NE(drawn("[[[0,0],[9,0],[9,9],[0,9],[0,0]]]").at(0).find("with the start in it"),
            std::string::npos);
  EXPECT_EQ(drawn("[[[10,0],[19,0],[19,9],[10,9],[10,0]]]").size(), 0U);
}

TEST_F(GeoJson, AHoleWithoutStartAndGoalIsFilled) {
  const GeoJsonScenario made = with(
      feature("{}", "Polygon",
              square.substr(0, square.size() - 1) + ", [[11, 11], [12, 11], [12, 12], [11, 11]]]"));
  ASSERT_EQ(made.scenario.obstacles.size(), 1U);
  EXPECT_EQ(made.scenario.obstacles[0], (Polygon{{10, 10}, {14, 10}, {14, 14}, {10, 14}}));
  EXPECT_EQ(made.notes, (std::vector<std::string>{"holes filled: 1"}));
}

// A wall around the yard is drawn like that.
TEST_F(GeoJson, AHoleWithTheStartStaysOpenBehindItsRings) {
  const GeoJsonScenario made = with(feature("{}", "Polygon", ring));
  EXPECT_EQ(made.scenario.obstacles.size(), 8U);
  ASSERT_EQ(made.notes.size(), 1U);
  EXPECT_NE(made.notes[0].find(":4: features[2]: start or goal lies in a hole"), std::string::npos)
      << made.notes[0];
  EXPECT_EQ(planned(made.scenario), PlanStatus::solved);
  Scenario outside = made.scenario;
  outside.goal = {70, 0, 0};
  outside.bounds = {-90, 90, -90, 90};
  EXPECT_EQ(planned(outside), PlanStatus::no_path);
}

// Whatever is within half of the width of a line is in one of its rectangles.
TEST_F(GeoJson, WallsLeaveNoGapAtBends) {
  for_each_case(7, cases(400), [](Rng& rng) {
    std::vector<Point> line;
    const auto number = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(rng() >> 11U) / 9007199254740992.0;
    };
    for (int i = 0; i < 6; ++i) line.push_back({number(-5, 5), number(-5, 5)});
    const double width = number(0.01, 2);
    const std::vector<Polygon> walls = io::walls_along(line, width);
    ASSERT_EQ(walls.size(), 5U);
    for (int i = 0; i < 50; ++i) {
      const std::size_t corner = 1 + rng() % 4;
      const double angle = number(0, 2 * std::numbers::pi);
      const double reach = number(0, 0.499 * width);
      const Point point = {line[corner].x + reach * std::cos(angle),
                           line[corner].y + reach * std::sin(angle)};
      EXPECT_TRUE(
          std::ranges::any_of(walls, [&](const Polygon& wall) { return contains(wall, point); }));
    }
  });
}

TEST_F(GeoJson, KnownPlanesAreTakenAsTheyAre) {
  const auto crs = [](const std::string& name) {
    return R"("crs": {"type": "name", "properties": {"name": ")" + name + "\"}},";
  };
  for (const char* const name : {"urn:ogc:def:crs:EPSG::3006", "EPSG:25832", "EPSG:32733"}) {
    const GeoJsonScenario made = read(collection(ends, crs(name)), false);
    EXPECT_EQ(made.scenario.start, (Pose{1, 2, 0.5})) << name;
    EXPECT_EQ(made.origin, std::nullopt);
  }
  EXPECT_EQ(message(collection(ends, crs("EPSG:3857")), false),
            "a.geojson:1: crs.properties.name: is \"EPSG:3857\", expected longitude and latitude "
            "(CRS84, EPSG:4326) or a known plane in metres (UTM, SWEREF 99); --metres takes the "
            "coordinates as metres");
  EXPECT_EQ(message(collection(ends, crs("EPSG:3857")), true), "no error");
}

TEST_F(GeoJson, LongitudesAndLatitudesBecomeMetres) {
  if (!reads_longitudes()) GTEST_SKIP() << "built without GeographicLib";
  const std::string site =
      feature(R"({"kind": "start", "heading": 0})", "Point", "[12, 60]").substr(2) +
      feature(R"({"kind": "goal", "heading": 0})", "Point", "[12.001, 60.001]");
  for (const std::string crs : {"", "urn:ogc:def:crs:OGC:1.3:CRS84", "EPSG:4326"}) {
    const std::string member =
        crs.empty() ? "" : R"("crs": {"type": "name", "properties": {"name": ")" + crs + "\"}},";
    const GeoJsonScenario made = read(collection(site, member), false);
    EXPECT_EQ(made.origin, (GeoPlace{12, 60}));
    EXPECT_EQ(made.scenario.start, (Pose{0, 0, 0}));
    // By the radii of curvature of WGS84 at 60 degrees: 0.001 degrees are 55.8 m and 111.4 m.
    EXPECT_NEAR(made.scenario.goal.x, 55.800, 0.003);
    EXPECT_NEAR(made.scenario.goal.y, 111.412, 0.003);
  }
  EXPECT_EQ(message(collection(site + feature("{}", "Polygon", square)), false),
            "a.geojson:4: features[2].geometry.coordinates[0][0]: is [10, 10], expected a place "
            "within 100 km of the start");
  EXPECT_EQ(
      message(collection(ends + feature("{}", "Polygon", "[[[10, 91]]]")), false),
      "a.geojson:3: features[1].geometry.coordinates: is [30, 4], expected a place within 100 km "
      "of the start");
  EXPECT_EQ(
      message(
          collection(feature(R"({"kind": "start", "heading": 0})", "Point", "[674032, 6580822]")
                         .substr(2) +
                     feature(R"({"kind": "goal", "heading": 0})", "Point", "[674032, 6580822]")),
          false),
      "a.geojson:2: features[0].geometry.coordinates: is [674032, 6580822], expected longitude "
      "and latitude in degrees, at most 90 of latitude; --metres takes the coordinates as metres");
}

TEST_F(GeoJson, TheExampleIsPlanned) {
  if (!reads_longitudes()) GTEST_SKIP() << "built without GeographicLib";
  const GeoJsonScenario made =
      read_geojson({.file = (repository() / "examples/yard.geojson").string(),
                    .vehicle = vehicle_named("two-axle-truck")});
  EXPECT_EQ(made.scenario.obstacles.size(), 2U + 3U + 2U + 1U);
  EXPECT_EQ(made.scenario.kerbs.size(), 6U);
  EXPECT_EQ(made.notes,
            (std::vector<std::string>{"left out: highway (1), landuse (1)", "holes filled: 1"}));
  EXPECT_EQ(planned(made.scenario), PlanStatus::solved);
}

TEST_F(GeoJson, GivenEndsReplaceThoseOfTheFile) {
  GeoJsonSite site{.file = folder_.put("a.geojson", collection(ends)),
                   .vehicle = vehicle_named("van"),
                   .is_in_metres = true};
  site.start = Pose{5, 6, 1};
  EXPECT_EQ(read_geojson(site).scenario.start, (Pose{5, 6, 1}));
  EXPECT_EQ(read_geojson(site).scenario.goal.x, 30);
}

TEST_F(GeoJson, AHeadingInDegreesIsDoubted) {
  const std::string site =
      feature(R"({"kind": "start", "heading": 90})", "Point", "[1, 2]").substr(2) +
      feature(R"({"kind": "goal", "heading": 0})", "Point", "[30, 4]");
  const std::vector<std::string> warnings = read(collection(site)).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find(":2: features[0].properties.heading: is 90 rad"), std::string::npos)
      << warnings[0];
}

TEST_F(GeoJson, ZonesStreetsAndSpeedsBecomeZones) {
  const Scenario made =
      with(feature(R"({"kind": "zone", "name": "lawn", "closed": true, "body": true})", "Polygon",
                   square) +
           feature(R"({"kind": "speed", "max_speed": 2.5})", "Polygon", square) +
           feature(R"({"kind": "one-way", "heading_deg": 90, "gears": "forward", "cost": 2})",
                   "Polygon", square) +
           feature(R"({"kind": "one-way", "direction": [0, 1]})", "MultiPolygon",
                   "[" + square + "]") +
           feature(R"({"kind": "one-way", "width": 4})", "LineString", "[[0, 0], [9, 0], [9, 9]]"))
          .scenario;
  const Polygon area = box(10, 10, 14, 14);
  const double quarter = std::numbers::pi / 2;
  ASSERT_EQ(made.zones.size(), 6U);
  EXPECT_EQ(made.zones[0], (Zone{.name = "lawn", .area = area, .closed = true, .body = true}));
  EXPECT_EQ(made.zones[1], (Zone{.area = area, .max_speed = 2.5}));
  EXPECT_EQ(made.zones[2], (Zone{.area = area,
                                 .gears = AllowedGears::forward,
                                 .direction = HeadingRange{0, 2 * quarter},
                                 .cost = 2}));
  EXPECT_EQ(made.zones[3], (Zone{.area = area, .direction = HeadingRange{0, 1}}));
  EXPECT_EQ(made.zones[4].direction, (HeadingRange{-quarter, quarter}));
  EXPECT_EQ(bounding_box(made.zones[4].area), (Bounds{0, 9, -2, 2}));
  EXPECT_EQ(made.zones[5].direction, (HeadingRange{0, 2 * quarter}));
  EXPECT_TRUE(made.obstacles.empty());
  EXPECT_EQ(message_with(feature(R"({"kind": "speed"})", "Polygon", square)),
            "a.geojson:4: features[2]: key \"max_speed\" is missing, expected a speed in m/s");
  EXPECT_EQ(message_with(feature(R"({"kind": "one-way"})", "Polygon", square)),
            "a.geojson:4: features[2]: is one-way without direction, heading or heading_deg");
  EXPECT_EQ(message_with(feature(R"({"kind": "zone"})", "Polygon", square)),
            "a.geojson:4: features[2]: has no rule, expected closed, gears, direction, cost or "
            "max_speed");
  EXPECT_EQ(
      message_with(feature(R"({"kind": "zone", "gears": "all"})", "Polygon", square)).substr(0, 43),
      "a.geojson:4: features[2].properties.gears: ");
  EXPECT_EQ(
      message_with(feature(R"({"kind": "zone", "cost": 2})", "LineString", "[[0, 0], [9, 0]]")),
      "a.geojson:4: features[2].geometry: is a LineString, expected a Polygon, or a "
      "LineString that is one-way");
}

TEST_F(GeoJson, WhatCannotBeUsedHasOneLineEach) {
  EXPECT_EQ(message("{\"type\": \"Topology\"}"),
            "a.geojson:1: type: is \"Topology\", expected FeatureCollection");
  EXPECT_EQ(message("[1,"),
            "a.geojson:1: is not JSON (syntax error while parsing value - "
            "unexpected end of input), expected GeoJSON");
  EXPECT_EQ(message(collection("")),
            "a.geojson:1: has no start, expected a Point with kind \"start\" and a heading, or "
            "--start X,Y,HEADING");
  EXPECT_EQ(message_with(feature(R"({"kind": "start", "heading": 0})", "Point", "[1, 2]")),
            "a.geojson:4: features[2]: is a start once more, expected one");
  EXPECT_EQ(
      message(collection(feature(R"({"kind": "goal"})", "Point", "[1, 2]").substr(2))),
      "a.geojson:2: features[0]: key \"heading\" is missing, expected either it or heading_deg");
  EXPECT_EQ(message_with(feature(R"({"kind": "goal", "heading": 0})", "Polygon", square)),
            "a.geojson:4: features[2].geometry: is a Polygon, expected a Point for start and goal");
  EXPECT_EQ(
      message_with(feature(R"({"kind": "house"})", "Polygon", square)),
      "a.geojson:4: features[2].properties.kind: is \"house\", expected obstacle, kerb, bounds, "
      "zone, one-way, speed, start, goal or ground");
  EXPECT_EQ(message_with(feature(R"({"width": "6'"})", "LineString", "[[0, 0], [1, 1]]")),
            "a.geojson:4: features[2].properties.width: is \"6'\", expected a number of metres");
  EXPECT_EQ(message_with(feature(R"({"width": -1})", "LineString", "[[0, 0], [1, 1]]")),
            "a.geojson:4: features[2].properties.width: is -1 m, expected 0.001 to 1000 m");
  EXPECT_EQ(message_with(feature(R"({"width": 1})", "LineString", "[[1, 1], [1, 1]]")),
            "a.geojson:4: features[2].geometry.coordinates: has no length, expected a line of two "
            "places");
  EXPECT_EQ(message_with(feature("{}", "Polygon", "[[[0, 0], [1, 0], [1, 1], [0, 1]]]")),
            "a.geojson:4: features[2].geometry.coordinates[0]: ends elsewhere than it begins, "
            "expected a closed ring");
  EXPECT_EQ(
      message_with(feature("{}", "Polygon", "[[[0, 0], [1, 0], [0, 0]]]")),
      "a.geojson:4: features[2].geometry.coordinates[0]: has 3 positions, expected a ring of at "
      "least 4");
  EXPECT_EQ(message_with(feature("{}", "GeometryCollection", "[]")),
            "a.geojson:4: features[2].geometry.type: is \"GeometryCollection\", expected Polygon, "
            "LineString, Point, or a Multi of these");
  EXPECT_EQ(message_with(feature("{}", "Polygon", "[[[0, 0], [9, 9], [9, 0], [0, 9], [0, 0]]]"))
                .substr(0, 26),
            "a.geojson:4: features[2]: ");
  EXPECT_EQ(message_with(feature(R"({"kind": "bounds"})", "Polygon", square) +
                         feature(R"({"kind": "bounds"})", "Polygon", square)),
            "a.geojson:5: features[3]: are bounds once more, expected one feature of that kind");
  EXPECT_EQ(
      message_with(feature("{}", "Polygon", "[[[0], [9, 9], [9, 0], [0]]]")),
      "a.geojson:4: features[2].geometry.coordinates[0][0]: has 1 elements, expected a position "
      "[x, y]");
}

}  // namespace
}  // namespace vandplan
