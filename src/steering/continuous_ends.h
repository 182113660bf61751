// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path begin and end with given curvatures?
//
// It drives until the wheels are straight, follows a word, and turns them again: in either gear at
// either end. Where the word would begin by driving back what was just driven, neither is driven.

#include <optional>
#include <vector>

#include "steering/continuous_families.h"
#include "vandplan/geometry.h"

namespace vandplan::steering {

/// Two poses at unit radius, the first at the origin, and the curvatures there: 0 where the vehicle
/// stands.
struct EndsTask {
  Pose from, to;
  Stops stops;
  double start_curvature = 0.0, goal_curvature = 0.0;
  double cutoff = 0.0;
};

/// What is driven, and how far, in turning radii.
struct UnitPath {
  UnitSegments segments;
  double length = 0.0;
};

/// The shortest path of the families, if it is no longer than the cutoff.
[[nodiscard]] std::optional<UnitPath> least_path(const WordSolver& solver, const EndsTask& task);

/// Its length; infinity if it is longer than the cutoff.
[[nodiscard]] double least_length(const WordSolver& solver, const EndsTask& task);

/// All paths of the families up to the cutoff.
[[nodiscard]] std::vector<UnitPath> all_paths(const WordSolver& solver, const EndsTask& task);

}  // namespace vandplan::steering
