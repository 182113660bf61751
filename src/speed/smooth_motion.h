// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a drive without jumps of the acceleration made faster?

#include <span>
#include <vector>

#include "speed/caps.h"
#include "vandplan/speed.h"

namespace vandplan::speed {

/// A drive from stop to stop, with times since the start of the stretch.
struct SmoothDrive {
  std::vector<SpeedKnot> knots;
  double duration = 0.0;  // [s]
};

/// A faster drive within the caps and `limits`, whose jerk must be there, near the fastest; the
/// given one, which keeps them, if none is found.
[[nodiscard]] SmoothDrive made_faster(SmoothDrive drive, std::span<const Cap> caps,
                                      const DrivingLimits& limits);

}  // namespace vandplan::speed
