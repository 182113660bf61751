// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is this path really valid?
//
// The independent judge: it shares no code with the checker, the planners or the kernels. Its
// method: docs/algorithms/path_check.md.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {

/// Where somebody says that the path is after `s` metres.
struct StatedPose {
  double s = 0.0;  ///< [m]
  Pose pose;
  std::optional<double> curvature = {};    ///< [1/m]
  std::optional<int> direction = {};       ///< 1 forward, -1 reverse
  std::optional<double> hitch_angle = {};  ///< [rad]
};

/// What somebody says that a path costs.
struct StatedCost {
  /// [m]; what being near things adds is believed to 1e-3 of it. Where the cost is the time [s]: to
  /// 1e-3 of it, or, with a limit of jerk, no less than without one.
  double cost = 0.0;
  CostOptions rule = {};             ///< prices that are not set: as in `shortest_style`
  std::optional<double> bound = {};  ///< no path costs less
  std::optional<double> gap = {};    ///< cost / bound - 1
};

/// What somebody says about a path; whatever is stated is checked. A bound is not proven again, but
/// must not be above the cost.
struct PathClaims {
  std::optional<double> length = {};  ///< [m]
  std::optional<int> gear_changes = {};
  std::optional<StatedCost> cost = {};
  /// How far the path stays from things: the footprint from obstacles and the map, the wheels from
  /// kerbs; less a millimetre on the ramps, which begin at the ends of the path.
  ClearanceOptions clearance = {};
  /// Where the curvature may jump. Unless anywhere, it changes by no more than
  /// `max_curvature_rate` of the vehicle per metre; if nowhere, it is that of the problem at both
  /// ends.
  Steering steering = Steering::reeds_shepp;
  /// In which gears it is driven: a metre in another one is a fault.
  AllowedGears gears = AllowedGears::both;
  /// Which goal of a set it ends at; its pose is in the frame of the path.
  std::optional<ReachedGoal> goal = {};
  std::optional<double> start_hitch_angle = {};  ///< [rad]
  /// From end to end, at most 0.1 m apart, in the frame of the path; none: nothing is said.
  std::vector<StatedPose> poses = {};
};

/// What a vehicle may touch, come too near to, or leave.
enum class HitKind : std::uint8_t { obstacle, kerb, map, bounds, inside };

/// The key of a scenario file: "obstacles", "kerbs", "map", "bounds", "inside".
[[nodiscard]] std::string_view name_of(HitKind kind) noexcept;

/// The kind with that name; none if there is no such kind.
[[nodiscard]] std::optional<HitKind> hit_kind_named(std::string_view name) noexcept;

/// Whether a scenario has a list of such things, so that `Hit::index` says which one is hit.
[[nodiscard]] bool has_index(HitKind kind) noexcept;

/// What a vehicle touches, comes too near to, or leaves.
struct Hit {
  HitKind kind = HitKind::obstacle;
  std::size_t index = 0;  ///< of the obstacle, kerb or area to stay in, in the scenario
  /// Middle of the cell of the map, in the scenario's frame; `PlanResult::hit` alone says it.
  std::optional<Point> cell = {};
  bool operator==(const Hit&) const = default;
};

/// The judge's verdict.
struct PathCheck {
  bool valid = false;
  std::string reason = {};           ///< the first thing found wrong, one line; empty when valid
  std::optional<PathPoint> at = {};  ///< where it is wrong, if at a place; in the scenario's frame
  std::optional<Hit> hit = {};       ///< what is hit, or left, if that is what is wrong
  /// The goal that the path ends at, in the scenario's frame. None if the problem has one goal pose
  /// only, or if the path ends at no goal.
  std::optional<ReachedGoal> goal = {};
  double length = 0.0;          ///< [m]
  double reverse_length = 0.0;  ///< of it in reverse [m]
  int gear_changes = 0;
  double largest_hitch_angle = 0.0;  ///< absolute, of what was looked at [rad]; 0: no trailer
  double curvature_change = 0.0;  ///< total variation of the curvature, at gear changes, too [1/m]
  /// Least distance between footprint and obstacles or cells, or wheels and kerbs, at most 1 mm too
  /// large [m]: 0 if they touch, infinity if there are none. None if the path was found wrong
  /// before collisions were looked for.
  std::optional<double> clearance = {};
};

/// Judges a path in the scenario's frame, in this order: every number is finite, it
/// begins at the start, every curvature is drivable, the wheels turn and the gears are as is
/// claimed, the rear axle stays in the bounds, the whole body stays in the area of `inside` in
/// which it begins, the footprint touches no obstacle and no blocked cell and the wheels no kerb,
/// both of the vehicle and of its trailer, whose hitch angle stays within its limit (looked at
/// every millimetre that a point of the vehicle moves, skipping only what is proven to be free),
/// they keep the margin that is claimed, it ends at the goal, or at one of a set, within 1e-6 m and
/// 1e-6 rad, and what is claimed is true.
[[nodiscard]] PathCheck check_path(const Problem& problem, const Path& path,
                                   const PathClaims& claims = {});

}  // namespace vandplan
