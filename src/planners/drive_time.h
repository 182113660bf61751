// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long does driving take, where the cost is the time?

#include <span>

#include "vandplan/path.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// How long the fastest drive from the start along the segments takes [s].
[[nodiscard]] double drive_time(const Task& task, std::span<const Segment> segments);

/// What no drive of so many metres or more takes less than [s]: at the highest speed of the gears
/// that the prices allow, but for gaining and losing it at the ends.
[[nodiscard]] double least_drive_time(const Vehicle& vehicle, const search::CostRule& prices,
                                      double length);

/// Prices under which a path costs about the metres that the vehicle could have driven at its
/// higher speed in the time that the path takes. Stops and turning wheels take time; how much is
/// known only when the whole path is.
[[nodiscard]] search::CostRule prices_like_time(const Task& task);

/// Prices under which a path costs about its share of what its drive costs by `prices`, with
/// `time_price` for each second [m]. What being near things adds stays as it is.
[[nodiscard]] search::CostRule with_time(const search::CostRule& prices, const Task& task,
                                         double time_price);

}  // namespace vandplan::planning
