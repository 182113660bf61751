// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a drivable path consist of, and where is it after s metres?

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// Gear of a vehicle: the way in which it drives.
enum class Gear : std::int8_t { forward = 1, reverse = -1 };

/// Name of the gear: "forward" or "reverse".
[[nodiscard]] std::string_view name_of(Gear gear) noexcept;
/// Direction of travel: 1 forward, -1 reverse.
[[nodiscard]] constexpr int direction_of(Gear gear) noexcept { return static_cast<int>(gear); }
/// Gear of a signed length, speed or direction: reverse if it is negative.
[[nodiscard]] constexpr Gear gear_of(double direction) noexcept {
  return direction < 0.0 ? Gear::reverse : Gear::forward;
}

/// Gears in which a path may drive.
enum class AllowedGears : std::uint8_t {
  both,
  forward,  ///< no metre in reverse, as the car of Dubins
  reverse,  ///< no metre forward
};

/// Part of a path in one gear. Its curvature is constant (an arc or a line) or changes linearly
/// with the driven distance (a clothoid).
struct Segment {
  /// Curvature at the start of the segment [1/m]; positive turns left when driving forward.
  double curvature = 0.0;
  /// Driven distance [m]; negative in reverse.
  double length = 0.0;
  /// Change of curvature per metre driven, in either gear [1/m^2]; 0 on arcs and lines.
  double curvature_rate = 0.0;
  /// Gear in which the segment is driven.
  [[nodiscard]] constexpr Gear gear() const noexcept { return gear_of(length); }
  bool operator==(const Segment&) const = default;
};

/// Curvature of a segment after `driven` metres [1/m]. `driven` is from 0 to |length|, in either
/// gear.
[[nodiscard]] inline double curvature_at(const Segment& segment, double driven) noexcept {
  if (segment.curvature_rate == 0.0) return segment.curvature;
  return segment.curvature + segment.curvature_rate * driven;
}

/// The part of a segment between two driven distances [m], 0 <= begin <= end <= |length|.
[[nodiscard]] Segment part_of(const Segment& segment, double begin, double end) noexcept;

/// Storage for 16 segments without initialisation. Whoever holds it counts which segments are
/// valid.
class SegmentRoom {
 public:
  /// Number of segments for which there is storage.
  [[nodiscard]] static constexpr std::size_t size() noexcept { return 16; }

  [[nodiscard]] Segment* data() noexcept { return reinterpret_cast<Segment*>(bytes_.data()); }
  [[nodiscard]] const Segment* data() const noexcept {
    return reinterpret_cast<const Segment*>(bytes_.data());
  }
  [[nodiscard]] Segment& operator[](std::size_t i) noexcept { return data()[i]; }
  [[nodiscard]] const Segment& operator[](std::size_t i) const noexcept { return data()[i]; }

 private:
  // A segment is a plain value: bytes become a segment as soon as one is written to them.
  alignas(Segment) std::array<std::byte, 16 * sizeof(Segment)> bytes_;
};

/// Result of one steering call, held in place so that a planner's loop allocates nothing. No
/// segment has length zero. Equal poses give a piece without segments.
struct Piece {
  SegmentRoom segments;    ///< only the first `count` segments are valid
  std::uint8_t count = 0;  ///< number of segments; at most `SegmentRoom::size()`
  double length = 0.0;     ///< sum of the absolute segment lengths [m]

  Piece() noexcept = default;
  Piece(const Piece& other) noexcept : count(other.count), length(other.length) {
    std::copy_n(other.segments.data(), count, segments.data());
  }
  Piece& operator=(const Piece& other) noexcept {
    count = other.count;
    length = other.length;
    if (this != &other) std::copy_n(other.segments.data(), count, segments.data());
    return *this;
  }

  /// The valid segments; they live as long as the piece.
  [[nodiscard]] std::span<const Segment> view() const noexcept { return {segments.data(), count}; }
};

/// The piece back from the end of `piece` to its start, over the same ground in the other gear.
[[nodiscard]] Piece reversed(const Piece& piece) noexcept;

/// A path: its start pose and the segments driven from there. Its frame is that of `start`.
struct Path {
  Pose start;
  std::vector<Segment> segments;
  bool operator==(const Path&) const = default;
};

/// A pose on a path, with what a path follower needs.
struct PathPoint {
  double s = 0.0;  ///< driven distance since the start [m]
  Pose pose;       ///< pose in the frame of the path
  /// Curvature at the pose [1/m]: of the segment driven next, or of the last one at the end of the
  /// path.
  double curvature = 0.0;
  Gear gear = Gear::forward;
};

/// Pose after driving the segment from `pose`, in the frame of `pose`; heading in [-pi, pi). It is
/// exact but for rounding, for clothoids too (docs/algorithms/clothoid.md).
[[nodiscard]] Pose advance(const Pose& pose, const Segment& segment) noexcept;
/// Pose after driving the segment from a pose in the world's frame, in that frame.
[[nodiscard]] inline LocalPose advance(const LocalPose& pose, const Segment& segment) noexcept {
  return Local(advance(static_cast<const Pose&>(pose), segment));
}

/// Sum of the absolute segment lengths [m].
[[nodiscard]] double length(std::span<const Segment> segments) noexcept;

/// Sum of the absolute segment lengths of the path [m].
[[nodiscard]] double length(const Path& path) noexcept;

/// Number of changes between forward and reverse. Segments of length zero do not count.
[[nodiscard]] int gear_changes(std::span<const Segment> segments) noexcept;

/// Number of changes between forward and reverse on the path.
[[nodiscard]] int gear_changes(const Path& path) noexcept;

/// Pose at the end of the path, in its frame. Like `pose_at` and `sampled`, this function sums
/// poses relative to the path's start. So paths far from the origin keep the precision of a double.
/// All three give headings in [-pi, pi); on a path without segments they give its start as it is.
[[nodiscard]] Pose end_pose(const Path& path) noexcept;

/// Pose after `s` metres of the path, in its frame. `s` is clamped to [0, length].
[[nodiscard]] Pose pose_at(const Path& path, double s) noexcept;

/// Points of the path from start to end, at most `step` apart [m]: each segment is divided into
/// equal parts. The ends of every segment are among them. A path without segments gives its start
/// alone.
///
/// Throws InputError naming "segments[3]" for a segment that is not finite, or "step" unless it
/// is > 0 and at least a 10^7th of the path's length.
[[nodiscard]] std::vector<PathPoint> sampled(const Path& path, double step);

/// The segments, with neighbours joined where gear and curvature continue (clothoids: with an equal
/// rate). Segments of length zero are left out.
[[nodiscard]] std::vector<Segment> merged(std::span<const Segment> segments);

// ---- Where may a path end, if not at one pose alone? ----

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
  /// Length of the straight line with which a path ends, in either gear [m]; 0: none is asked for.
  double straight = 0.0;
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

/// What a path passes on its way to the goal: a pose of one of these regions. They ask neither for
/// a curvature nor for a straight last stretch. The frame is that of whoever holds it.
struct Via {
  std::vector<GoalRegion> any_of = {};  ///< regions, of which the path passes one
  /// Whether the vehicle stands there, so that the gear may change there, and the wheels may turn
  /// unless the steering is `continuous`. Otherwise it drives through.
  bool stop = false;
  bool operator==(const Via&) const = default;
};

/// Where a path passes a via.
struct PassedVia {
  double s = 0.0;  ///< driven distance since the start [m]
  Pose pose = {};  ///< pose of the vehicle there
  bool operator==(const PassedVia&) const = default;
};

}  // namespace vandplan
