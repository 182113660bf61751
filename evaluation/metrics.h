// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How easily is a path driven?

#include "vandplan/path.h"

namespace vandplan::evaluation {

/// Simple model of driving: constant speed, with a pause at every gear change.
struct DrivingStyle {
  double speed = 2.0;  ///< speed [m/s]; > 0
  double pause = 3.0;  ///< pause at one gear change [s]; >= 0
};

/// Figures of a path that need no map. The clearance comes from the judge.
struct PathMetrics {
  double length = 0.0;  ///< length in either gear [m]
  int gear_changes = 0;
  double reverse_share = 0.0;  ///< share of the length in reverse, in [0, 1]
  double turning = 0.0;        ///< sum of the absolute changes of heading [rad]
  int curvature_changes = 0;   ///< number of times the steering wheel is turned
  double driving_time = 0.0;   ///< driving time under `DrivingStyle` [s]
};

/// Throws InputError when the style is out of range.
void validate(const DrivingStyle& style);

/// Figures of a path under a style. Throws InputError when the style is out of range.
[[nodiscard]] PathMetrics metrics_of(const Path& path, const DrivingStyle& style);

}  // namespace vandplan::evaluation
