// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which words are tried between two states of a rig, and which is the cheapest?
//
// Lengths and prices are in turning radii. Steps have the numbers of section 4 of
// docs/algorithms/rig_steering.md.

#include <optional>
#include <vector>

#include "steering/mean_frame.h"
#include "steering/rig_word.h"
#include "vandplan/path.h"
#include "vandplan/steering.h"

namespace vandplan::steering {

/// Two states of a rig: the poses of the tractor, and the tangents of half the hitch angles.
struct RigEnds {
  MeanFrame frame;
  double start_u = 0.0;
  double goal_u = 0.0;
};

/// The cheapest path that the search finds up to the cutoff.
[[nodiscard]] std::optional<Piece> least_rig_path(const RigWordSolver& solver, const RigEnds& ends,
                                                  const RigPrices& prices);

/// The shortest path from the guesses that are tried first; nothing if they lead to none.
[[nodiscard]] std::optional<Piece> likely_rig_path(const RigWordSolver& solver,
                                                   const RigEnds& ends);

/// All paths that the search finds up to the cutoff, the cheapest first.
[[nodiscard]] std::vector<Piece> all_rig_paths(const RigWordSolver& solver, const RigEnds& ends,
                                               const RigPrices& prices);

}  // namespace vandplan::steering
