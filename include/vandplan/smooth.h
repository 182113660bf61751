// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path become cheaper, and one that the wheels can follow?
//
//   const auto smoothed = vandplan::smooth(problem, path, SmoothMethod::optimised);
//
// Method: docs/algorithms/smooth.md.

#include <span>
#include <string>
#include <string_view>

#include "vandplan/planner.h"

namespace vandplan {

/// Method by which a path is smoothed.
enum class SmoothMethod : std::uint8_t {
  clothoids,  ///< joints become clothoids; what becomes longer is shortened briefly
  optimised,  ///< the whole path is made cheaper for as long as the budget lasts
};

/// The method of that name, "clothoids" or "optimised". Throws InputError naming "method" for
/// another name.
[[nodiscard]] SmoothMethod smooth_method_named(std::string_view name);

/// The options of smoothing that hold unless others are set. Options of the run that planned the
/// path (`stored`) take precedence over those that the scenario wants.
///
/// The budget of that run does not count, nor a stored steering of reeds-shepp. Such a run allowed
/// jumps of the curvature, and smoothing removes them; with a trailer only if the cost is the time.
/// Throws InputError naming the option whose value is not valid.
[[nodiscard]] PlanOptions smooth_options(std::span<const Setting> scenario,
                                         std::span<const Setting> stored);

/// Result of smoothing a path.
struct Smoothed {
  PlanResult result = {};    ///< result of `plan` with the smoothed path
  PlanOptions options = {};  ///< options that were in force
  /// Cost of the path that was given, by these options [m] or [s].
  double given_cost = 0.0;
  /// Fault that the judge finds in the given path, by these options; empty: none. That the path
  /// ends at no goal of a set is no fault (see `smooth`).
  std::string given_fault = {};
  /// Whether the result is the path that was given, because nothing better was found.
  bool is_given = false;
};

/// Smooths a path in the scenario's frame. If the judge accepts the given path, the result is never
/// worse by these options: it costs no more, and strokes shorter than `min_stroke` become no
/// shorter in total.
///
/// With a set of goals, the goal is the one at which the path ends. If it ends at none, the goal is
/// its own end: the status is `solved` all the same, and `result.goal` is none. A run without a
/// limit of time or iterations takes `default_time_limit`.
///
/// Throws InputError as `plan` does, also naming "moving" if there are moving obstacles, and "path"
/// if it has a number that is not finite.
[[nodiscard]] Smoothed smooth(const Problem& problem, const Path& path,
                              SmoothMethod method = SmoothMethod::optimised,
                              const PlanOptions& options = {});

/// The planner that `smooth` runs: it keeps to the way of one path, whose segments lead from the
/// problem's start to its goal. The start of `path` is not used. Unless a steering is set, it is
/// `continuous_between_stops`, also with style `shortest`. With a trailer it is `reeds_shepp`,
/// unless the cost is the time. The planner is not among `planners()`.
///
/// - A path that is nearer than a millimetre to something may count as blocked.
/// - It finds no path where one beside the given path is needed that it does not see. Then
///   `no_path` proves nothing.
[[nodiscard]] Planner smoother(const Path& path, SmoothMethod method);

}  // namespace vandplan
