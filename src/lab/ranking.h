// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// In which order are the nodes of a tree tried as parents of a sample?

#include <optional>
#include <span>
#include <vector>

#include "lab/estimates.h"
#include "vandplan/nearest.h"
#include "vandplan/search.h"

namespace vandplan::search {

/// What nodes are ordered by: what ranks less is tried sooner.
enum class RankBy {
  length,     ///< estimated length from the node to the sample
  total_cost  ///< the same, and cost-to-come of the node
};

/// A node as a candidate for a parent.
struct Candidate {
  float rank;  ///< [m]
  NodeId id;
};

/// Orders the nodes of one tree for one sample after the other; ties go to the older node. The
/// nearest by exact Reeds-Shepp length are looked up (docs/algorithms/nearest.md); anything else
/// takes a rank for every node.
class Ranking {
 public:
  /// The tree has its root, and gets `capacity` nodes at most. Its edges are in the gear `only`; 0:
  /// in both gears.
  Ranking(const Tree& tree, double radius, std::size_t capacity, Estimate estimate, RankBy by,
          GearSign only = 0);

  /// Takes notice of the last node of the tree, which is new.
  void add_last();

  /// The first `count` nodes in order (all, if there are fewer); valid until the next call.
  const std::vector<Candidate>& first(std::size_t count, const Pose& sample);

  /// The same by lengths that the caller knows, one for every node [m].
  const std::vector<Candidate>& first(std::size_t count, std::span<const float> lengths);

  /// How many exact lengths were computed to find the nearest nodes.
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
  std::optional<NearestNodes> exact_;  // where it says what ranking would
  std::int64_t exact_solves_ = 0;
  std::vector<float> ranks_;
  std::vector<Candidate> best_;
};

}  // namespace vandplan::search
