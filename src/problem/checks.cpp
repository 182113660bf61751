// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "base/decimal.h"
#include "base/text.h"
#include "geometry/convex.h"
#include "geometry/polygon.h"
#include "vandplan/input_error.h"
#include "vandplan/problem.h"

namespace vandplan {
namespace problem {
namespace {

constexpr double largest_coordinate = 1e12;  // scenario's frame [m]; doubles are 0.1 mm apart there
constexpr double largest_reach = 1e6;     // half the side of a world [m]; paths still close there
constexpr double largest_distance = 1e5;  // distance from start to goal [m]
constexpr double largest_heading = 1e6;   // size of an angle [rad]; wrapping is exact to 1e-9 rad
constexpr double largest_length = 1e6;    // size of vehicles and map cells [m]
constexpr double smallest_length = 1e-6;  // size of vehicles and map cells where 0 is wrong [m]

void require(bool holds, const std::string& where, const std::string& fault) {
  if (!holds) throw InputError(where, fault);
}

void require_positive(double value, const std::string& where) {
  require(value > 0.0, where, "is " + base::shortest_text(value) + ", expected more than 0 m");
  require(value >= smallest_length, where,
          "is " + base::shortest_text(value) + ", expected at least 1e-06 m");
  require_within(value, largest_length, where);
}

void require_not_negative(double value, double limit, const std::string& where) {
  require(value >= 0.0, where, "is " + base::shortest_text(value) + ", expected 0 m or more");
  require_within(value, limit, where);
}

void check_range(double low, double high, const std::string& where) {
  require_within(low, largest_coordinate, where);
  require_within(high, largest_coordinate, where);
  require(low < high, where,
          "is [" + base::shortest_text(low) + ", " + base::shortest_text(high) +
              "], expected the smaller number first");
}

/// Throws unless a corner is within the largest supported world.
void require_in_reach(const Point& local, const std::string& where) {
  const double distance = std::max(std::abs(local.x), std::abs(local.y));
  if (distance <= largest_reach) return;
  throw InputError(where, "has a corner " + base::shortest_text(std::round(distance)) +
                              " m from the start, expected at most " +
                              base::shortest_text(largest_reach) + " m along each axis");
}

}  // namespace

void require_within(double value, double limit, const std::string& where) {
  if (std::abs(value) <= limit) return;  // valid values make no text: saves time
  throw InputError(where, "is " + base::shortest_text(value) + ", expected a number between " +
                              base::shortest_text(-limit) + " and " + base::shortest_text(limit));
}

Bounds local_bounds(const Bounds& bounds, const Point& origin) {
  check_range(bounds.x_min, bounds.x_max, "bounds.x");
  check_range(bounds.y_min, bounds.y_max, "bounds.y");
  const Point low = local_point({bounds.x_min, bounds.y_min}, origin);
  const Point high = local_point({bounds.x_max, bounds.y_max}, origin);
  const auto cut = [](double value) { return std::clamp(value, -largest_reach, largest_reach); };
  return {cut(low.x), cut(high.x), cut(low.y), cut(high.y)};
}

OccupancyGrid local_map(const OccupancyGrid& map, const Point& origin) {
  check_map(map);
  OccupancyGrid local = map;
  local.origin = local_pose(map.origin, origin);
  for (const Point& corner : outline(local)) require_in_reach(corner, "map");
  return local;
}

void check_pose(const Pose& pose, const std::string& where) {
  require_within(pose.x, largest_coordinate, where + ".x");
  require_within(pose.y, largest_coordinate, where + ".y");
  require_within(pose.heading, largest_heading, where + ".heading");
}

void check_headings(const HeadingRange& range, const std::string& where) {
  require_within(range.from, largest_heading, where);
  require_within(range.to, largest_heading, where);
  constexpr double full_turn = 2 * std::numbers::pi;
  constexpr double doubtful = 1e-5;  // Rounding may make one heading of it, or all [rad].
  const double least = std::min(width(range), full_turn - width(range));
  if (range.to < range.from && std::abs(least) < doubtful) {
    throw InputError(where, "ends a full turn below its begin, expected one heading twice, or any");
  }
  if (width(range) <= full_turn) return;
  throw InputError(where, "spans " + base::shortest_text(width(range)) +
                              " rad, expected at most a full turn: any");
}

void check_curvature(double curvature, const Vehicle& vehicle, const std::string& where) {
  const double most = 1.0 / vehicle.min_turning_radius;
  require(std::abs(curvature) <= most, where,
          "is " + base::shortest_text(curvature) + ", expected at most 1 / min_turning_radius, " +
              base::shortest_text(most) + " [1/m]");
}

void check_curvatures(const EndCurvatures& curvatures, const Vehicle& vehicle) {
  check_curvature(curvatures.start, vehicle, "start.curvature");
  check_curvature(curvatures.goal, vehicle, "goal.curvature");
}

void check_hitch_angle(double angle, const Vehicle& vehicle, const std::string& where) {
  if (!vehicle.trailer) {
    require(angle == 0.0, where, "are given for a vehicle without a trailer");
    return;
  }
  require(std::abs(angle) <= vehicle.max_hitch_angle, where,
          "has " + base::shortest_text(angle) + ", expected at most max_hitch_angle, " +
              base::shortest_text(vehicle.max_hitch_angle) + " rad");
}

void check_hitch_angles(const EndHitchAngles& angles, const Vehicle& vehicle) {
  check_hitch_angle(angles.start, vehicle, "start.hitch_angles");
  check_hitch_angle(angles.goal, vehicle, "goal.hitch_angles");
}

void check_distance(const Pose& start, const Pose& goal, const std::string& where) {
  const double distance = std::hypot(goal.x - start.x, goal.y - start.y);
  require(distance <= largest_distance, where,
          "is " + std::to_string(std::llround(distance)) + " m from the start, expected at most " +
              std::to_string(std::llround(largest_distance)) + " m");
}

void check_row_distance(double distance, const std::string& where) {
  require_not_negative(distance, largest_coordinate, where);
}

Polygon local_polygon(const Polygon& polygon, const Point& origin, const std::string& where) {
  Polygon local;
  local.reserve(polygon.size());
  for (const Point& corner : polygon) {
    require_within(corner.x, largest_coordinate, where);
    require_within(corner.y, largest_coordinate, where);
    local.push_back(local_point(corner, origin));
    require_in_reach(local.back(), where);
  }
  require(local.size() >= 3, where,
          "has " + std::to_string(local.size()) + " corner" + (local.size() == 1 ? "" : "s") +
              ", expected at least 3");
  local = geometry::cleaned(local);
  const std::string flaw = geometry::flaw_of(local, origin);
  require(flaw.empty(), where, flaw);
  return local;
}

std::vector<Polygon> local_polygons(const std::vector<Polygon>& polygons, const Point& origin,
                                    const std::string& name) {
  std::vector<Polygon> local;
  local.reserve(polygons.size());
  for (const Polygon& polygon : polygons) {
    local.push_back(
        local_polygon(polygon, origin, name + "[" + std::to_string(local.size()) + "]"));
  }
  return local;
}

Point local_point(const Point& point, const Point& origin) {
  return {base::moved(point.x, -origin.x), base::moved(point.y, -origin.y)};
}

LocalPose local_pose(const Pose& pose, const Point& origin) {
  const Point position = local_point({pose.x, pose.y}, origin);
  return Local(Pose{position.x, position.y, wrap_angle(pose.heading)});
}

Point local_origin(const Point& near) { return {std::round(near.x), std::round(near.y)}; }

void check_outline(const Polygon& outline, const std::string& where) {
  if (outline.empty()) return;
  for (const Point& corner : outline) {
    require_within(corner.x, largest_length, where);
    require_within(corner.y, largest_length, where);
  }
  const Polygon local = local_polygon(outline, {}, where);
  require(is_convex(local), where, "is not convex, expected a convex polygon");
  require(geometry::signed_distance(geometry::counter_clockwise(local), {}) <= 0.0, where,
          "does not hold [0, 0], expected a body around the midpoint of its axle");
}

void check_trailer(const Vehicle& vehicle) {
  const Trailer& trailer = *vehicle.trailer;
  require_positive(trailer.wheelbase, "vehicle.trailers[0].wheelbase");
  check_outline(trailer.outline, "vehicle.trailers[0].outline");
  require_within(trailer.front_overhang, largest_length, "vehicle.trailers[0].front_overhang");
  require(trailer.wheelbase + trailer.front_overhang >= 0.0, "vehicle.trailers[0].front_overhang",
          "is " + base::shortest_text(trailer.front_overhang) +
              ", expected a body that begins ahead of the axle, at least -" +
              base::shortest_text(trailer.wheelbase));
  require_not_negative(trailer.rear_overhang, largest_length, "vehicle.trailers[0].rear_overhang");
  require_positive(trailer.width, "vehicle.trailers[0].width");
  require_within(vehicle.hitch, largest_length, "vehicle.hitch");
  require(vehicle.max_hitch_angle > 0.0 && vehicle.max_hitch_angle < std::numbers::pi,
          "vehicle.max_hitch_angle",
          "is " + base::shortest_text(vehicle.max_hitch_angle) +
              ", expected more than 0 and less than 3.1415 rad");
}

}  // namespace problem

void check_vehicle(const Vehicle& vehicle) {
  problem::require_positive(vehicle.wheelbase, "vehicle.wheelbase");
  problem::check_outline(vehicle.outline, "vehicle.outline");
  if (vehicle.outline.empty()) {
    problem::require_not_negative(vehicle.front_overhang, problem::largest_length,
                                  "vehicle.front_overhang");
  } else {
    problem::require_within(vehicle.front_overhang, problem::largest_length,
                            "vehicle.front_overhang");
  }
  problem::require_not_negative(vehicle.rear_overhang, problem::largest_length,
                                "vehicle.rear_overhang");
  problem::require_positive(vehicle.width, "vehicle.width");
  problem::require_positive(vehicle.min_turning_radius, "vehicle.min_turning_radius");
  try {
    check_limits(vehicle.limits);
  } catch (const InputError& error) {
    throw InputError("vehicle." + error.where(), error.problem());
  }
  if (vehicle.trailer) problem::check_trailer(vehicle);
  if (!vehicle.track_width) return;
  problem::require_positive(*vehicle.track_width, "vehicle.track_width");
  problem::require(*vehicle.track_width <= vehicle.width, "vehicle.track_width",
                   "is " + base::shortest_text(*vehicle.track_width) +
                       ", expected at most the width, " + base::shortest_text(vehicle.width));
}

void check_map(const OccupancyGrid& map) {
  using namespace problem;
  require(map.resolution >= smallest_length && map.resolution <= largest_length, "map.resolution",
          "is " + base::shortest_text(map.resolution) + ", expected 1e-06 m to 1e+06 m");
  require_within(map.origin.x, largest_coordinate, "map.origin");
  require_within(map.origin.y, largest_coordinate, "map.origin");
  require_within(map.origin.heading, largest_heading, "map.origin");
  const std::int64_t count = std::int64_t{map.columns} * map.rows;
  require(map.columns >= 1 && map.rows >= 1 && count <= most_map_cells, "map",
          "has " + std::to_string(map.columns) + " x " + std::to_string(map.rows) +
              " cells, expected 1 to " + std::to_string(most_map_cells));
  require(map.cells != nullptr && map.cells->size() == static_cast<std::size_t>(count), "map",
          "does not hold all of its cells, expected " + std::to_string(count));
}

void check_poses(const Pose& start, const Pose& goal) {
  problem::check_pose(start, "start");
  problem::check_pose(goal, "goal");
  problem::check_distance(start, goal, "goal");
}

}  // namespace vandplan
