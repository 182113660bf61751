// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_wanted.h"

#include <limits>
#include <vector>

#include "steering/continuous_ends.h"
#include "steering/continuous_families.h"

namespace vandplan::steering {

void for_wanted_words(const ContinuousSteering& steering, const Pose& from, const Pose& to,
                      std::span<const WantedEnds> ends, const WantedContinuous& wanted,
                      const TakeWanted& take) {
  const double radius = steering.radius();
  const WordSolver solver(SharpTurns(steering.curvature_rate() * radius * radius));
  std::vector<PricedEnds> tasks;
  tasks.reserve(ends.size());
  for (const WantedEnds& e : ends) {
    tasks.push_back({ends_task(steering, from, to, e.query), e.first_gear, e.last_gear});
  }
  const PathPrices prices{
      {wanted.forward, wanted.reverse, wanted.gear_change / radius}, wanted.before, wanted.after};
  for_cheap_paths(solver, tasks, prices, wanted.gear_changes, wanted.cutoff / radius,
                  [&](std::size_t i, const UnitPath& path) {
                    const Piece piece = scaled(path, radius);
                    if (piece.count == 0) return std::numeric_limits<double>::infinity();
                    return take(piece, i) / radius;
                  });
}

}  // namespace vandplan::steering
