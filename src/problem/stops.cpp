// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/stops.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "geometry/convex.h"
#include "vandplan/geometry.h"
#include "vandplan/motion.h"
#include "vandplan/vehicle.h"

namespace vandplan::problem {
namespace {

constexpr double in_via = 1e-6;  // tolerance of being in a via [m, rad]

/// Place where segments meet, or an end of the path.
struct JointOfPath {
  double s = 0.0;  // driven distance from the start [m]
  State state = {};
  bool stands = true;  // whether the vehicle stands there, via or not
};

std::vector<JointOfPath> joints_of(const Task& task, const LocalState& from,
                                   std::span<const Segment> segments) {
  std::vector<JointOfPath> joints = {{0.0, from}};
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const double length = std::abs(segment.length);
    joints.push_back(
        {joints.back().s + length, advance(task.vehicle, joints.back().state, segment)});
    if (i + 1 == segments.size()) continue;
    const Segment& next = segments[i + 1];
    const double end = curvature_at(segment, length);
    const double turn =
        steering_angle(task.vehicle, next.curvature) - steering_angle(task.vehicle, end);
    joints.back().stands =
        segment.length * next.length < 0.0 || std::abs(turn) > ignored_steering_jump;
  }
  return joints;
}

bool is_in(const Interval& interval, double value) {
  return value >= interval.least - in_via && value <= interval.most + in_via;
}

bool is_in(const HeadingRange& range, double heading) {
  const double middle = range.from + 0.5 * width(range);
  return std::abs(wrap_angle(heading - middle)) <= 0.5 * width(range) + in_via;
}

bool is_in(const Polygon& area, const Point& point) {
  if (contains(area, point)) return true;
  for (std::size_t i = 0, j = area.size() - 1; i < area.size(); j = i++) {
    if (geometry::squared_distance_to_side(point, area[j], area[i]) <= in_via * in_via) return true;
  }
  return false;
}

bool is_in(const GoalRegion& region, const Vehicle& vehicle, const State& state) {
  const bool is_of_trailer = region.is_of_trailer && vehicle.trailer;
  const Pose axle = is_of_trailer ? trailer_pose(vehicle, state) : state.pose;
  const bool is_place = region.area.empty() ? is_in(region.x, axle.x) && is_in(region.y, axle.y)
                                            : is_in(region.area, {axle.x, axle.y});
  const bool is_turned =
      region.either_way && is_in(region.heading, axle.heading + std::numbers::pi);
  return is_place && (is_turned || is_in(region.heading, axle.heading)) &&
         is_in(region.hitch_angle, wrap_angle(state.hitch_angle));
}

/// Finds joints that are in vias.
class JointsInVias {
 public:
  JointsInVias(const Task& task, const LocalState& from, std::span<const Segment> segments)
      : task_(task), joints_(problem::joints_of(task, from, segments)) {}

  [[nodiscard]] std::vector<double> stops() const {
    std::vector<double> stops;
    std::size_t from = 0;
    for (std::size_t i = 0; i < task_.via.size(); ++i) {
      const std::optional<std::size_t> first = first_of(i, from, false);
      if (!first) continue;
      from = *first;
      if (!task_.via[i].stop) continue;
      const std::optional<std::size_t> anyway = first_of(i, from, true);
      if (anyway && passed_behind(*anyway, i + 1) == passed_behind(*first, i + 1)) from = *anyway;
      stops.push_back(joints_[from].s);
    }
    return stops;
  }

 private:
  /// First joint from `from` on that is in a via; none if there is none.
  [[nodiscard]] std::optional<std::size_t> first_of(std::size_t via, std::size_t from,
                                                    bool must_stand) const {
    for (std::size_t j = from; j < joints_.size(); ++j) {
      if (must_stand && !joints_[j].stands) continue;
      const auto holds = [&](const GoalRegion& region) {
        return is_in(region, task_.vehicle, joints_[j].state);
      };
      if (std::ranges::any_of(task_.via[via].any_of, holds)) return j;
    }
    return std::nullopt;
  }

  /// Number of vias from `via` on in which there are joints, one behind the other.
  [[nodiscard]] std::size_t passed_behind(std::size_t joint, std::size_t via) const {
    std::size_t count = 0;
    for (; via < task_.via.size(); ++via) {
      const std::optional<std::size_t> next = first_of(via, joint, false);
      if (!next) continue;
      joint = *next;
      ++count;
    }
    return count;
  }

  const Task& task_;
  std::vector<JointOfPath> joints_;
};

}  // namespace

std::vector<double> stops_at_vias(const Task& task, const LocalState& from,
                                  std::span<const Segment> segments) {
  const auto has_stop = [](const Via& via) { return via.stop; };
  if (std::ranges::none_of(task.via, has_stop)) return {};
  return JointsInVias(task, from, segments).stops();
}

}  // namespace vandplan::problem
