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

/// What keeps a vehicle from being faster.
enum class SpeedBound : std::uint8_t {
  max_speed,             ///< of the gear
  lateral_acceleration,  ///< in a turn
  steering_rate,         ///< the wheels turn as fast as they can while it drives
  acceleration,          ///< it gains speed as fast as it may
  braking,               ///< it loses speed as fast as it may
  jerk,                  ///< the acceleration changes as fast as it may
  standing,              ///< it stands, and the wheels turn
};

/// "max_speed", "lateral_acceleration", ...
[[nodiscard]] std::string_view name_of(SpeedBound bound) noexcept;

/// A moment of a drive. Until the next one the acceleration is `a`, or changes by `jerk`.
struct SpeedKnot {
  double t = 0.0;     ///< since the start [s]
  double s = 0.0;     ///< driven distance since the start, reverse metres count [m]
  double v = 0.0;     ///< speed, never negative, in reverse neither [m/s]
  double a = 0.0;     ///< change of the speed, right after this moment [m/s^2]
  double jerk = 0.0;  ///< change of the acceleration [m/s^3]; 0 without a limit of it
  SpeedBound bound = SpeedBound::standing;  ///< until the next one
};

/// A place where the vehicle stands on its way, or at the start: the gear changes, or the wheels
/// turn, or both.
struct Stop {
  double t = 0.0;                 ///< when it comes to stand [s]
  double s = 0.0;                 ///< where: driven distance since the start [m]
  double pause = 0.0;             ///< how long it stands, until the wheels are turned [s]; >= 0
  double curvature_before = 0.0;  ///< that the wheels are turned to when it comes [1/m]
  double curvature_after = 0.0;   ///< and when it goes on [1/m]
};

/// The speeds along a path.
struct SpeedProfile {
  std::vector<SpeedKnot> knots = {};  ///< t increases, v is continuous; from start to goal
  std::vector<Stop> stops = {};       ///< where it stands between start and goal, or turns wheels
  double duration = 0.0;              ///< of all [s]
  double standing = 0.0;              ///< sum of the pauses [s]
};

/// What else is known about a drive.
struct SpeedOptions {
  double start_curvature = 0.0;  ///< that the wheels are turned to before the drive [1/m]
};

/// The largest jump of the steering angle that is driven through [rad], as numbers in files are
/// rounded. At larger ones the vehicle stands until its wheels are turned.
inline constexpr double ignored_steering_jump = 1e-6;

/// The fastest drive along a path that keeps all of `vehicle.limits` and stands at start, goal and
/// gear changes, and wherever the curvature jumps until the wheels are turned. Without a limit of
/// jerk no drive is shorter by 0.1 %; with one the drive keeps it and is near the shortest. Throws
/// InputError naming a limit that is out of range, or a segment that is not finite.
[[nodiscard]] SpeedProfile speed_profile(const Path& path, const Vehicle& vehicle,
                                         const SpeedOptions& options = {});

/// Where a vehicle is on its drive, and how it moves.
struct Motion {
  double t = 0.0;               ///< since the start [s]
  double s = 0.0;               ///< driven distance since the start [m]
  Pose pose = {};               ///< in the frame of the path
  double curvature = 0.0;       ///< that the wheels are turned to [1/m]
  double steering_angle = 0.0;  ///< of the front wheel of a bicycle [rad]; positive to the left
  int direction = 1;            ///< 1 forward, -1 reverse; standing: what is driven next
  double v = 0.0;               ///< speed; negative in reverse [m/s]
  double a = 0.0;               ///< change of v: negative when speeding up in reverse [m/s^2]
};

/// The motion at time `t` [s], clamped to the drive's. `path`, `vehicle` and `profile` belong
/// together.
[[nodiscard]] Motion motion_at(const Path& path, const Vehicle& vehicle,
                               const SpeedProfile& profile, double t);

/// The motion at all multiples of `step` [s], at start and goal, and when a pause begins and ends;
/// t increases strictly. `step` > 0.
[[nodiscard]] std::vector<Motion> sampled(const Path& path, const Vehicle& vehicle,
                                          const SpeedProfile& profile, double step);

}  // namespace vandplan
