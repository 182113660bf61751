// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/drive_time.h"

#include <algorithm>
#include <cmath>

namespace vandplan::planning {
namespace {

/// Share of a stop from full speed that a gear change costs: most strokes are too short for full
/// speed.
constexpr double share_of_stop = 0.25;

double braking_of(const DrivingLimits& limits) {
  return limits.max_braking.value_or(limits.max_acceleration);
}

double higher_speed(const DrivingLimits& limits) {
  return std::max(limits.max_speed.forward, limits.max_speed.reverse);
}

}  // namespace

SpeedProfile fastest_drive(const Task& task, const Path& path) {
  return speed_profile(path, task.vehicle,
                       {.start_curvature = task.curvatures.start,
                        .limits = speed_limits(task, start_state(task), path.segments)});
}

double drive_time(const Task& task, std::span<const Segment> segments) {
  return fastest_drive(task, {task.start, {segments.begin(), segments.end()}}).duration;
}

double top_speed(const Vehicle& vehicle, const search::CostRule& prices) {
  const DrivingLimits& limits = vehicle.limits;
  return !prices.allows(-1)  ? limits.max_speed.forward
         : !prices.allows(1) ? limits.max_speed.reverse
                             : higher_speed(limits);
}

std::array<double, 2> ramps_to(const Vehicle& vehicle, double speed) {
  const DrivingLimits& limits = vehicle.limits;
  return {speed * speed / (2 * limits.max_acceleration), speed * speed / (2 * braking_of(limits))};
}

double drive_time_lower_bound(const Vehicle& vehicle, const search::CostRule& prices,
                              double length) {
  const DrivingLimits& limits = vehicle.limits;
  const double top = top_speed(vehicle, prices);
  // Gaining and losing the speed v takes the time v * slowness, and the way v^2 * slowness / 2.
  const double slowness = 1 / limits.max_acceleration + 1 / braking_of(limits);
  const double v = std::min(top, std::sqrt(2 * length / slowness));
  if (v == 0.0) return 0.0;
  return v * slowness + (length - v * v * slowness / 2) / v;
}

search::CostRule prices_like_time(const Task& task) {
  const DrivingLimits& limits = task.vehicle.limits;
  const double top = higher_speed(limits);
  const double slowness = 1 / limits.max_acceleration + 1 / braking_of(limits);
  const double stop = share_of_stop * top * top * slowness / 2;
  // Time for a change of curvature by 1/m, if the wheels are about straight [s m].
  const double turn = task.vehicle.wheelbase / limits.max_steering_rate;
  return {.forward_weight = top / limits.max_speed.forward,
          .reverse_weight = top / limits.max_speed.reverse,
          .gear_change_cost = stop,
          .curvature_change_cost = top * turn,
          .slowness_price = task.checker->has_speed_limits() ? top : 0.0};
}

search::CostRule with_time(const search::CostRule& prices, const Task& task, double time_price) {
  const search::CostRule time = prices_like_time(task);
  const double share = time_price / higher_speed(task.vehicle.limits);
  const double forward = prices.forward_weight + share * time.forward_weight;
  const double reverse = prices.reverse_weight + share * time.reverse_weight;
  // Searches are guided by lengths, so a metre in the cheaper gear must cost one metre.
  const double metre = std::min(forward, reverse);
  search::CostRule rule = prices;
  rule.forward_weight = forward / metre;
  rule.reverse_weight = reverse / metre;
  rule.gear_change_cost = (prices.gear_change_cost + share * time.gear_change_cost) / metre;
  rule.curvature_change_cost =
      (prices.curvature_change_cost + share * time.curvature_change_cost) / metre;
  return rule;
}

}  // namespace vandplan::planning
