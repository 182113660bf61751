// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where may a path end, if not at one pose alone?

#include <cstddef>
#include <numbers>

#include "vandplan/geometry.h"

namespace vandplan {

/// All numbers from `least` to `most`, both included. The unit is that of the field.
struct Interval {
  double least = 0.0;
  double most = 0.0;
  bool operator==(const Interval&) const = default;
};

/// All headings from one counter-clockwise to another, both included. Two equal headings are that
/// heading alone.
struct HeadingRange {
  double from = 0.0;  ///< first heading [rad]
  double to = 0.0;    ///< last heading [rad]
  bool operator==(const HeadingRange&) const = default;
};

/// Range of all headings.
inline constexpr HeadingRange any_heading{-std::numbers::pi, std::numbers::pi};

/// Angle counter-clockwise from the first heading to the last [rad]. It is at most a full turn if
/// `to` is at most a full turn above `from`.
[[nodiscard]] double width(const HeadingRange& range) noexcept;

/// Set of poses where a path may end: every place of it with every heading of it. The frame is that
/// of whoever holds the region. `with_goal_set` and `make_problem` (problem.h) check the values.
/// They throw InputError naming "goal.any_of[2].x" or another key of a region. In a set of one
/// region the key is "goal.x", and for a trailer's axle "goal.trailer.x".
struct GoalRegion {
  Interval x = {};  ///< x of the axle's midpoint [m]
  Interval y = {};  ///< y of the axle's midpoint [m]
  /// Simple polygon that replaces `x` and `y` [m], its edge included. Empty: `x` and `y` count.
  Polygon area = {};
  HeadingRange heading = {};  ///< headings of the vehicle, or of the trailer [rad]
  /// Whether the headings turned by half a turn are goals, too.
  bool either_way = false;
  double curvature = 0.0;     ///< curvature at the goal, as `EndCurvatures::goal` [1/m]
  Interval hitch_angle = {};  ///< heading of the vehicle - heading of its trailer [rad]
  /// Whether place and heading are those of the trailer's axle instead of the vehicle's rear axle.
  bool is_of_trailer = false;
  bool operator==(const GoalRegion&) const = default;
};

/// The region that holds one pose of a vehicle alone, in the frame of the pose. A trailer must be
/// straight there, with hitch angle 0.
[[nodiscard]] GoalRegion region_of_pose(const Pose& pose) noexcept;

/// A pose of the region, for the axle that the region speaks of, in the region's frame. It is in
/// the middle of all intervals, or at the first corner of the area. Its heading is in [-pi, pi).
[[nodiscard]] Pose some_pose(const GoalRegion& region);

/// Whether the region holds infinitely many goals: it has an area, or its x, y, heading or hitch
/// angle is an interval of more than one value.
[[nodiscard]] bool is_continuous(const GoalRegion& region) noexcept;

/// The goal of a set at which a path ends.
struct ReachedGoal {
  std::size_t index = 0;  ///< index of the region in its set
  Pose pose = {};         ///< pose of the vehicle at the goal
  bool operator==(const ReachedGoal&) const = default;
};

}  // namespace vandplan
