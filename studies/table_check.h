// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are the entries of a table and the bounds of lengths correct?

#include <cstdint>
#include <optional>

#include "vandplan/tables.h"

namespace vandplan::studies {

/// Which entries are recomputed.
struct EntryCheckOptions {
  std::optional<std::int64_t> sample;  ///< number of entries, drawn at random; none: all entries
  std::uint64_t seed = 1;              ///< seed of the sample
};

/// Result of comparing entries of a table with exact lengths.
struct EntryCheck {
  std::int64_t compared = 0;
  /// Number of entries that are NaN or have a larger error than rounding to float.
  std::int64_t wrong = 0;
  /// Largest difference of entry and exact length [m]; NaN if an entry is NaN.
  double worst_difference = 0.0;
  HeuristicTable::GridPoint worst{};  ///< place of the largest difference
};

[[nodiscard]] EntryCheck check_entries(const HeuristicTable& table,
                                       const EntryCheckOptions& options);

/// Result of comparing exact lengths of random pairs of poses with the library's bounds. Distances
/// are log-uniform from a thousandth of a turning radius to a thousand.
struct BoundCheck {
  std::int64_t pairs = 0;
  std::int64_t outside = 0;  ///< number of lengths outside their bounds
  double median_gap = 0.0;   ///< median of high - low [turning radii]
  double gap_95 = 0.0;       ///< 95th percentile of high - low [turning radii]
};

[[nodiscard]] BoundCheck check_bounds(std::int64_t pairs, std::uint64_t seed);

}  // namespace vandplan::studies
