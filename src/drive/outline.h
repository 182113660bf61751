// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is a vehicle's outline outside of its planned outline?

#include <algorithm>

#include "base/trigonometry.h"
#include "geometry/convex.h"
#include "vandplan/vehicle.h"

namespace vandplan::driving {

/// Largest distance of a point of a convex body at `pose` from the body at the origin [m]. A corner
/// is furthest, as the distance from a convex set is a convex function.
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
