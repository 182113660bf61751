// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which pairs of poses have the same length between them? (Guo 2020, Algorithm 5 and Fig. 6)

#include <array>
#include <cstdint>
#include <vector>

#include "studies/study_files.h"

namespace vandplan::studies {

struct SymmetryOptions {
  std::int64_t pairs = 100'000;  ///< random pairs whose folding is measured
  double reach = 30.0;           ///< of |x| and |y| [m]
  double turning_radius = 7.0;   ///< [m]
  std::uint64_t seed = 1;
};

/// A node seen from a sample that stands at the origin.
struct SeenPair {
  Pose node;
  double sample_heading = 0.0;  ///< [rad]
};

/// The pair of the same length whose node is in the first quadrant (Algorithm 5).
[[nodiscard]] SeenPair folded(const SeenPair& pair);

/// A pair with its node in each quadrant that folds into the same one.
struct SymmetryExample {
  std::array<SeenPair, 4> images;  ///< quadrants I to IV
  std::array<double, 4> lengths{};
};

struct SymmetryStudy {
  SymmetryOptions options;
  std::vector<SymmetryExample> examples;
  double worst_difference = 0.0;  ///< between the lengths of a pair and of its folded one [m]
};

[[nodiscard]] SymmetryStudy study_symmetry(const SymmetryOptions& options);

[[nodiscard]] StudyFiles files_of(const SymmetryStudy& study);

}  // namespace vandplan::studies
