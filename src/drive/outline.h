// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the outline of a vehicle beyond where it should be?

#include <algorithm>

#include "base/trigonometry.h"
#include "geometry/convex.h"
#include "vandplan/vehicle.h"

namespace vandplan::driving {

/// How far the furthest point of a convex body is from the same body at the pose in whose frame
/// `pose` is given [m]. The furthest one of a convex set is a corner.
[[nodiscard]] inline double deviation_of(const Polygon& body, const Pose& pose) noexcept {
  const auto [sin, cos] = base::sin_cos(pose.heading);
  double most = 0.0;
  for (const auto& [x, y] : body) {
    const Point corner{pose.x + cos * x - sin * y, pose.y + sin * x + cos * y};
    most = std::max(most, geometry::signed_distance(body, corner));
  }
  return most;
}

}  // namespace vandplan::driving
