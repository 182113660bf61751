// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much longer than the straight line is a path, and how far must a table reach?
// (Guo 2020, Algorithm 3 and Fig. 14)

#include <cstdint>
#include <vector>

#include "studies/study_files.h"

namespace vandplan::studies {

struct RangeOptions {
  std::int64_t pairs = 10'000;  ///< number of pairs that are drawn as dots
  double reach = 50.0;          ///< largest distance of a pair [m]
  double turning_radius = 7.0;  ///< turning radius of the vehicle [m]
  std::uint64_t seed = 1;
};

/// Lengths between two poses [m].
struct RangePair {
  double euclid, dubins, reeds_shepp;
};

/// Length of a path beyond the straight line [m].
struct Detour {
  double mean = 0.0;
  double largest = 0.0;
};

/// Pairs at one distance; bearings and headings are uniform.
struct RangeRing {
  double distance = 0.0;  ///< distance of the pairs [m]
  Detour dubins, reeds_shepp;
};

struct RangeStudy {
  RangeOptions options;
  std::vector<RangePair> pairs;  ///< pairs with distances uniform in [0, reach)
  std::vector<RangeRing> rings;  ///< 51 rings, with distances from 0 to `reach`
};

inline constexpr std::int64_t pairs_of_a_ring = 20'000;

[[nodiscard]] RangeStudy study_range(const RangeOptions& options);

[[nodiscard]] StudyFiles files_of(const RangeStudy& study);

}  // namespace vandplan::studies
