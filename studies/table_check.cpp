// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/table_check.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "base/trigonometry.h"
#include "studies/percentile.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan::studies {
namespace {

// Relative tolerance of an entry. Float rounds by 6e-8; the rest is for libraries of other
// compilers.
constexpr double tolerance = 1e-6;

void compare(const HeuristicTable& table, const HeuristicTable::GridPoint& cell,
             EntryCheck& check) {
  const double exact = reeds_shepp_length(table.node_of(cell), table.sample_of(cell),
                                          table.options().turning_radius);
  const double entry = static_cast<double>(table.entries()[table.index_of(cell)]);
  const double difference = std::abs(entry - exact);
  ++check.compared;
  if (!(difference <= tolerance * exact)) ++check.wrong;
  if (std::isnan(check.worst_difference) || difference <= check.worst_difference) return;
  check.worst_difference = difference;
  check.worst = cell;
}

int index_below(int count, Rng& rng) {
  return static_cast<int>(uniform01(rng) * static_cast<double>(count));
}

}  // namespace

EntryCheck check_entries(const HeuristicTable& table, const EntryCheckOptions& options) {
  const int positions = table.positions();
  const int headings = table.headings();
  EntryCheck check;
  if (options.sample) {
    Rng rng(options.seed);
    while (check.compared < *options.sample) {
      const int x = index_below(positions, rng);
      const int y = index_below(positions, rng);
      const int node = index_below(headings, rng);
      compare(table, {x, y, node, index_below(headings, rng)}, check);
    }
    return check;
  }
  const int plane = headings * headings;
  for (int position = 0; position < positions * positions; ++position) {
    for (int pair = 0; pair < plane; ++pair) {
      compare(table, {position / positions, position % positions, pair / headings, pair % headings},
              check);
    }
  }
  return check;
}

BoundCheck check_bounds(std::int64_t pairs, std::uint64_t seed) {
  constexpr double pi = std::numbers::pi;
  Rng rng(seed);
  BoundCheck check{.pairs = pairs};
  std::vector<double> gaps;
  gaps.reserve(static_cast<std::size_t>(pairs));
  for (std::int64_t i = 0; i < pairs; ++i) {
    const double distance = std::pow(10.0, uniform(-3.0, 3.0, rng));
    const base::SinCos bearing = base::sin_cos(uniform(-pi, pi, rng));
    const Pose from{0.0, 0.0, uniform(-pi, pi, rng)};
    const Pose to{distance * bearing.cos, distance * bearing.sin, uniform(-pi, pi, rng)};
    const double length = reeds_shepp_length(from, to, 1.0);
    const LengthBounds bounds = length_bounds(from, to, 1.0);
    if (length < bounds.low || length > bounds.high) ++check.outside;
    gaps.push_back(bounds.high - bounds.low);
  }
  check.median_gap = percentile(gaps, 50.0);
  check.gap_95 = percentile(gaps, 95.0);
  return check;
}

}  // namespace vandplan::studies
