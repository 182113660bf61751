// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a random tree spread over open ground? (Guo 2020, Algorithm 1 and Fig. 5)

#include <array>
#include <cstdint>
#include <vector>

#include "studies/study_files.h"
#include "vandplan/planner.h"

namespace vandplan::studies {

struct GrowthOptions {
  double reach = 200.0;         ///< samples have |x| and |y| below it [m]
  double step = 5.0;            ///< how far one input drives [m]
  double turning_radius = 7.0;  ///< [m]
  std::uint64_t seed = 1;
};

/// Sizes of the trees that are looked at; each is the next one at a younger age.
inline constexpr std::array<std::size_t, 6> growth_stages{200, 500, 1000, 5000, 10'000, 100'000};

/// The tree when it had so many nodes.
struct GrowthStage {
  std::size_t nodes = 0;
  double explored = 0.0;  ///< share of the squares of 10 m in the region that hold a node
  int depth = 0;          ///< edges from the root to the furthest node
};

struct GrowthStudy {
  GrowthOptions options;
  TreeSnapshot tree;  ///< the largest one; rooted at (0, 0, 0)
  std::vector<GrowthStage> stages;
};

/// A tree of `nodes` nodes, the root included.
[[nodiscard]] TreeSnapshot grow_tree(const GrowthOptions& options, std::size_t nodes);

[[nodiscard]] GrowthStudy study_growth(const GrowthOptions& options);

[[nodiscard]] StudyFiles files_of(const GrowthStudy& study);

}  // namespace vandplan::studies
