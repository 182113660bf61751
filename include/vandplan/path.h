// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a drivable path consist of, and where is it after s metres?

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan {

/// A stretch in one gear whose curvature is constant (an arc or a line) or changes evenly (a
/// clothoid).
struct Segment {
  double curvature = 0.0;       ///< at the start [1/m]; positive turns left when driving forward
  double length = 0.0;          ///< driven distance [m]; negative is in reverse
  double curvature_rate = 0.0;  ///< change of curvature per metre driven, in either gear [1/m^2]
  bool operator==(const Segment&) const = default;
};

/// Curvature of a segment after `driven` metres, 0 to its length in either gear [1/m].
[[nodiscard]] inline double curvature_at(const Segment& segment, double driven) noexcept {
  if (segment.curvature_rate == 0.0) return segment.curvature;
  return segment.curvature + segment.curvature_rate * driven;
}

/// What of a segment is driven from `begin` to `end` [m], 0 <= begin <= end <= its length.
[[nodiscard]] Segment part_of(const Segment& segment, double begin, double end) noexcept;

/// Room for segments that costs nothing until it is used: whoever holds it knows which are there.
class SegmentRoom {
 public:
  [[nodiscard]] static constexpr std::size_t size() noexcept { return 16; }

  [[nodiscard]] Segment* data() noexcept { return reinterpret_cast<Segment*>(bytes_.data()); }
  [[nodiscard]] const Segment* data() const noexcept {
    return reinterpret_cast<const Segment*>(bytes_.data());
  }
  [[nodiscard]] Segment& operator[](std::size_t i) noexcept { return data()[i]; }
  [[nodiscard]] const Segment& operator[](std::size_t i) const noexcept { return data()[i]; }

 private:
  // A segment is a plain value, so bytes become one as soon as one is written there.
  alignas(Segment) std::array<std::byte, 16 * sizeof(Segment)> bytes_;
};

/// The result of one steering call, held in place so that a planner's loop allocates nothing.
/// Segments of length zero do not occur; equal poses give none.
struct Piece {
  SegmentRoom segments;    ///< the first `count` are there
  std::uint8_t count = 0;  ///< at most `SegmentRoom::size()`
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

  [[nodiscard]] std::span<const Segment> view() const noexcept { return {segments.data(), count}; }
};

/// The way back: from the end of `piece` to its start, over the same ground in the other gear.
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
  double curvature = 0.0;  ///< there, of the segment driven next (at the end: last) [1/m]
  int direction = 1;       ///< 1 forward, -1 reverse
};

/// Where the vehicle is after driving the segment: exact but for rounding, a clothoid too
/// (docs/algorithms/clothoid.md).
[[nodiscard]] Pose advance(const Pose& pose, const Segment& segment) noexcept;
[[nodiscard]] inline LocalPose advance(const LocalPose& pose, const Segment& segment) noexcept {
  return Local(advance(static_cast<const Pose&>(pose), segment));
}

/// Sum of the absolute segment lengths [m].
[[nodiscard]] double length(std::span<const Segment> segments) noexcept;

/// Sum of the absolute segment lengths of the path [m].
[[nodiscard]] double length(const Path& path) noexcept;

/// How often the direction of travel changes; segments of length zero do not count.
[[nodiscard]] int gear_changes(std::span<const Segment> segments) noexcept;

/// How often the direction of travel changes on the path.
[[nodiscard]] int gear_changes(const Path& path) noexcept;

/// The pose at the end of the path. Like `pose_at` and `sampled` it adds up the way beside the
/// path's start, so that paths far from the origin keep what a double can hold.
[[nodiscard]] Pose end_pose(const Path& path) noexcept;

/// The pose after `s` metres of the path, clamped to [0, length].
[[nodiscard]] Pose pose_at(const Path& path, double s) noexcept;

/// Points of the path at most `step` [m] apart, both ends of every segment among them. Throws
/// InputError unless the path is finite, `step` > 0, and the points are 10^7 at most.
[[nodiscard]] std::vector<PathPoint> sampled(const Path& path, double step);

/// Neighbouring segments joined where gear and curvature go on (clothoids: at the same rate),
/// segments of length zero left out.
[[nodiscard]] std::vector<Segment> merged(std::span<const Segment> segments);

}  // namespace vandplan
