// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a stretch driven between two stops in the least time?

#include <optional>
#include <span>
#include <vector>

#include "speed/caps.h"
#include "vandplan/motion.h"

namespace vandplan::speed {

/// Appends the knots of the fastest drive from stop to stop below `caps`, and returns its duration
/// [s]. Times count from the start of the stretch. `caps` adjoin without gaps and are overwritten.
double drive_stretch(std::vector<Cap>& caps, const DrivingLimits& limits,
                     std::vector<SpeedKnot>& knots);

/// Like `drive_stretch`, for a vehicle that begins the stretch with a squared speed `square` > 0
/// [m^2/s^2]. Where it is too fast, it brakes a thousandth harder than its limit. None, and no
/// knots, if it cannot stop at the end.
[[nodiscard]] std::optional<double> drive_stretch_from(double square, std::vector<Cap>& caps,
                                                       const DrivingLimits& limits,
                                                       std::vector<SpeedKnot>& knots);

/// Like `drive_stretch`, with `limits.max_jerk`, which must be there. The drive is nearly the
/// fastest.
double drive_stretch_smoothly(std::span<const Cap> caps, const DrivingLimits& limits,
                              std::vector<SpeedKnot>& knots);

}  // namespace vandplan::speed
