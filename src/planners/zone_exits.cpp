// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/zone_exits.h"

#include "vandplan/collision.h"
#include "vandplan/path.h"

namespace vandplan::planning {
namespace {

constexpr double step = 1e-6;  // driven to see what zones say where a vehicle stands [m]

bool may_drive(const Task& task, const search::CostRule& rule, const LocalState& state,
               search::GearSign gear, InTime in_time) {
  if (!rule.allows(gear)) return false;
  const double onward = in_time == InTime::onward ? gear : -gear;
  return task.checker->obeys_zones(state, Segment{0.0, onward * step}, in_time);
}

}  // namespace

bool may_leave(const Task& task, const search::CostRule& rule, const LocalState& state,
               search::GearSign gear) {
  if (gear != 0) return may_drive(task, rule, state, gear, InTime::onward);
  return may_leave(task, rule, state, 1) || may_leave(task, rule, state, -1);
}

bool may_come(const Task& task, const search::CostRule& rule, const LocalState& state) {
  return may_drive(task, rule, state, 1, InTime::backward) ||
         may_drive(task, rule, state, -1, InTime::backward);
}

}  // namespace vandplan::planning
