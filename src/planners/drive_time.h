// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long does driving take, where the cost is the time?

#include <array>
#include <span>

#include "vandplan/motion.h"
#include "vandplan/path.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// The fastest drive along a path from the start.
[[nodiscard]] SpeedProfile fastest_drive(const Task& task, const Path& path);

/// Duration of the fastest drive from the start along the segments [s].
[[nodiscard]] double drive_time(const Task& task, std::span<const Segment> segments);

/// Highest speed in the gears that the prices allow [m/s].
[[nodiscard]] double top_speed(const Vehicle& vehicle, const search::CostRule& prices);

/// Distances from start and goal beyond which drives may have a speed [m].
[[nodiscard]] std::array<double, 2> ramps_to(const Vehicle& vehicle, double speed);

/// Lower bound of the duration of drives of at least `length` metres [s]: at the highest speed of
/// the gears that the prices allow, with one start and one stop.
[[nodiscard]] double drive_time_lower_bound(const Vehicle& vehicle, const search::CostRule& prices,
                                            double length);

/// Prices by which a path costs about the metres that the vehicle could drive at its higher speed
/// in the duration of the path. Prices of stops and of turning wheels are estimates, because their
/// durations depend on the whole path.
[[nodiscard]] search::CostRule prices_like_time(const Task& task);

/// Prices by which the cost of a path is about proportional to that of its drive, where each second
/// costs `time_price` [m] beside `prices`. The price of clearance stays as it is.
[[nodiscard]] search::CostRule with_time(const search::CostRule& prices, const Task& task,
                                         double time_price);

}  // namespace vandplan::planning
