// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/setting.h"

#include "planners/towed.h"

namespace vandplan::rig {
namespace {

/// Shares of the largest curvature rate. Wheels that turn over a longer way can be turned at a
/// higher speed. Each drive is bent into the next one.
constexpr double sharpnesses[] = {0.7, 0.5, 0.35, 0.25};

/// The task, and copies whose wheels turn more and more slowly for each metre driven. The task
/// alone if its curvature may jump anywhere.
std::deque<Task> with_softer_wheels(const Task& task) {
  std::deque<Task> tasks = {task};
  if (task.steering == Steering::reeds_shepp) return tasks;
  for (const double sharpness : sharpnesses) {
    Task& softer = tasks.emplace_back(task);
    softer.vehicle.limits.max_curvature_rate = sharpness * max_curvature_rate(task.vehicle);
  }
  return tasks;
}

/// The task without its margin; none if the margin is 0.
std::optional<Task> without_margin(const Task& task, double margin) {
  if (margin == 0.0) return std::nullopt;
  Task bare = task;
  bare.checker = task.world->checker(task.vehicle);
  return bare;
}

}  // namespace

Setting::Setting(const Task& of, const PlanOptions& with, const planning::Pricing& prices,
                 const SiteTable* table)
    : task(of),
      options(with),
      pricing(prices),
      wheels(prices.counts_time() ? with_softer_wheels(of) : std::deque<Task>{of}),
      bare(without_margin(of, with.clearance.margin)),
      towed(planning::towed_task(of)),
      site(table),
      guides(of),
      unit(search_unit(of.vehicle)) {}

}  // namespace vandplan::rig
