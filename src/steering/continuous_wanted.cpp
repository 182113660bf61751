// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_wanted.h"

#include <algorithm>
#include <cmath>

#include "steering/continuous_ends.h"
#include "steering/continuous_families.h"

namespace vandplan::steering {
namespace {

bool are_equal(const Piece& a, const Piece& b, double radius) {
  const double small = 1e-9 * radius;
  if (a.count != b.count || std::abs(a.length - b.length) > small) return false;
  for (std::size_t i = 0; i < a.count; ++i) {
    const Segment& s = a.segments[i];
    const Segment& t = b.segments[i];
    if (std::abs(s.length - t.length) > small) return false;
    if (std::abs(s.curvature - t.curvature) * radius > 1e-9) return false;
  }
  return true;
}

}  // namespace

void find_continuous_words(const ContinuousSteering& steering, const Pose& from, const Pose& to,
                           const ContinuousQuery& query, const WantedContinuous& wanted,
                           std::vector<Piece>& words) {
  words.clear();
  const double radius = steering.radius();
  const WordSolver solver(SharpTurns(steering.curvature_rate() * radius * radius));
  const EndsTask task = ends_task(steering, from, to, query);
  // Where bent wheels are straightened first, a word begins in any gear.
  const WantedWords likely{wanted.gear_changes, wanted.longest / radius,
                           task.start_curvature == 0 ? wanted.first_gear : 0,
                           task.goal_curvature == 0 ? wanted.last_gear : 0};
  for_each_wanted_path(solver, task, likely, [&](const UnitPath& path) {
    const Piece piece = scaled(path, radius);
    const auto is_equal = [&](const Piece& other) { return are_equal(piece, other, radius); };
    if (piece.count > 0 && piece.length < wanted.longest &&
        std::none_of(words.begin(), words.end(), is_equal)) {
      words.push_back(piece);
    }
  });
}

}  // namespace vandplan::steering
