// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/zone_exits.h"

#include <limits>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::planning {
namespace {

constexpr double step = 1e-6;  // driven to see what zones say where a vehicle stands [m]

}  // namespace

ZoneExits::ZoneExits(const Task& task, const search::CostRule& rule) : rule_(rule) {
  constexpr double far = std::numeric_limits<double>::max();
  Surroundings ground{.bounds = {-far, far, -far, far}};
  for (const Zone& zone : task.world->local().zones) {
    if (zone.direction || zone.gears != AllowedGears::both) ground.zones.push_back(zone);
  }
  if (ground.zones.empty()) return;
  zones_ = std::make_unique<const CollisionChecker>(task.vehicle, ground);
}

bool ZoneExits::may_leave(const LocalState& state, search::GearSign gear) const {
  if (gear != 0) return may_drive(state, gear, InTime::onward);
  return may_drive(state, 1, InTime::onward) || may_drive(state, -1, InTime::onward);
}

bool ZoneExits::may_come(const LocalState& state) const {
  return may_drive(state, 1, InTime::backward) || may_drive(state, -1, InTime::backward);
}

bool ZoneExits::may_drive(const LocalState& state, search::GearSign gear, InTime in_time) const {
  if (!rule_.allows(gear)) return false;
  if (zones_ == nullptr) return true;
  const double onward = in_time == InTime::onward ? gear : -gear;
  return zones_->is_free(state, Segment{0.0, onward * step}, in_time);
}

}  // namespace vandplan::planning
