// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which paths join two poses with given curvatures?
//
// A path straightens the wheels, follows a word, and turns the wheels again; in either gear at
// either end. If the word begins by driving the first clothoid back, both are left out.

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "steering/continuous/query_tasks.h"
#include "steering/continuous/word_search.h"
#include "vandplan/path.h"

namespace vandplan::steering::continuous {

/// The segments and the length of a path, in turning radii.
struct UnitPath {
  UnitSegments segments;
  double length = 0.0;
};

/// The shortest path that the search finds; nothing if it is longer than the cutoff.
[[nodiscard]] std::optional<UnitPath> shortest_path(const WordSolver& solver,
                                                    const UnitQuery& query);

/// Length of `shortest_path` [turning radii]; infinity if it is longer than the cutoff.
[[nodiscard]] double shortest_length(const WordSolver& solver, const UnitQuery& query);

/// All paths up to the cutoff: those of all words, and those without a word.
[[nodiscard]] std::vector<UnitPath> all_paths(const WordSolver& solver, const UnitQuery& query);

/// A query, and the gears in which its word begins and ends where the wheels are straight; 0: any.
struct PricedQuery {
  UnitQuery query;
  int first_gear = 0, last_gear = 0;
};

/// Receives a path and the index of its query; returns the cost that later paths have to undercut.
using TakePath = std::function<double(std::size_t query, const UnitPath&)>;

/// Prices of driving a path, and the gears around it, which may cost a gear change.
struct PathPrices {
  GearPrices word;
  int before = 0, after = 0;  ///< gears driven before and after the path; 0: any
};

/// Calls `take` with the paths of the words of up to four queries (see `for_priced_words`).
void for_priced_paths(const WordSolver& solver, std::span<const PricedQuery> queries,
                      const PathPrices& prices, int gear_changes, double cutoff,
                      const TakePath& take);

/// The path at a turning `radius` [m].
[[nodiscard]] Piece scaled(const UnitPath& path, double radius);

}  // namespace vandplan::steering::continuous
