// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a stretch driven from one stop to the next?

#include <optional>
#include <span>
#include <vector>

#include "speed/caps.h"
#include "vandplan/speed.h"

namespace vandplan::speed {

/// The fastest drive from stop to stop below caps that follow each other without gaps, adding its
/// knots, with times since the start of the stretch; returns how long it takes [s]. `caps` may be
/// changed.
double drive_stretch(std::vector<Cap>& caps, const DrivingLimits& limits,
                     std::vector<SpeedKnot>& knots);

/// The same for a vehicle that comes to the stretch with a speed > 0, given squared: where that is
/// above what may be driven it brakes, a thousandth harder than it may, until it is no more. None,
/// and no knots, if it cannot come to stand at the end.
[[nodiscard]] std::optional<double> drive_stretch_from(double square, std::vector<Cap>& caps,
                                                       const DrivingLimits& limits,
                                                       std::vector<SpeedKnot>& knots);

/// The drive that also keeps `limits.max_jerk`, which must be there; near the fastest.
double drive_stretch_smoothly(std::span<const Cap> caps, const DrivingLimits& limits,
                              std::vector<SpeedKnot>& knots);

}  // namespace vandplan::speed
