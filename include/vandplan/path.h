// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a drivable path consist of, and where is it after s metres?

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// A stretch of constant curvature and gear.
struct Segment {
  double curvature = 0.0;  ///< [1/m]; positive turns left when driving forward, 0 is straight
  double length = 0.0;     ///< driven distance [m]; negative is in reverse
  bool operator==(const Segment&) const = default;
};

/// The result of one steering call: at most five segments, held in place so that a planner's
/// loop allocates nothing. Segments of length zero do not occur; equal poses give none.
struct Piece {
  std::array<Segment, 5> segments{};
  std::uint8_t count = 0;
  double length = 0.0;  ///< sum of the absolute segment lengths [m]

  [[nodiscard]] std::span<const Segment> view() const noexcept { return {segments.data(), count}; }
};

/// The same way driven backwards: from the end of `piece` to its start.
[[nodiscard]] Piece reversed(const Piece& piece) noexcept;

/// A start pose and what is driven from it.
struct Path {
  Pose start;
  std::vector<Segment> segments;
  bool operator==(const Path&) const = default;
};

/// A pose on a path, with what a follower wants to know about it.
struct PathPoint {
  double s = 0.0;  ///< driven distance since the start [m]
  Pose pose;
  double curvature = 0.0;  ///< of the segment driven next (at the end: last) [1/m]
  int direction = 1;       ///< 1 forward, -1 reverse
};

/// Where the vehicle is after driving the segment (exact circular arc or line).
[[nodiscard]] Pose advance(const Pose& pose, const Segment& segment) noexcept;

/// Sum of the absolute segment lengths [m].
[[nodiscard]] double length(std::span<const Segment> segments) noexcept;

/// How often the direction of travel changes; segments of length zero do not count.
[[nodiscard]] int gear_changes(std::span<const Segment> segments) noexcept;

[[nodiscard]] Pose end_pose(const Path& path) noexcept;

/// The pose after `s` metres, clamped to [0, length].
[[nodiscard]] Pose pose_at(const Path& path, double s) noexcept;

/// Points at most `step` [m] apart, both ends of every segment among them. `step` > 0.
[[nodiscard]] std::vector<PathPoint> sampled(const Path& path, double step);

/// Neighbouring segments of equal curvature and gear joined, segments of length zero left out.
[[nodiscard]] std::vector<Segment> merged(std::span<const Segment> segments);

}  // namespace vandplan
