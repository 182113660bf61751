// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path begin and end with given curvatures?
//
// It drives until the wheels are straight, follows a word, and turns them again: in either gear at
// either end. Where the word would begin by driving back what was just driven, neither is driven.

#include <functional>
#include <optional>
#include <vector>

#include "steering/continuous_families.h"
#include "vandplan/continuous_steering.h"
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

/// What a query between two finite poses means.
[[nodiscard]] EndsTask ends_task(const ContinuousSteering& steering, const Pose& from,
                                 const Pose& to, const ContinuousQuery& query);

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

/// Calls `take` with the paths of the wanted words that are no longer than these may be.
void for_each_wanted_path(const WordSolver& solver, const EndsTask& task, const WantedWords& wanted,
                          const std::function<void(const UnitPath&)>& take);

/// The path for a turning radius [m].
[[nodiscard]] Piece scaled(const UnitPath& path, double radius);

}  // namespace vandplan::steering
