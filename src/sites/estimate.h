// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the table of a site tell a search of the way from one pose to another?
//
// What it can mean, and what not: docs/algorithms/site_tables.md.

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "vandplan/problem.h"
#include "vandplan/site_table.h"

namespace vandplan::sites {

/// Costs from poses to the goal of one task.
class CostsToGoal {
 public:
  /// The table serves the task (`expect_serves`).
  CostsToGoal(const SiteTable& table, const Task& task);

  /// Cost from a pose to the goal [m], as `SiteTable::cost`. Where the table knows no way, it is
  /// that of the farthest state: such poses come last, but a search does not drop them.
  [[nodiscard]] double from(const LocalPose& pose) const;

 private:
  SiteTable table_;
  std::shared_ptr<const World> world_;
  std::size_t goal_;
  double farthest_;  // largest cost of the goal's states [m]
};

/// Lengths between poses, estimated by their costs to the goals of a table. A way from one pose to
/// another saves at most its own length on the way to any goal. So the difference of their costs is
/// too long for a length only by the errors of the table.
class CostDifferences {
 public:
  /// The table serves the task. `is_one_way`: edges are driven in one gear; otherwise a way may be
  /// driven back. There are at most `capacity` nodes.
  CostDifferences(const SiteTable& table, const Task& task, bool is_one_way, std::size_t capacity);

  /// Adds a node.
  void add(const LocalPose& node);

  /// Raises estimated lengths from each node to a sample [m] to the largest difference.
  void raise(const LocalPose& sample, std::span<float> lengths) const;

 private:
  [[nodiscard]] float cost(const LocalPose& pose, std::size_t goal) const;

  SiteTable table_;
  std::shared_ptr<const World> world_;
  bool is_one_way_;
  std::vector<std::vector<float>> costs_;  // of each goal: cost of each node, NaN where unknown [m]
};

/// The table with costs that a function gives in place of those of its cells [m]. Its ways stay.
/// For studies of other estimates; the result is not written to a file.
[[nodiscard]] SiteTable with_costs(const SiteTable& table,
                                   std::function<double(const Pose&, std::size_t goal)> costs);

}  // namespace vandplan::sites
