// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is there to see, and which part of it is shown?

#include <optional>
#include <vector>

#include "draw/canvas.h"
#include "vandplan/draw.h"

namespace vandplan::drawing {

/// What moves, at one of the times at which it is shown.
struct Shadow {
  Polygon outline;
  double strength = 1.0;  ///< 1: at time 0; less the later it is
};

/// A drawing moved near the origin, where every coordinate is exact enough for a pixel.
struct Scene {
  Point origin;  ///< of the local frame, in the scenario's frame: whole kilometres [m]
  Vehicle vehicle;
  Bounds bounds;
  Pose start;
  Pose goal;
  EndHitchAngles hitch_angles;      ///< of account if the vehicle has a trailer
  std::vector<Polygon> goal_areas;  ///< of a set of goals: where the midpoint of an axle may be
  std::vector<RigState> goals;  ///< some poses of a set of goals; empty if `goal` is the only one
  std::vector<Polygon> obstacles;
  std::vector<Polygon> kerbs;
  std::vector<Polygon> inside;  ///< areas that the body does not leave
  std::optional<OccupancyGrid> map;
  std::vector<Shadow> shadows;  ///< of what moves; the latest first
  std::optional<Path> path;
  double margin = 0.0;           ///< around what the path sweeps [m]
  TreeSnapshot tree;             ///< empty when there is none
  std::vector<Polygon> hit;      ///< what is in the way of start or goal
  std::vector<Pose> driven;      ///< empty when nobody drove
  bool curvature_strip = false;  ///< and there is a path
};

/// Throws InputError when the scenario is none (`check_scenario`), has no such goal, or a number of
/// the path or the tree is not finite.
[[nodiscard]] Scene scene_of(const Drawing& drawing);

/// A stretch of a path in one gear, as a chain of poses.
struct Stroke {
  int direction = 1;  ///< 1 forward, -1 reverse
  std::vector<Pose> poses;
  std::vector<Pose> trailer;  ///< where it is at each pose; empty if there is none
};

/// The outlines of what is drawn on its way, each in its own frame.
struct Bodies {
  Polygon vehicle;
  Polygon trailer;  ///< none without one
};

[[nodiscard]] Bodies bodies_of(const Scene& scene);

/// An outline where a pose puts it.
[[nodiscard]] Polygon placed(const Polygon& outline, const Pose& pose);

/// The path of a scene cut where the gear changes, its poses at most `step` apart [m].
[[nodiscard]] std::vector<Stroke> strokes_of(const Scene& scene, double step);

/// The part of the world that is shown.
struct Framing {
  Bounds seen;              ///< in the local frame [m]
  bool is_cropped = false;  ///< some of what stands there lies outside
};

/// Start, goal and path with all that stands around them, obstacles, kerbs and map, and the bounds
/// unless they lie far beyond. A scene that is more than four times as large as start, goal and
/// path is cropped.
[[nodiscard]] Framing framed(const Scene& scene);

/// Where the visible part of the world lies on the page.
struct View {
  Bounds visible;  ///< in the local frame [m]
  Box plot;
  double scale = 1.0;  ///< page units per metre

  [[nodiscard]] Point on_page(const Point& point) const noexcept;
};

/// `visible` widened to the shape of `plot`, equal scales along x and y.
[[nodiscard]] View view_of(const Bounds& visible, const Box& plot) noexcept;

}  // namespace vandplan::drawing
