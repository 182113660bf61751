// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a drive with limited jerk made faster?

#include <span>
#include <vector>

#include "speed/caps.h"
#include "vandplan/motion.h"

namespace vandplan::speed {

/// Drive from stop to stop; times count from the start of the stretch.
struct SmoothDrive {
  std::vector<SpeedKnot> knots;
  double duration = 0.0;  // duration of the drive [s]
};

/// Near-optimal drive within `caps` and `limits`, which must have a jerk. `drive` must keep them.
/// If no faster drive is found, `drive` is the result.
[[nodiscard]] SmoothDrive made_faster(SmoothDrive drive, std::span<const Cap> caps,
                                      const DrivingLimits& limits);

}  // namespace vandplan::speed
