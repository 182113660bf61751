// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What else moves, and does the vehicle meet it on its way?
//
// Times count from the moment at which the vehicle is at the start of its path. Method:
// docs/algorithms/moving.md.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/path.h"
#include "vandplan/speed.h"
#include "vandplan/vehicle.h"

namespace vandplan {

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
