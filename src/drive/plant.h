// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a vehicle move that is told how to?
//
// Eq. 1 of the thesis, x' = v cos h, y' = v sin h, h' = v tan(phi) / wheelbase, with wheels, engine
// and brakes that do no more than they can.

#include "vandplan/rig.h"

namespace vandplan::driving {

inline constexpr double control_period = 0.02;  ///< between two commands [s]
inline constexpr int steps_per_period = 4;
inline constexpr double step_duration = control_period / steps_per_period;  ///< [s]

/// A vehicle that moves. Its pose may be what it believes; all the rest it knows.
struct State {
  Pose pose = {};
  double hitch_angle = 0.0;     ///< of its trailer [rad]; it may be what it believes, too
  double v = 0.0;               ///< as its wheels turn, in its gear [m/s]; >= 0
  int direction = 1;            ///< gear: 1 forward, -1 reverse
  double steering_angle = 0.0;  ///< as the steering says [rad]
};

/// What the vehicle is asked to do for one control period. It never does more than its limits say.
struct Command {
  double steering_angle = 0.0;  ///< to be reached at the end of the period [rad]
  double acceleration = 0.0;    ///< in its gear [m/s^2]
  int direction = 1;            ///< the gear, which changes at standstill only; it brakes for that
  std::size_t stroke = 0;       ///< of the path, to which this belongs
};

/// How much the motion differs from what the vehicle knows of it.
struct ActuatorError {
  double steering_offset = 0.0;  ///< [rad]
  double steering_share = 0.0;   ///< of the angle
  double speed_share = 0.0;      ///< of the speed
};

/// The wheels' angle that the vehicle never exceeds [rad].
[[nodiscard]] double largest_steering_angle(const Vehicle& vehicle) noexcept;

/// The vehicle whose limits planned speeds keep: a share of steering rate, acceleration and braking
/// is left for corrections.
[[nodiscard]] Vehicle with_reserve(Vehicle vehicle, double reserve);

/// How fast the wheels turn to do what a command asks for within a period, at most as fast as they
/// can [rad/s].
[[nodiscard]] double steering_rate(const State& state, const Command& command,
                                   const Vehicle& vehicle) noexcept;

/// What is driven in a moment.
struct Moved {
  double steering_angle = 0.0;  ///< meanwhile, as the steering says [rad]
  double length = 0.0;          ///< as the wheels turn; negative in reverse; 0 at standstill [m]
};

/// Moves on by `step_duration`: speed, gear and steering angle, not the pose.
[[nodiscard]] Moved step(State& state, const Command& command, double steering_rate,
                         const Vehicle& vehicle) noexcept;

/// The arc that is really driven.
[[nodiscard]] Segment arc_of(const Moved& moved, const Vehicle& vehicle,
                             const ActuatorError& error = {}) noexcept;

/// Where a vehicle gets by an arc, and its trailer if it has one.
[[nodiscard]] RigState moved_by(const Vehicle& vehicle, const RigState& from,
                                const Segment& arc) noexcept;

/// Moves the vehicle along the arc that it believes to drive.
void move_on(State& state, const Moved& moved, const Vehicle& vehicle) noexcept;

/// The state after one control period, if the vehicle moves as it believes.
[[nodiscard]] State after_period(State state, const Command& command,
                                 const Vehicle& vehicle) noexcept;

}  // namespace vandplan::driving
