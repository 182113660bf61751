// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How wrong are sensors and actuators?

#include <numbers>

#include "drive/plant.h"
#include "vandplan/random.h"

namespace vandplan::driving {

/// Standard deviations of errors at noise 1.
inline constexpr double position_noise = 0.02;  ///< error of a measured position, along x and y [m]
/// Error of a measured heading [rad].
inline constexpr double heading_noise = 0.2 * std::numbers::pi / 180;
inline constexpr double hitch_noise = heading_noise;  ///< error of a measured hitch angle [rad]
/// Constant error of the steering angle [rad].
inline constexpr double steering_offset = 0.2 * std::numbers::pi / 180;
/// Relative error of the steering angle and of the speed.
inline constexpr double share_noise = 0.01;

/// Random number of mean 0 and standard deviation 1. The sum of twelve uniform numbers is normal
/// enough, and equal on every machine.
[[nodiscard]] inline double normal(Rng& rng) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += uniform01(rng);
  return sum;
}

/// Random errors of the actuators, constant during one drive.
[[nodiscard]] inline ActuatorError actuator_error(double noise, Rng& rng) {
  ActuatorError error;
  error.steering_offset = noise * steering_offset * normal(rng);
  error.steering_share = noise * share_noise * normal(rng);
  error.speed_share = noise * share_noise * normal(rng);
  return error;
}

/// Measured pose: the true pose plus random errors.
[[nodiscard]] inline Pose measured(const Pose& pose, double noise, Rng& rng) {
  const double x = pose.x + noise * position_noise * normal(rng);
  const double y = pose.y + noise * position_noise * normal(rng);
  return {x, y, wrap_angle(pose.heading + noise * heading_noise * normal(rng))};
}

/// Measured hitch angle: the true angle plus a random error [rad].
[[nodiscard]] inline double measured_hitch_angle(double angle, double noise, Rng& rng) {
  return wrap_angle(angle + noise * hitch_noise * normal(rng));
}

}  // namespace vandplan::driving
