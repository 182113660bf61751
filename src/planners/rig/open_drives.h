// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which drives lead a rig to its goal without a search?

#include <vector>

#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::rig {

/// The commands of free drives that exact steering finds from the start to the goal, each of
/// another order of gears, the cheapest first. The task has a vehicle with a trailer.
[[nodiscard]] std::vector<std::vector<Segment>> open_drives(const Task& task,
                                                            const search::CostRule& rule);

}  // namespace vandplan::rig
