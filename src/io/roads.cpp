// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/roads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/polygon.h"
#include "io/ground.h"
#include "io/lane_edges.h"
#include "io/levels.h"
#include "io/xml.h"
#include "problem/checks.h"
#include "vandplan/input_error.h"

namespace vandplan::io {
namespace {

using std::numbers::pi;

constexpr double least_step = 0.001;  // Least distance that has a direction [m].
constexpr double bend = pi / 6;       // Largest range of directions within one zone [rad].
constexpr double askew = pi / 4;      // Largest angle between overlapping lanes with zones [rad].
constexpr double quarter_turn = 1.5708;  // Quarter turn, rounded up [rad].
constexpr double room = 20.0;            // Distance between the ground and the bounds [m].
constexpr double furthest = 1e6;         // Largest distance from the start along each axis [m].

/// Part of a lane with about one direction.
struct Piece {
  std::size_t lane = 0;  // Index of the lane.
  Ring ring;
  double heading = 0.0;  // Direction of travel [rad].
};

/// Divides a lane into pieces where it has turned by `bend`.
void add_pieces(const Lane& lane, std::size_t index, std::vector<Piece>& pieces) {
  const Edges edges(lane);
  Cut begin;
  Cut at;
  const auto close = [&] {
    const Point from = edges.middle(begin);
    const Point to = edges.middle(at);
    if (auto ring = ring_of(edges.outline_between(begin, at))) {
      pieces.push_back({index, std::move(*ring), std::atan2(to.y - from.y, to.x - from.x)});
    }
    begin = at;
  };
  std::optional<double> first;  // Direction of the first step of the piece.
  Interval turned;              // Directions of its steps, less the first.
  while (!edges.is_end(at)) {
    const Cut next = edges.after(at);
    const Point from = edges.middle(at);
    const Point to = edges.middle(next);
    if (distance(from, to) >= least_step) {
      const double direction = std::atan2(to.y - from.y, to.x - from.x);
      const double turn = first ? wrap_angle(direction - *first) : 0.0;
      turned = {std::min(turned.least, turn), std::max(turned.most, turn)};
      if (!first || turned.most - turned.least > bend) {
        if (first) close();
        first = direction;
        turned = {};
      }
    }
    at = next;
  }
  close();
}

/// Whether two pieces overlap so that no direction of travel would be right in both.
bool exclude_each_other(const Piece& one, const Piece& other, const Roads& roads, Effort& effort) {
  const bool are_alike = roads.lanes[one.lane].is_one_way && roads.lanes[other.lane].is_one_way &&
                         std::abs(wrap_angle(one.heading - other.heading)) <= askew;
  return one.lane != other.lane && !are_alike && overlap(one.ring, other.ring, effort);
}

/// What keeps a polygon from being simple in a scenario with that start; empty if it is simple.
std::string flaw_of(const Polygon& polygon, const Pose& start) {
  const Point origin = problem::local_origin({start.x, start.y});
  Polygon local;
  for (const Point& corner : polygon) local.push_back(problem::local_point(corner, origin));
  return geometry::flaw_of(geometry::cleaned(local), origin);
}

/// Speed limit rounded down to 0.1 mm/s.
std::optional<double> rounded_down(std::optional<double> speed) {
  if (speed) *speed = std::max(1e-4, std::floor(*speed * 1e4) / 1e4);
  return speed;
}

/// Adds zones of lanes with a direction, except where lanes cross, or with a speed limit. Returns
/// the number of pieces that lack a zone.
int add_zones(const Roads& roads, bool both_ways, Scenario& scenario) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < roads.lanes.size(); ++i) add_pieces(roads.lanes[i], i, pieces);
  std::vector<Ring> rings;
  rings.reserve(pieces.size());
  for (const Piece& piece : pieces) rings.push_back(piece.ring);
  const Ground ground(std::move(rings));
  Effort effort;
  int without_zone = 0;
  for (const Piece& piece : pieces) {
    const Lane& lane = roads.lanes[piece.lane];
    const bool has_direction = lane.is_one_way && !both_ways;
    if (!has_direction && !lane.max_speed) continue;
    Zone zone{
        .name = lane.name, .area = piece.ring.corners, .max_speed = rounded_down(lane.max_speed)};
    const std::vector<std::size_t> near = ground.near(piece.ring.box);
    const bool is_crossed = has_direction && std::ranges::any_of(near, [&](std::size_t other) {
                              return exclude_each_other(piece, pieces[other], roads, effort);
                            });
    const bool is_simple = flaw_of(piece.ring.corners, scenario.start).empty();
    if (is_crossed || !is_simple) ++without_zone;
    if (!is_simple || (is_crossed && !lane.max_speed)) continue;
    if (has_direction && !is_crossed) {
      const double heading = std::round(piece.heading * 1e4) / 1e4;
      zone.direction = HeadingRange{heading - quarter_turn, heading + quarter_turn};
    }
    scenario.zones.push_back(std::move(zone));
  }
  return without_zone;
}

void expect_simple(const MapObstacle& obstacle, const Pose& start) {
  if (const std::string flaw = flaw_of(obstacle.outline, start); !flaw.empty()) {
    throw InputError(obstacle.place, flaw);
  }
}

/// Throws unless all places are near enough to the start that numbers stay exact.
void expect_near(const Polygon& corners, const Pose& start) {
  for (const Point& corner : corners) {
    if (std::abs(corner.x - start.x) <= furthest && std::abs(corner.y - start.y) <= furthest) {
      continue;
    }
    throw InputError(
        "lanes", fmt::format("reach to {}, {}, expected at most 1000 km from the start", corner.x,
                             corner.y));
  }
}

/// Throws unless one of the goals has a place on the ground.
void expect_goals_on_ground(const std::vector<Ring>& ground, const std::vector<GoalRegion>& goals) {
  for (const GoalRegion& goal : goals) {
    const auto& [x, y] = std::pair{goal.x, goal.y};
    const Polygon box = {
        {x.least, y.least}, {x.most, y.least}, {x.most, y.most}, {x.least, y.most}};
    const Polygon& area = goal.area.empty() ? box : goal.area;
    if (std::ranges::any_of(ground, [&](const Ring& ring) { return touch(area, ring); })) return;
  }
  throw InputError("goal",
                   "is beside all lanes and areas, expected a place on one of them, or open edges");
}

void expect_on_ground(const std::vector<Ring>& ground, const Pose& pose, const char* name) {
  const Point place = {pose.x, pose.y};
  const bool is_on_ground =
      std::ranges::any_of(ground, [&](const Ring& ring) { return contains(ring.corners, place); });
  if (is_on_ground) return;
  throw InputError(name, fmt::format("is at {}, {}, beside all lanes and areas, expected a place "
                                     "on one of them",
                                     pose.x, pose.y));
}

/// Box around everything of a scenario, plus `room`; rounded to millimetres.
Bounds bounds_around(const Scenario& scenario, const std::vector<Ring>& ground) {
  std::vector<Point> points = {{scenario.start.x, scenario.start.y}};
  if (scenario.goal_set.empty()) points.push_back({scenario.goal.x, scenario.goal.y});
  for (const GoalRegion& region : scenario.goal_set) {
    points.insert(points.end(), region.area.begin(), region.area.end());
    if (region.area.empty()) points.push_back({region.x.most, region.y.most});
  }
  for (const Ring& ring : ground) {
    points.insert(points.end(), ring.corners.begin(), ring.corners.end());
  }
  for (const Polygon& polygon : scenario.obstacles) {
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  const Bounds box = bounding_box(points);
  const auto millimetres = [](double metres) { return std::round(metres * 1000) / 1000; };
  return {millimetres(box.x_min - room), millimetres(box.x_max + room),
          millimetres(box.y_min - room), millimetres(box.y_max + room)};
}

void tell(const Roads& roads, int without_zone, RoadScenario& result) {
  result.notes.push_back(fmt::format("lanes: {}, areas: {}, zones: {}", roads.lanes.size(),
                                     roads.areas.size(), result.file.scenario.zones.size()));
  if (without_zone > 0) {
    result.notes.push_back(fmt::format(
        "parts of one-way lanes open to both directions, where lanes cross: {}", without_zone));
  }
  std::string text;
  for (const auto& [what, count] : roads.left_out) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", what, count);
  }
  if (!text.empty()) result.file.warnings.push_back("left out: " + text);
}

}  // namespace

Polygon outline(const Lane& lane) {
  Polygon corners = lane.left;
  corners.insert(corners.end(), lane.right.rbegin(), lane.right.rend());
  return corners;
}

std::optional<double> speed_from(double number, std::string_view unit) {
  double factor = 0.0;
  if (is_any_of(unit, {"m/s", "mps"})) factor = 1.0;
  if (is_any_of(unit, {"km/h", "kmh"})) factor = 1.0 / 3.6;
  if (unit == "mph") factor = 0.44704;
  const double speed = number * factor;
  if (!(speed > 0.0)) return {};
  return speed;
}

void add_roads(Roads roads, const RoadRules& rules, RoadScenario& result) {
  Scenario& scenario = result.file.scenario;
  keep_level({scenario.start.x, scenario.start.y}, {scenario.goal.x, scenario.goal.y}, roads);
  std::vector<Ring> rings;
  const auto add = [&](const Polygon& polygon) {
    expect_near(polygon, scenario.start);
    if (auto ring = ring_of(polygon)) rings.push_back(std::move(*ring));
  };
  for (const Lane& lane : roads.lanes) add(outline(lane));
  for (const MapArea& area : roads.areas) add(area.outline);
  for (const MapObstacle& obstacle : roads.obstacles) {
    expect_near(obstacle.outline, scenario.start);
    expect_simple(obstacle, scenario.start);
    scenario.obstacles.push_back(obstacle.outline);
  }
  scenario.bounds = bounds_around(scenario, rings);
  if (!rules.open_edges && !rings.empty()) {
    expect_on_ground(rings, scenario.start, "start");
    if (scenario.goal_set.empty()) {
      expect_on_ground(rings, scenario.goal, "goal");
    } else {
      expect_goals_on_ground(rings, scenario.goal_set);
    }
    const std::vector<Polygon> walls = walls_around(Ground(std::move(rings)));
    scenario.obstacles.insert(scenario.obstacles.end(), walls.begin(), walls.end());
  }
  scenario.kerbs.insert(scenario.kerbs.end(), roads.kerbs.begin(), roads.kerbs.end());
  tell(roads, add_zones(roads, rules.both_ways, scenario), result);
  check_scenario(scenario);
}

void add_roads(Roads roads, const RoadMap& map, const std::string& place, RoadScenario& result) {
  try {
    add_roads(std::move(roads), map.rules, result);
  } catch (const InputError& error) {
    const std::string& key = error.where();
    if (key.starts_with("start") || key.starts_with("goal")) {
      throw InputError("--" + key, error.problem());
    }
    if (key.find(':') != std::string::npos) throw;  // A place of the file.
    throw InputError(place, key + ": " + error.problem());
  }
}

}  // namespace vandplan::io
