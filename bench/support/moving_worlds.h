// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Random worlds in which something moves.

#include <cstdint>

#include "vandplan/problem.h"

namespace vandplan {

/// Names of the kinds of worlds.
inline constexpr const char* moving_kinds[] = {"dock",    "door",       "gate",     "crossing",
                                               "stopped", "roundabout", "dead_end", "convoy",
                                               "parking", "forklifts"};

/// World number `number` of a kind: a truck leaves the dock that is the goal; a door that slides; a
/// gate through which somebody comes; a crossing; a lane in which somebody stops; a roundabout with
/// two others; a dead end in which somebody follows; a convoy with gaps; somebody who parks at the
/// side of the lane and leaves; two rows of stacks, and behind the gap of each a forklift that goes
/// to and fro. `kind`: index of its name.
[[nodiscard]] Scenario moving_world(std::size_t kind, std::uint64_t number);

}  // namespace vandplan
