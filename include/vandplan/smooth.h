// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path from elsewhere become one that the wheels can follow?
//
// Method: docs/algorithms/smooth.md.

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

/// A planner that keeps to the way of one path from the problem's start to its goal: what it finds
/// steers as its options say, is free and, if the path itself can be driven so, costs no more; a
/// path that is nearer than a millimetre to something may count as blocked. It finds none where a
/// way beside the path is needed that it does not see; `no_path` proves nothing then. A value to be
/// handed to `plan`; it is not among `planners()`.
[[nodiscard]] Planner smoother(const Path& path, SmoothMethod method);

}  // namespace vandplan
