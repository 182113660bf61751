// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How fast may a vehicle be driven, and how fast can its wheels be turned?

#include <optional>

namespace vandplan {

/// Largest speeds, one for each gear [m/s]; > 0.
struct GearSpeeds {
  double forward = 2.5;
  double reverse = 1.5;
  bool operator==(const GearSpeeds&) const = default;
};

/// What bounds the motion of a vehicle along its path; the field names are keys of scenario files.
/// The defaults are for moving a truck in a yard (docs/formats.md has their sources). Where the
/// vehicle fits does not depend on them.
struct DrivingLimits {
  /// Of the angle of the front wheel of a bicycle, atan(wheelbase * curvature) [rad/s]; > 0. The
  /// wheels turn so fast at standstill, too.
  double max_steering_rate = 0.5;
  /// Change of curvature per metre driven [1/m^2]; > 0; none: what `max_steering_rate` allows
  /// everywhere at 1 m/s. It limits paths, not speeds.
  std::optional<double> max_curvature_rate = {};
  GearSpeeds max_speed = {};               ///< [m/s]
  double max_acceleration = 1.0;           ///< along the path, gaining speed [m/s^2]; > 0
  std::optional<double> max_braking = {};  ///< losing speed [m/s^2]; > 0; none: `max_acceleration`
  double max_lateral_acceleration = 1.5;   ///< speed^2 * |curvature| [m/s^2]; > 0
  std::optional<double> max_jerk = {};     ///< change of the acceleration [m/s^3]; > 0; none: any
  bool operator==(const DrivingLimits&) const = default;
};

/// Checks limits alone. Throws InputError naming "max_speed.forward" or another key.
void check_limits(const DrivingLimits& limits);

}  // namespace vandplan
