// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which problems has nobody tuned the planner to? Worlds made by a number.

#include <cstdint>

#include "vandplan/problem.h"

namespace vandplan {

/// A random problem for the default truck. The number chooses the kind of world: boxes, gates,
/// parking slots, docks or a maze. The same number makes the same problem. Start and goal are free;
/// there may be no path.
[[nodiscard]] Problem random_world(std::uint64_t number);

/// A car of 4.69 m in a lane, with a slot along it that is 0.8 to 2.2 m longer than the car. Start
/// and goal are free; there may be no path. Planners find paths by fine searches alone.
[[nodiscard]] Problem tight_slot(std::uint64_t number);

}  // namespace vandplan
