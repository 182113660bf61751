// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which problems has nobody tuned the planner to? Worlds made by a number.

#include <cstdint>

#include "vandplan/problem.h"

namespace vandplan {

/// The truck of the defaults in a random world: among boxes, through gates, into a parking slot,
/// into a dock or in a maze, by turns. The same number makes the same world. Start and goal are
/// free; a path need not exist.
[[nodiscard]] Problem random_world(std::uint64_t number);

}  // namespace vandplan
