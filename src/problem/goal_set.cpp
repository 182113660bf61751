// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/goal_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/require.h"
#include "base/text.h"
#include "geometry/convex.h"
#include "problem/checks.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace problem {
namespace {

constexpr std::size_t most_regions = 10'000;
constexpr std::size_t most_vias = 100;
constexpr double longest_straight = 1000.0;  // longest straight last stretch [m]

void check_interval(const Interval& interval, const std::string& where) {
  if (interval.least <= interval.most) return;
  throw InputError(where, "is [" + base::shortest_text(interval.least) + ", " +
                              base::shortest_text(interval.most) +
                              "], expected the smaller number first");
}

void check_straight(const GoalRegion& region, const std::string& where) {
  base::require(region.straight >= 0.0 && region.straight <= longest_straight, where + ".straight",
                region.straight, "0 to 1000 [m]");
  if (region.straight == 0.0 || region.curvature == 0.0) return;
  throw InputError(where + ".curvature", "is " + base::shortest_text(region.curvature) +
                                             " beside straight, expected straight wheels");
}

/// Box around all positions of a region [m].
Bounds box_of(const GoalRegion& region) {
  if (!region.area.empty()) return bounding_box(region.area);
  return {region.x.least, region.x.most, region.y.least, region.y.most};
}

void check_region(const GoalRegion& region, const Vehicle& vehicle, const Pose& start,
                  const std::string& where) {
  const std::string axle = region.is_of_trailer ? where + ".trailer" : where;
  if (region.area.empty()) {
    check_interval(region.x, axle + ".x");
    check_interval(region.y, axle + ".y");
  } else {
    (void)local_polygon(region.area, local_origin({start.x, start.y}), axle + ".area");
  }
  const auto [x_min, x_max, y_min, y_max] = box_of(region);
  for (const Pose& corner : {Pose{x_min, y_min, 0}, Pose{x_max, y_max, 0}}) {
    check_pose(corner, axle);
    check_distance(start, corner, axle);
  }
  check_headings(region.heading, axle + ".heading");
  check_curvature(region.curvature, vehicle, where + ".curvature");
  check_straight(region, where);
  check_interval(region.hitch_angle, where + ".hitch_angles");
  check_hitch_angle(region.hitch_angle.least, vehicle, where + ".hitch_angles");
  check_hitch_angle(region.hitch_angle.most, vehicle, where + ".hitch_angles");
  if (region.is_of_trailer && !vehicle.trailer) {
    throw InputError(axle, "is given without a trailer, expected trailers of the vehicle");
  }
}

double middle_of(const Interval& interval) {
  return interval.least + 0.5 * (interval.most - interval.least);
}

Interval moved(const Interval& interval, double by) {
  return {local_point({interval.least, 0}, {by, 0}).x, local_point({interval.most, 0}, {by, 0}).x};
}

}  // namespace

void check_goal_set(const std::vector<GoalRegion>& set, const Vehicle& vehicle, const Pose& start,
                    const std::string& where) {
  if (set.empty() || set.size() > most_regions) {
    throw InputError(where + ".any_of", "has " + std::to_string(set.size()) +
                                            " goals, expected 1 to " +
                                            std::to_string(most_regions));
  }
  for (std::size_t i = 0; i < set.size(); ++i) {
    const std::string number = set.size() == 1 ? "" : ".any_of[" + std::to_string(i) + "]";
    check_region(set[i], vehicle, start, where + number);
  }
}

void check_via(const std::vector<Via>& via, const Vehicle& vehicle, const Pose& start) {
  if (via.size() > most_vias) {
    throw InputError("via", "has " + std::to_string(via.size()) + " entries, expected at most " +
                                std::to_string(most_vias));
  }
  for (std::size_t i = 0; i < via.size(); ++i) {
    const std::string where = "via[" + std::to_string(i) + "]";
    check_goal_set(via[i].any_of, vehicle, start, where);
    for (const GoalRegion& region : via[i].any_of) {
      const char* const key = region.straight != 0.0    ? ".straight"
                              : region.curvature != 0.0 ? ".curvature"
                                                        : nullptr;
      if (key != nullptr) throw InputError(where + key, "is given, expected it for goals alone");
    }
  }
}

std::vector<Via> local_via(const std::vector<Via>& via, const Point& origin) {
  std::vector<Via> local = via;
  for (Via& one : local) one.any_of = local_goal_set(one.any_of, origin);
  return local;
}

std::vector<GoalRegion> local_goal_set(const std::vector<GoalRegion>& set, const Point& origin) {
  std::vector<GoalRegion> local = set;
  for (GoalRegion& region : local) {
    if (region.area.empty()) {
      region.x = moved(region.x, origin.x);
      region.y = moved(region.y, origin.y);
    } else {
      region.area = geometry::counter_clockwise(local_polygon(region.area, origin, "goal.area"));
    }
  }
  return local;
}

State state_at(const Vehicle& vehicle, const GoalRegion& region, const Pose& axle,
               double hitch_angle) {
  return {region.is_of_trailer ? tractor_pose(vehicle, axle, hitch_angle) : axle, hitch_angle};
}

State some_goal(const Vehicle& vehicle, const GoalRegion& region) {
  return state_at(vehicle, region, some_pose(region), middle_of(region.hitch_angle));
}

Task task_to(const Task& task, const LocalState& goal, double curvature,
             const ClearanceOptions& options) {
  const State& state = goal;
  Task to = task;
  to.goal = Local(state.pose);
  to.curvatures.goal = curvature;
  to.hitch_angles.goal = state.hitch_angle;
  tell_ends_apart(to);
  if (options.margin_ramp > 0.0) {
    to.checker = task.world->checker(task.vehicle);
    keep_margin(to, options);
  }
  return to;
}

}  // namespace problem

GoalRegion region_of_pose(const Pose& pose) noexcept {
  return {.x = {pose.x, pose.x}, .y = {pose.y, pose.y}, .heading = {pose.heading, pose.heading}};
}

// The first corner of an area is in the area; the middle of the area's box may be outside.
Pose some_pose(const GoalRegion& region) {
  const double heading = wrap_angle(region.heading.from + 0.5 * width(region.heading));
  if (!region.area.empty()) return {region.area.front().x, region.area.front().y, heading};
  return {problem::middle_of(region.x), problem::middle_of(region.y), heading};
}

double width(const HeadingRange& range) noexcept {
  const double turn = range.to - range.from;
  constexpr double full = 2 * std::numbers::pi;
  return turn >= 0.0 ? turn : turn + full * std::ceil(-turn / full);
}

bool is_continuous(const GoalRegion& region) noexcept {
  const auto is_wide = [](const Interval& i) { return i.least < i.most; };
  return !region.area.empty() || is_wide(region.x) || is_wide(region.y) ||
         width(region.heading) > 0.0 || is_wide(region.hitch_angle);
}

}  // namespace vandplan
