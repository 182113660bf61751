// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path begin and end with given curvatures?
//
// It drives until the wheels are straight, follows a word, and turns them again: in either gear at
// either end. Where the word would begin by driving back what was just driven, neither is driven.

#include <functional>
#include <optional>
#include <span>
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

/// A task, and in which gear its word begins and ends where the wheels are straight; 0: in either.
struct PricedEnds {
  EndsTask task;
  int first_gear = 0, last_gear = 0;
};

/// Takes the path of a task and says what the next ones have to undercut.
using TakePath = std::function<double(std::size_t task, const UnitPath&)>;

/// What driving costs before, on and after a path.
struct PathPrices {
  GearPrices word;
  int before = 0, after = 0;  ///< gears; 0: any
};

/// Calls `take` with the paths of cheap words (see `for_cheap_words`) of up to four tasks.
void for_cheap_paths(const WordSolver& solver, std::span<const PricedEnds> tasks,
                     const PathPrices& prices, int gear_changes, double cutoff,
                     const TakePath& take);

/// The path for a turning radius [m].
[[nodiscard]] Piece scaled(const UnitPath& path, double radius);

}  // namespace vandplan::steering
