// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much longer than the straight line is a path, and how far out must a table reach?
// (Guo 2020, Algorithm 3 and Fig. 14)

#include <cstdint>
#include <vector>

#include "studies/study_files.h"

namespace vandplan::studies {

struct RangeOptions {
  std::int64_t pairs = 10'000;  ///< drawn as dots
  double reach = 50.0;          ///< largest distance of a pair [m]
  double turning_radius = 7.0;  ///< [m]
  std::uint64_t seed = 1;
};

/// Lengths between two poses [m].
struct RangePair {
  double euclid, dubins, reeds_shepp;
};

/// What is driven beyond the straight line [m].
struct Detour {
  double mean = 0.0;
  double largest = 0.0;
};

/// Pairs at one distance, bearing and headings uniform.
struct RangeRing {
  double distance = 0.0;  ///< [m]
  Detour dubins, reeds_shepp;
};

struct RangeStudy {
  RangeOptions options;
  std::vector<RangePair> pairs;  ///< distance uniform in [0, reach)
  std::vector<RangeRing> rings;  ///< 51 of them from 0 to reach
};

inline constexpr std::int64_t pairs_of_a_ring = 20'000;

[[nodiscard]] RangeStudy study_range(const RangeOptions& options);

[[nodiscard]] StudyFiles files_of(const RangeStudy& study);

}  // namespace vandplan::studies
