// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a path like to drive?

#include "vandplan/path.h"

namespace vandplan::evaluation {

/// How a path is driven: at constant speed, with a stop at every gear change.
struct DrivingStyle {
  double speed = 2.0;  ///< [m/s]; > 0
  double pause = 3.0;  ///< for one gear change [s]; >= 0
};

/// Figures of a path that need no map; its clearance is the judge's to say.
struct PathMetrics {
  double length = 0.0;  ///< [m]
  int gear_changes = 0;
  double reverse_share = 0.0;  ///< of the length, in [0, 1]
  double turning = 0.0;        ///< sum of the absolute changes of heading [rad]
  int curvature_changes = 0;   ///< how often the steering wheel must be turned
  double driving_time = 0.0;   ///< [s]
};

/// Throws InputError when the style is out of range.
void validate(const DrivingStyle& style);

/// Throws InputError when the style is out of range.
[[nodiscard]] PathMetrics metrics_of(const Path& path, const DrivingStyle& style);

}  // namespace vandplan::evaluation
