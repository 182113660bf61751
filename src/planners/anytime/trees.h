// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a first path found?
//
// Two trees, one from the start and one from the goal, grow until they meet (RRT-Connect, Kuffner
// and LaValle 2000).

#include <array>
#include <optional>
#include <vector>

#include "search/route.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

using namespace search;

/// The trees of one attempt.
class TwoTrees {
 public:
  /// `forth` steers from the start, `back` from the goal by the reversed rule. Far samples are
  /// drawn in `region` or around the middle of both ends and find ways around obstacles. Near
  /// samples find the way out of a slot. `far_share`: share of far samples, 0 to 1.
  TwoTrees(const Task& task, const Bounds& region, Connector& forth, Connector& back,
           double far_share, std::uint64_t seed);

  /// Adds one sample. True when the trees have met: `route`.
  [[nodiscard]] bool step();

  [[nodiscard]] Route route() const { return route_; }
  [[nodiscard]] std::size_t size() const { return sides_[0].tree.size() + sides_[1].tree.size(); }
  [[nodiscard]] const Tree& tree(int side) const {
    return sides_[static_cast<std::size_t>(side)].tree;
  }

 private:
  /// One of the two trees.
  struct Side {
    Tree tree;
    /// Piece from each node's parent, driven in the direction of this side.
    std::vector<Piece> pieces;
    Connector& connector;  // steers in the direction of this side
  };
  /// Piece from a node of a tree.
  struct Edge {
    NodeId from;
    Piece piece;
  };

  [[nodiscard]] LocalPose sample_far();
  [[nodiscard]] LocalPose sample_near();
  [[nodiscard]] bool step_far();
  [[nodiscard]] bool step_near();
  [[nodiscard]] std::optional<Edge> reach(Side& side, const LocalPose& target);
  void rank(Side& side, const LocalPose& target);
  NodeId extend(Side& side, const LocalPose& target);
  [[nodiscard]] bool connect(std::size_t from_side, NodeId node);
  NodeId add(Side& side, NodeId parent, const Piece& piece, const LocalPose& end);
  void join(NodeId from_start, NodeId from_goal, const Piece& bridge);

  double radius_;
  CostRule rule_;
  Local<Bounds> region_;
  double far_share_;
  Rng rng_;
  std::array<Side, 2> sides_;
  std::size_t turn_ = 0;       // index of the side that drives towards the next near sample
  std::vector<Edge> nearest_;  // buffer of `rank`: edges to the nearest nodes, the shortest first
  Route route_;
};

}  // namespace vandplan::anytime
