// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/free_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>

#include "base/trigonometry.h"
#include "geometry/polygon.h"
#include "search/one_way.h"
#include "search/open_rows.h"
#include "vandplan/collision.h"
#include "vandplan/vehicle.h"

namespace vandplan::planning {
namespace {

constexpr std::int64_t most_work = 200'000;  // parts that are looked at, at most
constexpr std::int64_t work_at_once = 64;    // parts between two looks at the budget
constexpr std::size_t most_points = 64;      // poses that are wanted
constexpr double shrink = 0.8;               // border of a core, relative to that of the one before
constexpr std::size_t most_cores = 48;       // number of cores
constexpr double zone_slack = 2e-3;          // slack of zones; larger than all tolerances [m]

/// A part of the body that is at least `border` [m] inside of it, with wheels inside of its wheels.
struct Core {
  double border;
  double ahead;  // distance from the vehicle's rear axle to that of the core [m]
  std::shared_ptr<const CollisionChecker> checker;
};

/// Widest border that leaves a core [m]; 0: there is none.
double widest_border(const Task& task) {
  const Vehicle& vehicle = task.vehicle;
  if (!vehicle.outline.empty()) {
    return task.world->local().kerbs.empty() ? 0.95 * search::widest_disc(vehicle).radius : 0.0;
  }
  const double track = std::min(vehicle.track_width.value_or(vehicle.width), vehicle.width);
  return std::min(vehicle.wheelbase, track) / 2.1;
}

/// The rectangle without a border, or a square in the widest disc of an outline without one.
Core core_of(const Task& task, double border) {
  Vehicle core = task.vehicle;
  core.trailer.reset();
  double ahead = border;
  if (core.outline.empty()) {
    core.wheelbase -= 2 * border;
    core.width -= 2 * border;
    if (core.track_width) *core.track_width -= 2 * border;
  } else {
    const search::Disc disc = search::widest_disc(core);
    const double side = std::sqrt(2.0) * (disc.radius - border);
    core = {.wheelbase = side, .front_overhang = 0, .rear_overhang = 0, .width = side};
    ahead = disc.ahead - side / 2;
  }
  return {border, ahead, task.world->checker_of_obstacles(core, {.wanted = task.least_margin})};
}

class FreeParts {
 public:
  FreeParts(const Task& task, search::GearSign only)
      : task_(task),
        only_(only),
        near_(inner_radius(task.vehicle)),
        one_way_(task.world->local().zones, {0.0, near_}, task.vehicle.min_turning_radius),
        may_stand_(point_at(task, start_state(task)).has_value()) {
    for (const Point& corner : body_outline(task.vehicle)) {
      reach_ = std::max(reach_, std::hypot(corner.x, corner.y));
    }
  }

  [[nodiscard]] double reach() const { return reach_; }

  /// Whether no pose of a part is free, or zones forbid to move at all its poses.
  [[nodiscard]] bool is_closed(const RegionPart& part) {
    const GoalRegion& region = task_.goal_set[part.middle.region];
    const PlacedPart placed = planning::placed(task_.vehicle, region, part);
    const State there = state_of(task_, part.middle);  // moved into the area
    const double off = std::hypot(there.pose.x - placed.pose.x, there.pose.y - placed.pose.y);
    const Bounds& bounds = task_.world->local().bounds;
    const Bounds& box = placed.box;
    return off > placed.off.position + zone_slack || box.x_min > bounds.x_max ||
           box.x_max < bounds.x_min || box.y_min > bounds.y_max || box.y_max < bounds.y_min ||
           is_hit(placed) || (!may_stand_ && is_forbidden(placed));
  }

 private:
  /// The largest core that the body covers at all poses of a part; null if there is none.
  [[nodiscard]] const Core* core_for(double border) {
    double size = cores_.empty() ? widest_border(task_) : cores_.back().border * shrink;
    while (size > 0.0 && cores_.size() < most_cores &&
           (cores_.empty() || cores_.back().border >= border)) {
      cores_.push_back(core_of(task_, size));
      size *= shrink;
    }
    const auto smaller =
        std::ranges::find_if(cores_, [border](const Core& core) { return core.border < border; });
    return smaller == cores_.begin() ? nullptr : &*std::prev(smaller);
  }

  /// Whether the body hits an obstacle at all poses of a part.
  [[nodiscard]] bool is_hit(const PlacedPart& placed) {
    const auto& [pose, off, box] = placed;
    const double move = off.position + off.heading * (reach_ + off.position);
    const Core* const core = core_for(move + CollisionChecker::tolerance);
    if (core == nullptr) return false;
    const auto [sin, cos] = base::sin_cos(pose.heading);
    const Pose there{pose.x + core->ahead * cos, pose.y + core->ahead * sin, pose.heading};
    // Outside the bounds obstacles are not known.
    return contains(task_.world->local().bounds, {there.x, there.y}) &&
           !core->checker->is_free(Local(there));
  }

  /// Whether zones forbid to be at all poses of a part, or to move there.
  [[nodiscard]] bool is_forbidden(const PlacedPart& placed) const {
    const auto& [pose, off, box] = placed;
    const Point middle{pose.x, pose.y};
    const AllowedGears other = only_ > 0 ? AllowedGears::reverse : AllowedGears::forward;
    const auto closes = [&](const Zone& zone) {
      const bool is_closed = zone.closed || (only_ != 0 && zone.gears == other);
      const double near = zone.body ? near_ : 0.0;
      return is_closed && geometry::distance_from_border(zone.area, middle) <=
                              near - placed.off.position - zone_slack;
    };
    return std::ranges::any_of(task_.world->local().zones, closes) ||
           one_way_.forbids(middle, off.position, pose.heading, off.heading, only_);
  }

  const Task& task_;
  search::GearSign only_;
  double near_;  // least distance of the rear axle from the outline of the body [m]
  search::OneWay one_way_;
  bool may_stand_;           // whether the start is in the set, where the vehicle need not move
  double reach_ = 0.0;       // of the body from the rear axle [m]
  std::vector<Core> cores_;  // smaller and smaller borders
};

/// Some of the points, evenly spread.
std::vector<GoalPoint> some_of(const std::vector<GoalPoint>& points) {
  const std::size_t count = std::min(points.size(), most_points);
  std::vector<GoalPoint> some;
  for (std::size_t i = 0; i < count; ++i) some.push_back(points[i * points.size() / count]);
  return some;
}

}  // namespace

FreePoints free_points(const Task& task, search::GearSign only, const search::Budget& budget,
                       const std::function<bool(const GoalPoint&)>& fits) {
  FreeParts free(task, only);
  std::vector<RegionPart> parts;
  for (std::size_t region = 0; region < task.goal_set.size(); ++region) {
    if (!is_continuous(task.goal_set[region])) continue;
    std::ranges::copy(whole(task.goal_set[region], region), std::back_inserter(parts));
  }
  std::vector<GoalPoint> found;
  std::int64_t work = 0;
  while (found.size() < most_points && !parts.empty()) {
    std::vector<RegionPart> next;
    for (const RegionPart& part : parts) {
      if (work++ % work_at_once == 0 && budget.is_interrupted()) return {};
      if (work > most_work) return {.points = some_of(found)};
      if (free.is_closed(part)) continue;
      const GoalRegion& region = task.goal_set[part.middle.region];
      GoalPoint point = part.middle;
      for (const bool is_backed_into : {false, true}) {
        point.is_backed_into = is_backed_into;
        if (is_backed_into && region.straight == 0.0) continue;
        if (fits(point)) found.push_back(point);
      }
      std::ranges::copy(halves_in_space(region, free.reach(), part), std::back_inserter(next));
    }
    parts = std::move(next);
  }
  return {some_of(found), found.empty()};
}

}  // namespace vandplan::planning
