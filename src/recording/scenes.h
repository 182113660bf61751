// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a recording show of a scenario, a plan and a drive?
//
// All values are in the frame "site", except for bodies that move with their own frame. Heights are
// made up, because scenarios have none.

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "recording/messages.h"
#include "vandplan/judge.h"
#include "vandplan/motion.h"
#include "vandplan/problem.h"

namespace vandplan::recording {

/// Frame of the scenario.
inline constexpr std::string_view map_frame = "map";
/// Frame of what is recorded. Its origin is near the start, because viewers compute in floats.
inline constexpr std::string_view site_frame = "site";
/// Frame of the midpoint of the rear axle, x ahead.
inline constexpr std::string_view vehicle_frame = "vehicle";
/// Frame of the midpoint of the trailer's axle, x ahead.
inline constexpr std::string_view trailer_frame = "trailer";

/// The scenario in a frame with the origin `origin`.
[[nodiscard]] Scenario moved_to(const Scenario& scenario, const Point& origin);

/// Bounds, obstacles, kerbs, areas, start and goals. The obstacle `hit` is red.
[[nodiscard]] SceneChange ground_scene(const Scenario& scenario, const std::optional<Hit>& hit);

/// The bodies of vehicle and trailer, which move with their frames.
[[nodiscard]] SceneChange vehicle_scene(const Vehicle& vehicle);

/// Moving obstacles at time `t` [s].
[[nodiscard]] SceneChange moving_scene(std::span<const MovingObstacle> moving, double t);

/// Points of a path with the hitch angles there.
struct SampledPath {
  std::vector<PathPoint> points;
  std::vector<double> hitch_angles;  ///< one for each point [rad]
};

/// A path as a line in the colours of the gears, with footprints along it.
[[nodiscard]] SceneChange path_scene(const Vehicle& vehicle, const SampledPath& path);

/// A search tree as lines between nodes and parents.
[[nodiscard]] SceneChange tree_scene(const TreeSnapshot& tree);

/// The line of the rear axle along a drive.
[[nodiscard]] SceneChange driven_scene(std::span<const DriveMoment> log);

/// A text above a place.
[[nodiscard]] SceneChange label_scene(std::string_view text, const Pose& pose);

}  // namespace vandplan::recording
