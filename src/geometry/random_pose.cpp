// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/random_pose.h"

#include <numbers>

namespace vandplan::geometry {

Pose uniform_pose(const Bounds& box, base::Rng& rng) {
  const double x = base::uniform(box.x_min, box.x_max, rng);
  const double y = base::uniform(box.y_min, box.y_max, rng);
  return {x, y, base::uniform(-std::numbers::pi, std::numbers::pi, rng)};
}

}  // namespace vandplan::geometry
