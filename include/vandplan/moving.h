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

/// What becomes of something that moves after its last row.
enum class Afterwards : std::uint8_t {
  stays,   ///< it stands there for ever
  leaves,  ///< it is gone, as a car that has left the yard
};

/// "stays" or "leaves".
[[nodiscard]] std::string_view name_of(Afterwards after) noexcept;

/// Where something is at a time.
struct TimedPose {
  double t = 0.0;  ///< [s]
  Pose pose = {};
  bool operator==(const TimedPose&) const = default;
};

/// A vehicle, a person or a door that moves by itself. The field names are keys of scenario files.
struct MovingObstacle {
  /// A simple polygon in a frame of its own [m]. It is closed: touching it is a contact.
  Polygon outline = {};
  /// Where that frame is when: at least one row, t increases. From row to row it moves and turns
  /// evenly, the shorter way round. Before the first row it stands there.
  std::vector<TimedPose> trajectory = {};
  Afterwards after = Afterwards::stays;
  /// The outline grows by so much on all sides for each second from t = 0 to the last row, as what
  /// is predicted becomes less certain [m/s]; >= 0.
  double inflate = 0.0;
  bool operator==(const MovingObstacle&) const = default;
};

/// Where the frame of the obstacle is at time `t`; none once it has left, or without a trajectory.
[[nodiscard]] std::optional<Pose> pose_at(const MovingObstacle& obstacle, double t) noexcept;

/// How much larger the outline is at time `t` than it says, on all sides [m].
[[nodiscard]] double growth_at(const MovingObstacle& obstacle, double t) noexcept;

/// When the last of them comes to rest or leaves [s]; 0 if there are none.
[[nodiscard]] double end_of_motion(std::span<const MovingObstacle> moving) noexcept;

/// A path and when the vehicle is where on it. It stands at the end of the path for ever after.
struct TimedPath {
  Path path;
  SpeedProfile speeds;
};

/// The moment when a vehicle first comes too near to something that moves.
struct Meeting {
  double t = 0.0;            ///< [s]
  double s = 0.0;            ///< driven distance [m]
  Pose pose = {};            ///< of the vehicle, in the frame of the path
  std::size_t obstacle = 0;  ///< which one it meets
};

/// How far from its margin the vehicle may still be at a meeting [m].
inline constexpr double meeting_tolerance = 1e-3;

/// The first moment of the drive, or after it, at which the footprint is within `margin` [m] of
/// something that moves. Without a step size: none is missed, and there is none where all keep
/// `meeting_tolerance` more than the margin. Everything in one frame.
[[nodiscard]] std::optional<Meeting> first_meeting(const TimedPath& drive, const Vehicle& vehicle,
                                                   std::span<const MovingObstacle> moving,
                                                   double margin);

}  // namespace vandplan
