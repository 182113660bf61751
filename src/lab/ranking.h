// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// In which order are the nodes of a tree tried as parents of a sample?

#include <optional>
#include <span>
#include <vector>

#include "lab/estimates.h"
#include "vandplan/search.h"
#include "vandplan/tables.h"

namespace vandplan::search {

/// Quantity by which nodes are ranked; smaller ranks are tried first.
enum class RankBy {
  length,     ///< estimated length from the node to the sample
  total_cost  ///< cost-to-come of the node plus estimated length to the sample
};

/// A node as a candidate for a parent.
struct Candidate {
  float rank;  ///< rank by `RankBy` [m]
  NodeId id;
};

/// Ranks the nodes of one tree for one sample after the other; ties go to the older node. Nodes
/// that are nearest by exact Reeds-Shepp length are looked up (docs/algorithms/nearest.md).
/// Otherwise every node gets a rank.
class Ranking {
 public:
  /// The tree has its root, and gets `capacity` nodes at most. `only`: the gear of all edges, 1 or
  /// -1; 0: edges are in both gears.
  Ranking(const Tree& tree, double radius, std::size_t capacity, Estimate estimate, RankBy by,
          GearSign only = 0);

  /// Registers the last node of the tree. Call it after each new node.
  void add_last();

  /// The first `count` nodes for a sample, in order (all, if there are fewer); valid until the next
  /// call.
  const std::vector<Candidate>& first(std::size_t count, const Pose& sample);

  /// The first `count` nodes by given lengths to a sample, one for every node [m]; valid until the
  /// next call.
  const std::vector<Candidate>& first(std::size_t count, std::span<const float> lengths);

  /// Number of exact lengths that were computed to find nearest nodes.
  [[nodiscard]] std::int64_t exact_solves() const { return exact_solves_; }

 private:
  void rank_all(std::size_t count, const Pose& sample);
  void choose(std::size_t count);
  void look_up(std::size_t count, const Pose& sample);

  const Tree& tree_;
  double radius_;
  Estimate estimate_;
  RankBy by_;
  GearSign only_;
  std::optional<NearestNodes> exact_;  // look-up of nearest nodes; none: all nodes are ranked
  std::int64_t exact_solves_ = 0;
  std::vector<float> ranks_;
  std::vector<Candidate> best_;
};

}  // namespace vandplan::search
