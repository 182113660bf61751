// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where do zones let a vehicle neither leave a pose nor come to it?

#include <memory>

#include "vandplan/collision.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// The zones of a task with one-way directions and gears, without anything else that stands there.
/// The curvature with which a vehicle leaves a pose decides nothing: the direction is that of the
/// pose.
class ZoneExits {
 public:
  /// The rule says which gears may be driven at all.
  ZoneExits(const Task& task, const search::CostRule& rule);

  /// Whether zones let the vehicle drive on from a state in a gear; 0: in any.
  [[nodiscard]] bool may_leave(const LocalState& state, search::GearSign gear = 0) const;
  /// Whether zones let the vehicle come to a state in any gear.
  [[nodiscard]] bool may_come(const LocalState& state) const;

 private:
  [[nodiscard]] bool may_drive(const LocalState& state, search::GearSign gear,
                               InTime in_time) const;

  search::CostRule rule_;
  std::unique_ptr<const CollisionChecker> zones_;  // null: no zone has such a rule
};

}  // namespace vandplan::planning
