// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/setting.h"

#include "planners/rig/room_for_margin.h"
#include "planners/rig/softer_wheels.h"
#include "planners/rig/towed.h"

namespace vandplan::rig {
namespace {

std::deque<Task> wheels_for(const Task& task, const planning::Pricing& pricing) {
  if (pricing.counts_time()) return with_softer_wheels(task);
  std::deque<Task> wheels = {task};
  if (task.steering == Steering::reeds_shepp && !pricing.rule().is_length()) {
    wheels.emplace_back(task).steering = Steering::continuous_between_stops;
  }
  return wheels;
}

}  // namespace

Setting::Setting(const Task& of, const PlanOptions& with, const planning::Pricing& prices)
    : task(of),
      options(with),
      pricing(prices),
      wheels(wheels_for(of, prices)),
      bare(without_margin(of, with.clearance.margin)),
      towed(towed_task(of)),
      guides(of),
      unit(search_unit(of.vehicle)) {}

}  // namespace vandplan::rig
