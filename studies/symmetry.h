// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which pairs of poses have shortest paths of equal length? (Guo 2020, Algorithm 5 and Fig. 6)

#include <array>
#include <cstdint>
#include <vector>

#include "studies/study_files.h"

namespace vandplan::studies {

struct SymmetryOptions {
  std::int64_t pairs = 100'000;  ///< number of random pairs for which folding is tested
  /// Largest |x| and |y| of a node [m].
  double reach = 30.0;
  double turning_radius = 7.0;  ///< turning radius of the vehicle [m]
  std::uint64_t seed = 1;
};

/// A node and a sample; the sample is at the origin.
struct SeenPair {
  Pose node;
  double sample_heading = 0.0;  ///< heading of the sample [rad]
};

/// Pair of equal length whose node is in the first quadrant (Algorithm 5).
[[nodiscard]] SeenPair folded(const SeenPair& pair);

/// Four pairs with nodes in all quadrants that fold into the same pair.
struct SymmetryExample {
  std::array<SeenPair, 4> images;  ///< pairs with nodes in quadrants I to IV
  std::array<double, 4> lengths{};
};

struct SymmetryStudy {
  SymmetryOptions options;
  std::vector<SymmetryExample> examples;
  /// Largest difference of length between a pair and its folded pair [m].
  double worst_difference = 0.0;
};

[[nodiscard]] SymmetryStudy study_symmetry(const SymmetryOptions& options);

[[nodiscard]] StudyFiles files_of(const SymmetryStudy& study);

}  // namespace vandplan::studies
