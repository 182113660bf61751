// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a first path found? Two trees, one from the start and one from the goal, grow until they
// meet (RRT-Connect, Kuffner and LaValle 2000).

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
  /// `forth` steers from the start, `back` from the goal, by the reversed rule. `region` is where
  /// far samples are drawn, `far_share` how many there are, 0 to 1: they find the way around
  /// obstacles, the others the way out of a slot.
  TwoTrees(const Task& task, const Bounds& region, Connector& forth, Connector& back,
           double far_share, std::uint64_t seed);

  /// One sample. True when the trees have met: `route` is then the path.
  [[nodiscard]] bool step();

  [[nodiscard]] Route route() const { return route_; }
  [[nodiscard]] std::size_t size() const { return sides_[0].tree.size() + sides_[1].tree.size(); }
  [[nodiscard]] const Tree& tree(int side) const {
    return sides_[static_cast<std::size_t>(side)].tree;
  }

 private:
  struct Side {
    Tree tree;
    std::vector<Piece> pieces;  // from the parent, driven in the side's own direction
    Connector& connector;       // of that direction
  };
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
  std::size_t turn_ = 0;
  std::vector<Edge> nearest_;  // buffer of `rank`, nearest first
  Route route_;
};

}  // namespace vandplan::anytime
