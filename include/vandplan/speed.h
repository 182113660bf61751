// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How fast may a path be driven, and where is the vehicle when?
//
// Method: docs/algorithms/speed.md.

#include <cstdint>
#include <string_view>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

/// Limit that keeps a vehicle from being faster.
enum class SpeedBound : std::uint8_t {
  max_speed,             ///< largest speed of the gear
  lateral_acceleration,  ///< largest lateral acceleration in a turn
  steering_rate,         ///< the wheels turn as fast as they can while the vehicle drives
  acceleration,          ///< the vehicle gains speed as fast as it may
  braking,               ///< the vehicle loses speed as fast as it may
  jerk,                  ///< the acceleration changes as fast as it may
  standing,              ///< the vehicle stands, and the wheels turn
};

/// Name of the limit: "max_speed", "lateral_acceleration", ...
[[nodiscard]] std::string_view name_of(SpeedBound bound) noexcept;

/// A moment of a drive. Until the next knot the acceleration is `a`, or changes by `jerk` per
/// second.
struct SpeedKnot {
  double t = 0.0;     ///< time since the start [s]
  double s = 0.0;     ///< driven distance since the start; metres in reverse count, too [m]
  double v = 0.0;     ///< speed [m/s]; never negative, not in reverse either
  double a = 0.0;     ///< change of the speed right after this moment [m/s^2]
  double jerk = 0.0;  ///< change of the acceleration [m/s^3]; 0 without a limit of jerk
  SpeedBound bound = SpeedBound::standing;  ///< limit that holds until the next knot
};

/// A place where the vehicle stands on its way, or at the start. The gear changes there, or the
/// wheels turn, or both.
struct Stop {
  double t = 0.0;                 ///< time at which the vehicle comes to stand [s]
  double s = 0.0;                 ///< driven distance since the start [m]
  double pause = 0.0;             ///< time until the wheels are turned [s]; >= 0
  double curvature_before = 0.0;  ///< curvature of the wheels when the vehicle comes [1/m]
  double curvature_after = 0.0;   ///< curvature of the wheels when the vehicle goes on [1/m]
};

/// Speeds along a path.
struct SpeedProfile {
  std::vector<SpeedKnot> knots = {};  ///< knots from start to goal; t increases, v is continuous
  /// Stops between start and goal, and at the start if the wheels turn there.
  std::vector<Stop> stops = {};
  double duration = 0.0;  ///< duration of the whole drive [s]
  double standing = 0.0;  ///< sum of the pauses [s]
};

/// Facts about a drive that its path does not tell.
struct SpeedOptions {
  double start_curvature = 0.0;  ///< curvature of the wheels before the drive [1/m]
};

/// Largest jump of the steering angle that a vehicle drives through [rad]: numbers in files are
/// rounded. At a larger jump the vehicle stands until its wheels are turned.
inline constexpr double ignored_steering_jump = 1e-6;

/// The fastest drive along a path that keeps all of `vehicle.limits`. It stands at start, goal and
/// gear changes, and wherever the curvature jumps until the wheels are turned. Without a limit of
/// jerk no drive is shorter by 0.1 %. With one the drive keeps it and is near the shortest.
///
/// Throws InputError naming a limit that is out of range ("max_speed.forward"),
/// "vehicle.wheelbase", "start_curvature", or "segments[3]" if it is not finite. The path may be
/// sharper than `min_turning_radius`, which does not count here.
[[nodiscard]] SpeedProfile speed_profile(const Path& path, const Vehicle& vehicle,
                                         const SpeedOptions& options = {});

/// Place and motion of a vehicle on its drive at one time.
struct Motion {
  double t = 0.0;               ///< time since the start [s]
  double s = 0.0;               ///< driven distance since the start [m]
  Pose pose = {};               ///< pose in the frame of the path
  double curvature = 0.0;       ///< curvature of the wheels [1/m]
  double steering_angle = 0.0;  ///< front-wheel angle of a bicycle [rad]; positive to the left
  Gear gear = Gear::forward;    ///< gear; at a stop that of the drive to come
  double v = 0.0;               ///< speed [m/s]; negative in reverse
  double a = 0.0;               ///< change of v [m/s^2]; negative when gaining speed in reverse
};

/// The motion at time `t` [s], which is clamped to the drive. `path`, `vehicle` and `profile`
/// belong together. Throws InputError naming "profile" without knots, or "t" if it is NaN.
[[nodiscard]] Motion motion_at(const Path& path, const Vehicle& vehicle,
                               const SpeedProfile& profile, double t);

/// The motion at start and goal, where each stop begins and its pause ends, and at multiples of
/// `step` [s]. Multiples within step/1000 of one of the other times are left out. The times
/// increase strictly; a stop without a pause, such as a gear change, has one time. Throws
/// InputError naming "profile" without knots, or "step" unless it is > 0 and at least a 10^7th of
/// the duration.
[[nodiscard]] std::vector<Motion> sampled(const Path& path, const Vehicle& vehicle,
                                          const SpeedProfile& profile, double step);

}  // namespace vandplan
