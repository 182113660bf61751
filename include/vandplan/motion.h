// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// When is the vehicle where on its path, and what else moves?

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

// ---- How fast may a path be driven, and where is the vehicle when? ----
//
// Method: docs/algorithms/speed.md.

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
/// wheels turn, or a limit of the place says so.
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

/// Limit of the speed on a part of a path, both ends included. A limit of 0 at one place: the
/// vehicle stands there.
struct SpeedLimit {
  double begin = 0.0;      ///< driven distance from the start to the begin of the part [m]
  double end = 0.0;        ///< driven distance from the start to the end of the part [m]
  double max_speed = 0.0;  ///< largest speed there, in either gear [m/s]; > 0, or a stop
  bool operator==(const SpeedLimit&) const = default;
};

/// Facts about a drive that its path does not tell.
struct SpeedOptions {
  double start_curvature = 0.0;         ///< curvature of the wheels before the drive [1/m]
  std::vector<SpeedLimit> limits = {};  ///< limits of places, such as zones and stops
};

/// Largest jump of the steering angle that a vehicle drives through [rad]: numbers in files are
/// rounded. At a larger jump the vehicle stands until its wheels are turned.
inline constexpr double ignored_steering_jump = 1e-6;

/// The fastest drive along a path that keeps all of `vehicle.limits` and the limits of places. It
/// stands at start, goal, gear changes and stops, and wherever the curvature jumps until the wheels
/// are turned. Without a limit of jerk no drive is shorter by 0.1 %. With one the drive keeps it
/// and is near the shortest.
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

// ---- What else moves, and does the vehicle meet it on its way? ----
//
// Times count from the moment at which the vehicle is at the start of its path. Method:
// docs/algorithms/moving.md.

/// What happens to a moving obstacle after the last row of its trajectory.
enum class Afterwards : std::uint8_t {
  stays,   ///< the obstacle stands there for ever
  leaves,  ///< the obstacle is gone, as a car that has left the yard
};

/// Name of the value: "stays" or "leaves".
[[nodiscard]] std::string_view name_of(Afterwards after) noexcept;

/// A pose at a time.
struct TimedPose {
  double t = 0.0;  ///< time [s]
  Pose pose = {};
  bool operator==(const TimedPose&) const = default;
};

/// A vehicle, a person or a door that moves by itself. The field names are keys of scenario files.
struct MovingObstacle {
  /// A simple polygon in the obstacle's own frame [m]. It is closed: touching it is a contact.
  Polygon outline = {};
  /// Poses of the obstacle's own frame over time: at least one row, t increases. Between two rows
  /// the obstacle moves and turns evenly, the shorter way round. Before the first row it stands
  /// there.
  std::vector<TimedPose> trajectory = {};
  Afterwards after = Afterwards::stays;  ///< what happens after the last row
  /// Growth of the outline on all sides per second, from t = 0 to the last row [m/s]; >= 0. It
  /// stands for predictions that become less certain.
  double inflate = 0.0;
  bool operator==(const MovingObstacle&) const = default;
};

/// Pose of the obstacle's own frame at time `t` [s], in the frame of its trajectory. The heading is
/// not wrapped. None after the last row if the obstacle leaves then, or without a trajectory.
[[nodiscard]] std::optional<Pose> pose_at(const MovingObstacle& obstacle, double t) noexcept;

/// Growth of the outline on all sides at time `t` [s], in metres.
[[nodiscard]] double growth_at(const MovingObstacle& obstacle, double t) noexcept;

/// Time at which the last obstacle comes to rest or leaves [s]; 0 if there are none.
[[nodiscard]] double end_of_motion(std::span<const MovingObstacle> moving) noexcept;

/// A path and the speeds along it. After its duration the vehicle stands at the end of the path for
/// ever.
struct TimedPath {
  Path path;
  SpeedProfile speeds;
};

/// The moment at which a vehicle first comes too near to a moving obstacle.
struct Meeting {
  double t = 0.0;            ///< time [s]
  double s = 0.0;            ///< driven distance since the start of the path [m]
  Pose pose = {};            ///< pose of the vehicle, in the frame of the path
  std::size_t obstacle = 0;  ///< index of the obstacle in the list
};

/// Largest distance beyond the margin at which a meeting may be reported [m].
inline constexpr double meeting_tolerance = 1e-3;

/// First moment of the drive, or after it, at which the footprint is within `margin` of a moving
/// obstacle [m]. None if there is no such moment. All arguments share one frame.
///
/// There is no step size, so no meeting is missed. There is none where all obstacles stay more than
/// `meeting_tolerance` beyond the margin. A trailer counts, and begins in line with the vehicle.
///
/// Throws InputError naming "segments[3]" (not finite), "drive.speeds" (no knots), "margin"
/// (negative) or "moving[2]" (fewer than three corners, or no trajectory).
[[nodiscard]] std::optional<Meeting> first_meeting(const TimedPath& drive, const Vehicle& vehicle,
                                                   std::span<const MovingObstacle> moving,
                                                   double margin);

}  // namespace vandplan
