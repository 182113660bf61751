// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where could a moving obstacle stand still for a path around it to be worth planning?
//
// A ghost is a moving obstacle that stands in for a part of its motion: paths that avoid the ghost
// are paths around the obstacle.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/moving.h"
#include "vandplan/problem.h"

namespace vandplan::in_time {

/// The outlines of one moving obstacle, or of all that come to rest, during a part of their motion.
struct Ghost {
  enum class Kind {
    where_met,  ///< the obstacle at time `t`
    passing,    ///< the obstacle some seconds before and after time `t`
    whole_way,  ///< the obstacle at all times
    at_rest,    ///< all obstacles that stay, where they stay
  };
  Kind kind = Kind::where_met;
  std::size_t obstacle = 0;  ///< 0 if it stands for all
  double t = 0.0;            ///< in whole steps, so that meetings nearby make one ghost [s]
  bool operator==(const Ghost&) const = default;
};

/// The ghosts that a meeting suggests, those first that leave most room.
[[nodiscard]] std::vector<Ghost> ghosts_at(const Meeting& meeting);

/// The task with the ghosts as obstacles, and nothing that moves; none if the start or the goal is
/// not free then.
[[nodiscard]] std::optional<Task> task_around(const Task& task, std::span<const Ghost> ghosts,
                                              const ClearanceOptions& clearance);

}  // namespace vandplan::in_time
