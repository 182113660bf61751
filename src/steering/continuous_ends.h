// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a path begin and end with given curvatures?
//
// The path straightens the wheels, follows a word, and turns the wheels again; in either gear at
// either end. If the word begins by driving the first clothoid back, both are left out.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "steering/continuous_families.h"
#include "vandplan/continuous_steering.h"
#include "vandplan/geometry.h"

namespace vandplan::steering {

/// A query at unit radius. The first pose is at the origin, under its heading in the world.
struct EndsTask {
  Pose from, to;
  Stops stops;
  double start_curvature = 0.0, goal_curvature = 0.0;  ///< 0 where the vehicle stands
  double cutoff = 0.0;  ///< longer paths are of no use [turning radii]
};

/// The task at unit radius of a query between two finite poses [m].
[[nodiscard]] EndsTask ends_task(const ContinuousSteering& steering, const Pose& from,
                                 const Pose& to, const ContinuousQuery& query);

/// The segments and the length of a path, in turning radii.
struct UnitPath {
  UnitSegments segments;
  double length = 0.0;
};

/// The shortest path of the families; nothing if it is longer than the cutoff.
[[nodiscard]] std::optional<UnitPath> least_path(const WordSolver& solver, const EndsTask& task);

/// Length of `least_path` [turning radii]; infinity if it is longer than the cutoff.
[[nodiscard]] double least_length(const WordSolver& solver, const EndsTask& task);

/// All paths of the families up to the cutoff.
[[nodiscard]] std::vector<UnitPath> all_paths(const WordSolver& solver, const EndsTask& task);

/// A task, and the gears in which its word begins and ends where the wheels are straight; 0: any.
struct PricedEnds {
  EndsTask task;
  int first_gear = 0, last_gear = 0;
};

/// Receives a path and the index of its task; returns the cost that later paths have to undercut.
using TakePath = std::function<double(std::size_t task, const UnitPath&)>;

/// Prices of driving a path, and the gears around it, which may cost a gear change.
struct PathPrices {
  GearPrices word;
  int before = 0, after = 0;  ///< gears driven before and after the path; 0: any
};

/// Calls `take` with the paths of cheap words (see `for_cheap_words`) of up to four tasks.
void for_cheap_paths(const WordSolver& solver, std::span<const PricedEnds> tasks,
                     const PathPrices& prices, int gear_changes, double cutoff,
                     const TakePath& take);

/// The path at a turning `radius` [m].
[[nodiscard]] Piece scaled(const UnitPath& path, double radius);

}  // namespace vandplan::steering
