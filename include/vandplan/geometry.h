// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a point, a pose, a polygon, an angle?
//
// Metres and radians everywhere; headings count counter-clockwise from the x axis. All values are
// plain; frames are named by whoever holds them (docs/conventions.md).

#include <span>
#include <utility>
#include <vector>

namespace vandplan {

/// A position in the plane [m].
struct Point {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const Point&) const = default;
};

/// Where the midpoint of the rear axle is [m] and where the vehicle points [rad].
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  bool operator==(const Pose&) const = default;
};

/// A value in the frame of a world, which checkers and planners work in. It is a `T` for whatever
/// asks for one; a `T` becomes local by name alone: `Local(pose)`. A pose of the scenario's frame
/// becomes local by `to_local` (problem.h).
template <class T>
struct Local : T {
  Local() = default;
  constexpr explicit Local(T value) noexcept : T(std::move(value)) {}
};

/// A pose in the frame of a world.
using LocalPose = Local<Pose>;

/// Many poses as structure of arrays in float [m, rad], which batch queries read. The three columns
/// have equal sizes; headings are in [-pi, pi].
struct PoseColumns {
  std::span<const float> x;
  std::span<const float> y;
  std::span<const float> heading;
};

/// Corners of a simple polygon in order, convex or concave, either orientation, not closed
/// (the last corner differs from the first). At least three corners.
using Polygon = std::vector<Point>;

/// An axis-aligned box; closed: points on its border are inside.
struct Bounds {
  double x_min = 0.0;
  double x_max = 0.0;
  double y_min = 0.0;
  double y_max = 0.0;
  bool operator==(const Bounds&) const = default;
};

/// The angle in [-pi, pi) that differs from `angle` by whole turns [rad].
[[nodiscard]] double wrap_angle(double angle) noexcept;

/// Where `local`, a pose in the frame that the pose `frame` spans, lies in the frame that `frame`
/// itself is given in.
[[nodiscard]] Pose compose(const Pose& frame, const Pose& local) noexcept;
[[nodiscard]] inline LocalPose compose(const LocalPose& frame, const Pose& local) noexcept {
  return Local(compose(static_cast<const Pose&>(frame), local));
}

/// The pose `pose` in the frame that the pose `frame` spans: the inverse of `compose`. The heading
/// is in [-pi, pi).
[[nodiscard]] Pose relative(const Pose& frame, const Pose& pose) noexcept;

/// Whether the point lies in the box or on its border.
[[nodiscard]] bool contains(const Bounds& bounds, const Point& point) noexcept;

/// The smallest box around the points; all its numbers are zero if there are no points.
[[nodiscard]] Bounds bounding_box(std::span<const Point> points) noexcept;

/// Whether a simple polygon is convex; corners on the line between their neighbours do no harm.
[[nodiscard]] bool is_convex(std::span<const Point> polygon);

/// Whether a point lies inside a simple polygon, decided exactly; for a point on a side either
/// answer is possible.
[[nodiscard]] bool contains(std::span<const Point> polygon, const Point& point);

}  // namespace vandplan
