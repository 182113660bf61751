// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How fast may a path be driven by a vehicle that is on its way already?

#include <optional>

#include "vandplan/speed.h"

namespace vandplan::speed {

/// How a vehicle comes to the start of a path.
struct MovingStart {
  double curvature = 0.0;  ///< that its wheels are turned to [1/m]
  double speed = 0.0;      ///< in the gear of the first segment; >= 0 [m/s]
};

/// As `speed_profile`, for a vehicle that may come with a speed; it then has no limit of jerk.
/// Where it comes faster than the limits allow it brakes until they do, a thousandth harder than
/// they say. None if it cannot come to stand in time where it has to.
[[nodiscard]] std::optional<SpeedProfile> profile_from(const Path& path, const Vehicle& vehicle,
                                                       const MovingStart& start);

}  // namespace vandplan::speed
