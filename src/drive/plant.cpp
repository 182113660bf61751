// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "drive/plant.h"

#include <algorithm>

#include "base/trigonometry.h"

namespace vandplan::driving {

double largest_steering_angle(const Vehicle& vehicle) noexcept {
  return vandplan::steering_angle(vehicle, 1.0 / vehicle.min_turning_radius);
}

double steering_rate(const MovingState& state, const Command& command,
                     const Vehicle& vehicle) noexcept {
  const double most = largest_steering_angle(vehicle);
  const double wanted = std::clamp(command.steering_angle, -most, most);
  const double rate = vehicle.limits.max_steering_rate;
  return std::clamp((wanted - state.steering_angle) / control_period, -rate, rate);
}

Moved step(MovingState& state, const Command& command, double steering_rate,
           const Vehicle& vehicle) noexcept {
  const DrivingLimits& limits = vehicle.limits;
  const double braking = limits.max_braking.value_or(limits.max_acceleration);
  if (state.v == 0.0) state.direction = command.direction;
  const bool is_in_gear = state.direction == command.direction;
  const double a =
      is_in_gear ? std::clamp(command.acceleration, -braking, limits.max_acceleration) : -braking;
  // 1. The distance. A vehicle that brakes comes to stand and stays.
  const double reached = state.v + a * step_duration;
  const double driven =
      reached >= 0.0 ? (state.v + reached) / 2 * step_duration : state.v * state.v / (-2 * a);
  state.v = std::max(reached, 0.0);
  // 2. The steering angle. The motion has the angle of half-time.
  const double turned = steering_rate * step_duration;
  const Moved moved{state.steering_angle + turned / 2, state.direction * driven};
  state.steering_angle += turned;
  return moved;
}

Segment arc_of(const Moved& moved, const Vehicle& vehicle, const ActuatorError& error) noexcept {
  const double angle = moved.steering_angle;
  const double real = angle + (error.steering_share * angle + error.steering_offset);
  const auto [sin, cos] = base::sin_cos(real);
  return {sin / cos / vehicle.wheelbase, moved.length * (1 + error.speed_share)};
}

void move_on(MovingState& state, const Moved& moved, const Vehicle& vehicle) noexcept {
  const State from{state.pose, state.hitch_angle};
  const State there = advance(vehicle, from, arc_of(moved, vehicle));
  state.pose = there.pose;
  state.hitch_angle = there.hitch_angle;
}

MovingState after_period(MovingState state, const Command& command,
                         const Vehicle& vehicle) noexcept {
  const double rate = steering_rate(state, command, vehicle);
  for (int i = 0; i < steps_per_period; ++i) {
    move_on(state, step(state, command, rate, vehicle), vehicle);
  }
  return state;
}

Vehicle with_reserve(Vehicle vehicle, double reserve) {
  constexpr double least = 1e-3;  // least value of a limit [m/s^2, rad/s]
  const auto less = [&](double limit) { return std::max((1 - reserve) * limit, least); };
  DrivingLimits& limits = vehicle.limits;
  limits.max_braking = less(limits.max_braking.value_or(limits.max_acceleration));
  limits.max_acceleration = less(limits.max_acceleration);
  limits.max_steering_rate = less(limits.max_steering_rate);
  return vehicle;
}

}  // namespace vandplan::driving
