// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous/priced_pieces.h"

#include <limits>
#include <vector>

#include "steering/continuous/paths.h"
#include "steering/continuous/word_solver.h"

namespace vandplan::steering::continuous {

void for_priced_pieces(const ContinuousSteering& steering, const Pose& from, const Pose& to,
                       std::span<const PieceEnds> ends, const PieceRequest& request,
                       const TakePiece& take) {
  const double radius = steering.radius();
  const WordSolver solver(SharpTurns(steering.curvature_rate() * radius * radius));
  std::vector<PricedQuery> queries;
  queries.reserve(ends.size());
  for (const PieceEnds& e : ends) {
    queries.push_back({unit_query(steering, from, to, e.query), e.first_gear, e.last_gear});
  }
  const PathPrices prices{{request.forward, request.reverse, request.gear_change / radius},
                          request.before,
                          request.after};
  for_priced_paths(solver, queries, prices, request.gear_changes, request.cutoff / radius,
                   [&](std::size_t i, const UnitPath& path) {
                     const Piece piece = scaled(path, radius);
                     if (piece.count == 0) return std::numeric_limits<double>::infinity();
                     return take(piece, i) / radius;
                   });
}

}  // namespace vandplan::steering::continuous
