// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where may a path end, if not at one pose alone?

#include <cstddef>
#include <numbers>

#include "vandplan/geometry.h"

namespace vandplan {

/// All numbers from `least` to `most`, both of them included.
struct Interval {
  double least = 0.0;
  double most = 0.0;
  bool operator==(const Interval&) const = default;
};

/// All headings from one counter-clockwise to another, both of them included. Equal ones are that
/// heading alone.
struct HeadingRange {
  double from = 0.0;  ///< [rad]
  double to = 0.0;    ///< [rad]
  bool operator==(const HeadingRange&) const = default;
};

/// Whichever way it points.
inline constexpr HeadingRange any_heading{-std::numbers::pi, std::numbers::pi};

/// How far it is from the first heading counter-clockwise to the last [rad]: at most a full turn if
/// `to` is no more than that above `from`.
[[nodiscard]] double width(const HeadingRange& range) noexcept;

/// Poses where a path may end: every place with every heading.
struct GoalRegion {
  Interval x = {};    ///< of the midpoint of the rear axle [m]
  Interval y = {};    ///< [m]
  Polygon area = {};  ///< simple polygon that replaces `x` and `y`, its edge included; or none
  HeadingRange heading = {};
  bool either_way = false;    ///< whether the headings turned by half a turn are goals, too
  double curvature = 0.0;     ///< `EndCurvatures::goal` [1/m]
  Interval hitch_angle = {};  ///< heading of the vehicle - heading of its trailer [rad]
  /// Whether place and heading are those of the trailer's axle.
  bool is_of_trailer = false;
  bool operator==(const GoalRegion&) const = default;
};

/// The region that holds one pose alone.
[[nodiscard]] GoalRegion region_of_pose(const Pose& pose) noexcept;

/// Some pose of the axle that a region speaks of: about in its middle; heading in [-pi, pi).
[[nodiscard]] Pose some_pose(const GoalRegion& region);

/// Whether the region holds more than a few poses: its place, its heading or its hitch angle is an
/// interval.
[[nodiscard]] bool is_continuous(const GoalRegion& region) noexcept;

/// The goal of a set that a path ends at.
struct ReachedGoal {
  std::size_t index = 0;  ///< of the region in its set
  Pose pose = {};         ///< of the vehicle; of this region
  bool operator==(const ReachedGoal&) const = default;
};

}  // namespace vandplan
