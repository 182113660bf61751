// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does a table hold what it should?

#include <cstdint>
#include <optional>

#include "vandplan/heuristic_table.h"

namespace vandplan::studies {

/// Which entries are recomputed.
struct EntryCheckOptions {
  std::optional<std::int64_t> sample;  ///< so many, drawn at random; none: every one
  std::uint64_t seed = 1;              ///< of the sample
};

/// Entries of a table against exact lengths.
struct EntryCheck {
  std::int64_t compared = 0;
  std::int64_t wrong = 0;             ///< further off than float rounds, or no number
  double worst_difference = 0.0;      ///< of entry and exact length [m]; NaN once an entry is none
  HeuristicTable::GridPoint worst{};  ///< where
};

[[nodiscard]] EntryCheck check_entries(const HeuristicTable& table,
                                       const EntryCheckOptions& options);

/// Exact lengths of random pairs of poses against the library's bounds. Every power of ten from a
/// thousandth of a turning radius to a thousand of them is as likely a distance as the next.
struct BoundCheck {
  std::int64_t pairs = 0;
  std::int64_t outside = 0;  ///< lengths that are not within their bounds
  double median_gap = 0.0;   ///< of high - low [turning radii]
  double gap_95 = 0.0;       ///< its 95th percentile
};

[[nodiscard]] BoundCheck check_bounds(std::int64_t pairs, std::uint64_t seed);

}  // namespace vandplan::studies
