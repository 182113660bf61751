// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How fast may a path be driven by a vehicle that already moves at its start?

#include <optional>
#include <span>

#include "vandplan/motion.h"

namespace vandplan::speed {

/// Motion of a vehicle at the start of a path.
struct MovingStart {
  double curvature = 0.0;                   ///< curvature to which the wheels are turned [1/m]
  double speed = 0.0;                       ///< speed in the gear of the first segment [m/s]; >= 0
  std::span<const SpeedLimit> limits = {};  ///< limits of places on the path
};

/// Speed profile for a vehicle that may move at the start; then `max_jerk` is ignored. Where the
/// vehicle is too fast, it brakes a thousandth harder than its limit. None if it cannot stop in
/// time where it has to. Otherwise like `speed_profile`.
[[nodiscard]] std::optional<SpeedProfile> profile_from(const Path& path, const Vehicle& vehicle,
                                                       const MovingStart& start);

}  // namespace vandplan::speed
