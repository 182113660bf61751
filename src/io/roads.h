// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do lanes and areas of a map bind a vehicle?
//
// The ground is the union of all lanes and areas. Walls around it keep the body on it. A lane that
// is one-way or has a speed limit is divided into zones.

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/files.h"

namespace vandplan::io {

/// A lane between two lines.
struct Lane {
  std::string name = {};          ///< name for people: "lanelet 12"
  std::vector<Point> left = {};   ///< left edge in the direction of travel [m]
  std::vector<Point> right = {};  ///< right edge in the direction of travel [m]
  /// Height of each corner of the edges [m]; empty: 0.
  std::vector<double> left_heights = {}, right_heights = {};
  bool is_one_way = true;
  std::optional<double> max_speed = {};  ///< speed limit [m/s]
};

/// Further ground of a map, such as a car park.
struct MapArea {
  Polygon outline = {};  ///< its outline [m]
  double height = 0.0;   ///< its height [m]
};

/// An obstacle of a map.
struct MapObstacle {
  Polygon outline = {};    ///< its outline [m]
  std::string place = {};  ///< where the file has it: "map.osm:12"
  /// Heights of its lowest and highest point [m].
  Interval heights = {-std::numeric_limits<double>::infinity(),
                      std::numeric_limits<double>::infinity()};
};

/// What a map says about the ground, in the frame of the scenario.
struct Roads {
  std::vector<Lane> lanes = {};
  std::vector<MapArea> areas = {};           ///< further ground
  std::vector<MapObstacle> obstacles = {};   ///< what stands on the ground
  std::vector<Polygon> kerbs = {};           ///< what wheels may not cross
  std::map<std::string, int> left_out = {};  ///< what else the map has, and how often
};

/// Outline of a lane.
[[nodiscard]] Polygon outline(const Lane& lane);

/// Speed [m/s] of a number with a unit: "km/h" or "kmh", "mph", "m/s" or "mps". Nothing if the unit
/// is another one, or if the speed is not positive.
[[nodiscard]] std::optional<double> speed_from(double number, std::string_view unit);

/// Adds obstacles, walls, zones, notes and a warning of what is left out to a scenario that has
/// start and goal, sets its bounds, and checks it. Throws InputError naming the place of an
/// obstacle, "start" or "goal" if that pose or all of a set of goals is beside the ground, or
/// another key of the scenario.
void add_roads(Roads roads, const RoadRules& rules, RoadScenario& result);

/// `add_roads` for a map whose user gives start and goal by flags. Errors name "--start", "--goal"
/// or a place of the file; `place` stands for the whole file.
void add_roads(Roads roads, const RoadMap& map, const std::string& place, RoadScenario& result);

}  // namespace vandplan::io
