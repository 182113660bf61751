// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How wrong are sensors and actuators?

#include <numbers>

#include "drive/plant.h"
#include "vandplan/random.h"

namespace vandplan::driving {

/// Standard deviations at noise 1.
inline constexpr double position_noise = 0.02;                           ///< along x and y [m]
inline constexpr double heading_noise = 0.2 * std::numbers::pi / 180;    ///< [rad]
inline constexpr double hitch_noise = heading_noise;                     ///< of a hitch angle
inline constexpr double steering_offset = 0.2 * std::numbers::pi / 180;  ///< [rad]
inline constexpr double share_noise = 0.01;  ///< of the steering angle, and of the speed

/// A number of mean 0 and standard deviation 1: twelve even ones together are normal enough, and
/// the sum is the same on every machine.
[[nodiscard]] inline double normal(Rng& rng) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += uniform01(rng);
  return sum;
}

/// What the actuators do wrong during one drive.
[[nodiscard]] inline ActuatorError actuator_error(double noise, Rng& rng) {
  ActuatorError error;
  error.steering_offset = noise * steering_offset * normal(rng);
  error.steering_share = noise * share_noise * normal(rng);
  error.speed_share = noise * share_noise * normal(rng);
  return error;
}

/// Where a vehicle is, as it is measured.
[[nodiscard]] inline Pose measured(const Pose& pose, double noise, Rng& rng) {
  const double x = pose.x + noise * position_noise * normal(rng);
  const double y = pose.y + noise * position_noise * normal(rng);
  return {x, y, wrap_angle(pose.heading + noise * heading_noise * normal(rng))};
}

/// The angle between vehicle and trailer, as it is measured.
[[nodiscard]] inline double measured_hitch_angle(double angle, double noise, Rng& rng) {
  return wrap_angle(angle + noise * hitch_noise * normal(rng));
}

}  // namespace vandplan::driving
