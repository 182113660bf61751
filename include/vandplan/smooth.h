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

/// What is done to a path.
enum class SmoothMethod : std::uint8_t {
  clothoids,  ///< joints become clothoids; what that makes longer is shortened for a moment
  optimised,  ///< all of it is made cheaper for as long as the budget lasts
};

/// "clothoids" or "optimised". Throws InputError naming "method" for another name.
[[nodiscard]] SmoothMethod smooth_method_named(std::string_view name);

/// The options of smoothing that hold unless others are set: those of the run that planned the path
/// (`stored`), above those that the scenario wants. The budget of that run does not count. Nor does
/// a stored steering of reeds-shepp: the run allowed jumps of the curvature, which smoothing takes
/// out where there is no trailer. Throws InputError naming the option whose value is no good.
[[nodiscard]] PlanOptions smooth_options(std::span<const Setting> scenario,
                                         std::span<const Setting> stored);

/// What smoothing made of a path.
struct Smoothed {
  PlanResult result = {};    ///< as of `plan`
  PlanOptions options = {};  ///< that were in force
  double given_cost = 0.0;   ///< of the path that was given, by these options [m] or [s]
  /// What the judge has against the path that was given, by these options; empty: nothing.
  std::string given_fault = {};
  bool is_given = false;  ///< the result is the path that was given: nothing better was found
};

/// Smooths a path, which is in the scenario's frame. If the judge passes the path that was given,
/// the result is never worse by these options: it costs no more, and strokes that are shorter than
/// `min_stroke` become no shorter, all together. Throws InputError as `plan` does, also where
/// something moves, and naming "path" for one with a number that is not finite.
[[nodiscard]] Smoothed smooth(const Problem& problem, const Path& path,
                              SmoothMethod method = SmoothMethod::optimised,
                              const PlanOptions& options = {});

/// The planner that `smooth` runs: it keeps to the way of one path from the problem's start to its
/// goal. Unless a steering is set it steers between stops, and with a trailer as reeds-shepp. A
/// path that is nearer than a millimetre to something may count as blocked. It finds none where a
/// way beside the path is needed that it does not see; `no_path` proves nothing then. It is not
/// among `planners()`.
[[nodiscard]] Planner smoother(const Path& path, SmoothMethod method);

}  // namespace vandplan
