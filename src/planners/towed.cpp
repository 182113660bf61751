// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/towed.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "search/open_ground.h"
#include "vandplan/vehicle.h"
#include "vehicle/hitch_motion.h"

namespace vandplan::planning {
namespace {

using search::Connector, search::CostRule;

/// Lower bound of the cost of one body alone on open ground, for exact ends or for ends that are
/// `off`.
double cost_lower_bound_alone(const Task& task, const CostRule& rule, Ends which,
                              const steering::Closing& off) {
  if (which == Ends::exact) {
    return Connector(task, rule).least_cost(task.start, task.goal, {rule.initial_gear, {}});
  }
  return search::cost_lower_bound(search::open_ground(task, rule, off), rule, 0.0);
}

/// How far the ends of a trailer's axle may be off, if tractor and hitch angle are off as far as
/// the judge allows.
steering::Closing ends_of_trailer(const Vehicle& vehicle) {
  const auto& [position, heading] = steering::judged;
  const double arm = std::abs(vehicle.hitch) + 2 * vehicle.trailer->wheelbase;
  return {position + heading * arm, 2 * heading};
}

}  // namespace

Task towed_task(const Task& task) {
  const Trailer& trailer = *task.vehicle.trailer;
  Task towed = task;
  towed.vehicle = Vehicle{trailer.wheelbase, trailer.front_overhang, trailer.rear_overhang,
                          trailer.width, vehicle::trailer_alone(task.vehicle).radius};
  towed.vehicle.outline = trailer.outline;
  towed.start = Local(trailer_pose(task.vehicle, start_state(task)));
  towed.goal = Local(trailer_pose(task.vehicle, goal_state(task)));
  towed.steering = Steering::reeds_shepp;
  towed.curvatures = {};
  towed.hitch_angles = {};
  return towed;
}

double cost_lower_bound(const Task& task, const CostRule& rule, Ends ends) {
  const double of_tractor = cost_lower_bound_alone(task, rule, ends, steering::judged);
  const vehicle::TrailerAlone trailer = vehicle::trailer_alone(task.vehicle);
  if (trailer.most_angle >= std::numbers::pi / 2) return of_tractor;
  CostRule of_metres = rule;  // the curvature that has a price is the tractor's
  of_metres.curvature_change_cost = 0.0;
  const double of_trailer =
      cost_lower_bound_alone(towed_task(task), of_metres, ends, ends_of_trailer(task.vehicle));
  return std::max(of_tractor, of_trailer / trailer.most_way);
}

double cost_lower_bound(const Task& task, const Pricing& pricing, Ends ends) {
  const double length = pricing.counts_time()
                            ? cost_lower_bound(task, search::length_rule(pricing.rule()), ends)
                            : 0.0;
  const double priced = pricing.is_time() ? 0.0 : cost_lower_bound(task, pricing.prices(), ends);
  return pricing.cost_lower_bound(length, priced);
}

}  // namespace vandplan::planning
