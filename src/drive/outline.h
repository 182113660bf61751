// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the outline of a vehicle beyond where it should be?

#include <algorithm>
#include <cmath>

#include "vandplan/vehicle.h"

namespace vandplan::driving {

/// How far the furthest point of a footprint is from the same footprint at the pose in whose frame
/// `pose` is given [m]. The furthest one of a convex set is a corner.
[[nodiscard]] inline double deviation_of(const Footprint& body, const Pose& pose) noexcept {
  double most = 0.0;
  for (const Point& corner : corners(body, pose)) {
    const double dx = corner.x - std::clamp(corner.x, -body.rear, body.front);
    const double dy = corner.y - std::clamp(corner.y, -body.half_width, body.half_width);
    most = std::max(most, dx * dx + dy * dy);
  }
  return std::sqrt(most);
}

}  // namespace vandplan::driving
