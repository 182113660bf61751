// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How fast may a vehicle be driven, and how fast can its wheels be turned?

#include <optional>

namespace vandplan {

/// Largest speeds, one for each gear [m/s]; > 0.
struct GearSpeeds {
  double forward = 2.5;  ///< largest speed forward [m/s]
  double reverse = 1.5;  ///< largest speed in reverse, without sign [m/s]
  bool operator==(const GearSpeeds&) const = default;
};

/// Limits of a vehicle's motion along its path. The field names are keys of scenario files. The
/// defaults are for moving a truck in a yard (sources: docs/lab/tools.md). Where the vehicle fits
/// does not depend on them.
struct DrivingLimits {
  /// Largest rate of the steering angle [rad/s], at standstill too; > 0. The angle is that of the
  /// front wheel of a bicycle, atan(wheelbase * curvature).
  double max_steering_rate = 0.5;
  /// Largest change of curvature per metre driven [1/m^2]; > 0. None: what `max_steering_rate`
  /// allows at 1 m/s with any curvature. It limits paths, not speeds.
  std::optional<double> max_curvature_rate = {};
  GearSpeeds max_speed = {};  ///< largest speed in each gear [m/s]
  /// Largest acceleration along the path, gaining speed [m/s^2]; > 0.
  double max_acceleration = 1.0;
  /// Largest deceleration along the path, without sign [m/s^2]; > 0. None: `max_acceleration`.
  std::optional<double> max_braking = {};
  double max_lateral_acceleration = 1.5;  ///< largest speed^2 * |curvature| [m/s^2]; > 0
  /// Largest change of the acceleration per second [m/s^3]; > 0. None: no limit.
  std::optional<double> max_jerk = {};
  bool operator==(const DrivingLimits&) const = default;
};

/// Checks limits alone: each must be 0.001 to 1000 of its unit. Throws InputError naming
/// "max_speed.forward" or the key of another limit that is out of range.
void check_limits(const DrivingLimits& limits);

}  // namespace vandplan
