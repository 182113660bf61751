// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where could a moving obstacle stand still for a path around it to be worth planning?
//
// A ghost is a moving obstacle during a part of its motion, treated as a standing one: a path that
// avoids the ghost is a path around the obstacle.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/motion.h"
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
  std::size_t obstacle = 0;  ///< index of the moving obstacle; 0 for `at_rest`
  double t = 0.0;            ///< time in whole steps, so that meetings nearby make one ghost [s]
  bool operator==(const Ghost&) const = default;
};

/// Ghosts for a meeting; those that leave most room come first.
[[nodiscard]] std::vector<Ghost> ghosts_at(const Meeting& meeting);

/// The task with the ghosts as standing obstacles and without moving ones. None if the ghosts have
/// no outline, or start or goal are not free then.
[[nodiscard]] std::optional<Task> task_around(const Task& task, std::span<const Ghost> ghosts,
                                              const ClearanceOptions& clearance);

}  // namespace vandplan::in_time
