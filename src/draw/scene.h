// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a picture show, and which part of the world is visible?

#include <array>
#include <optional>
#include <vector>

#include "draw/canvas.h"
#include "vandplan/draw.h"

namespace vandplan::drawing {

/// Outline of a moving obstacle at one of the times that are shown.
struct Shadow {
  Polygon outline;
  double strength = 1.0;  ///< Strength of its colour: 1 at time 0, less later.
};

/// Drawing moved near the origin, so that every coordinate is exact to less than a pixel.
struct Scene {
  Point origin;  ///< Origin of the local frame in the scenario's frame: whole kilometres [m].
  Vehicle vehicle;
  Bounds bounds;
  Pose start;
  Pose goal;
  EndHitchAngles hitch_angles;      ///< Used if the vehicle has a trailer.
  std::vector<Polygon> via_areas;   ///< Areas of vias where the midpoint of an axle may be.
  std::vector<State> vias;          ///< Some poses of vias.
  std::vector<Polygon> goal_areas;  ///< Areas of a goal set where the midpoint of an axle may be.
  std::vector<State> goals;         ///< Some poses of a goal set; empty if `goal` is the only goal.
  std::vector<std::array<Pose, 2>> stretches;  ///< Both ends of straight lines through goals.
  std::vector<Polygon> obstacles;
  std::vector<Polygon> kerbs;
  std::vector<Polygon> inside;  ///< Areas that the body must stay inside.
  std::vector<Zone> zones;
  std::optional<OccupancyGrid> map;
  std::vector<OccupancyGrid> masks;  ///< Maps without unknown cells, on which nothing is drawn.
  std::vector<OccupancyGrid> faint_masks;  ///< Masks that limit speeds or have prices: where.
  std::vector<Shadow> shadows;             ///< Moving obstacles, the latest time first.
  std::optional<Path> path;
  double margin = 0.0;           ///< Margin around the swept area [m].
  TreeSnapshot tree;             ///< Empty if there is no tree.
  std::vector<Polygon> hit;      ///< Outlines of obstacles that start or goal hit.
  std::vector<Pose> driven;      ///< Driven poses; empty if there are none.
  bool curvature_strip = false;  ///< Whether to draw the strip; only true with a path.
};

/// Scene of a drawing. Throws InputError if the scenario is missing or invalid (`check_scenario`),
/// or a number of the drawing is not finite.
[[nodiscard]] Scene scene_of(const Drawing& drawing);

/// Stretch of a path in one gear, as a chain of poses.
struct Stroke {
  int direction = 1;  ///< Gear: 1 forward, -1 reverse.
  std::vector<Pose> poses;
  std::vector<Pose> trailer;  ///< Pose of the trailer at each pose; empty if there is none.
};

/// Outlines of vehicle and trailer, each in its own frame.
struct Bodies {
  Polygon vehicle;
  Polygon trailer;  ///< Empty without a trailer.
};

[[nodiscard]] Bodies bodies_of(const Scene& scene);

/// Outline moved from its own frame to a pose.
[[nodiscard]] Polygon placed(const Polygon& outline, const Pose& pose);

/// Path of a scene, divided at gear changes; its poses are at most `step` apart [m].
[[nodiscard]] std::vector<Stroke> strokes_of(const Scene& scene, double step);

/// Visible part of the world.
struct Framing {
  Bounds seen;              ///< In the local frame [m].
  bool is_cropped = false;  ///< Whether some object lies outside.
};

/// Visible part of a scene: start, goal and path with all objects around them, and the bounds
/// unless they are far larger. A scene more than four times as large as start, goal and path is
/// cropped.
[[nodiscard]] Framing framed(const Scene& scene);

/// Position of the visible part of the world on the page.
struct View {
  Bounds visible;  ///< In the local frame [m].
  Box plot;
  double scale = 1.0;  ///< Page units per metre.

  [[nodiscard]] Point on_page(const Point& point) const noexcept;
};

/// View of `visible`, widened to the shape of `plot` for equal scales along x and y.
[[nodiscard]] View view_of(const Bounds& visible, const Box& plot) noexcept;

}  // namespace vandplan::drawing
