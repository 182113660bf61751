// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a vehicle move when it gets commands?
//
// Eq. 1 of the thesis, x' = v cos h, y' = v sin h, h' = v tan(phi) / wheelbase, with limits of
// steering, acceleration and braking.

#include "vandplan/vehicle.h"

namespace vandplan::driving {

inline constexpr double control_period = 0.02;  ///< time between two commands [s]
inline constexpr int steps_per_period = 4;
/// Duration of one simulation step [s].
inline constexpr double step_duration = control_period / steps_per_period;

/// State of a moving vehicle. Pose and hitch angle may be estimates; the rest is known exactly.
struct MovingState {
  Pose pose = {};
  double hitch_angle = 0.0;     ///< hitch angle of the trailer [rad]
  double v = 0.0;               ///< speed in the current gear, as the wheels roll [m/s]; >= 0
  int direction = 1;            ///< gear: 1 forward, -1 reverse
  double steering_angle = 0.0;  ///< steering angle without actuator error [rad]
};

/// Command for one control period. The vehicle keeps its limits whatever the command asks for.
struct Command {
  double steering_angle = 0.0;  ///< steering angle at the end of the period [rad]
  double acceleration = 0.0;    ///< acceleration in the gear of the command [m/s^2]
  int direction = 1;            ///< gear; it changes at standstill, so the vehicle brakes before
  std::size_t stroke = 0;       ///< index of the path's stroke that the command belongs to
};

/// Errors of the actuators, which the vehicle does not know.
struct ActuatorError {
  double steering_offset = 0.0;  ///< constant error of the steering angle [rad]
  double steering_share = 0.0;   ///< relative error of the steering angle
  double speed_share = 0.0;      ///< relative error of the speed
};

/// Largest steering angle of the vehicle [rad].
[[nodiscard]] double largest_steering_angle(const Vehicle& vehicle) noexcept;

/// Vehicle with reduced limits for planned speeds: the share `reserve` of steering rate,
/// acceleration and braking is left for corrections.
[[nodiscard]] Vehicle with_reserve(Vehicle vehicle, double reserve);

/// Steering rate that reaches the angle of a command within a period, clamped to the limit [rad/s].
[[nodiscard]] double steering_rate(const MovingState& state, const Command& command,
                                   const Vehicle& vehicle) noexcept;

/// Motion during one simulation step.
struct Moved {
  /// Mean steering angle during the step, without actuator error [rad].
  double steering_angle = 0.0;
  double length = 0.0;  ///< rolled distance; negative in reverse, 0 at standstill [m]
};

/// Advances speed, gear and steering angle of `state` by `step_duration`; the pose stays.
[[nodiscard]] Moved step(MovingState& state, const Command& command, double steering_rate,
                         const Vehicle& vehicle) noexcept;

/// Arc of a motion with actuator errors.
[[nodiscard]] Segment arc_of(const Moved& moved, const Vehicle& vehicle,
                             const ActuatorError& error = {}) noexcept;

/// Advances pose and hitch angle of `state` by a motion without actuator errors.
void move_on(MovingState& state, const Moved& moved, const Vehicle& vehicle) noexcept;

/// State after one control period without actuator errors.
[[nodiscard]] MovingState after_period(MovingState state, const Command& command,
                                       const Vehicle& vehicle) noexcept;

}  // namespace vandplan::driving
