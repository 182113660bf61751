// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a path wrong? A second judge, as naive as can be, for worlds that nobody looked at.
//
// It shares nothing with src/judge, src/collision or src/path: it integrates the path itself, in
// extended precision and with coordinates that count from the start, looks at poses that are really
// on the path, and asks of each whether a side of an obstacle runs through the footprint. It
// overlooks what happens between the poses that it looks at. What it refuses is really wrong: the
// footprint is made smaller by `allowed_depth` on every side, far above all rounding.

#include <string>

#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan::nasty {

/// Only a footprint that reaches further than this into something hits it [m].
inline constexpr double allowed_depth = 5e-5;

/// Only a path that ends further than this from the goal misses it [m, rad]; the documented limit
/// is 1e-6, and coordinates of 10^9 m are 1e-7 m apart.
inline constexpr double allowed_miss = 2e-6;

/// What is wrong with a path of a scenario, both in its frame; empty if nothing is.
[[nodiscard]] std::string naive_flaw(const Scenario& scenario, const Path& path);

/// What a vehicle hits or leaves at a pose of the scenario's frame, grown by `margin` [m] on every
/// side (negative: made smaller); empty if nothing.
[[nodiscard]] std::string naive_hit(const Scenario& scenario, const Pose& pose, double margin);

}  // namespace vandplan::nasty
