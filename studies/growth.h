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
  /// Bound of |x| and |y| of samples [m].
  double reach = 200.0;
  double step = 5.0;            ///< length of the drive of one input [m]
  double turning_radius = 7.0;  ///< turning radius of the vehicle [m]
  std::uint64_t seed = 1;
};

/// Numbers of nodes at which the tree is shown; it is the same tree at different ages.
inline constexpr std::array<std::size_t, 6> growth_stages{200, 500, 1000, 5000, 10'000, 100'000};

/// Figures of the tree when it had `nodes` nodes.
struct GrowthStage {
  std::size_t nodes = 0;
  double explored = 0.0;  ///< share of the region's 10 m squares that contain a node
  int depth = 0;          ///< number of edges from the root to the deepest node
};

struct GrowthStudy {
  GrowthOptions options;
  TreeSnapshot tree;  ///< tree at its last stage; the root is (0, 0, 0)
  std::vector<GrowthStage> stages;
};

/// Grows a tree of `nodes` nodes, including the root.
[[nodiscard]] TreeSnapshot grow_tree(const GrowthOptions& options, std::size_t nodes);

[[nodiscard]] GrowthStudy study_growth(const GrowthOptions& options);

[[nodiscard]] StudyFiles files_of(const GrowthStudy& study);

}  // namespace vandplan::studies
