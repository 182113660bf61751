// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which other kinds of way are there?
//
// With prices, ways of many kinds cost about as much as the best: around the other side, or with
// another number of strokes. One search finds one of them first.

#include <cstdint>
#include <memory>
#include <vector>

#include "planners/anytime/lattice.h"
#include "planners/anytime/worker.h"

namespace vandplan::anytime {

/// Lattice searches from one root, with different cells, greediness and prices, that take turns.
/// Each goes on where it was, and none blocks the others.
class Rotation {
 public:
  /// `rule`: prices in the direction of the search. The task and the guide outlive the rotation.
  Rotation(const Task& task, const CostRule& rule, const LocalPose& root, const LocalPose& target,
           const DrivenBeside& beside, const Guide& guide);

  /// Expands one pose. True when a route was found: `route`. Routes that cost much more than
  /// `cutoff`, the cost of the best route, are ignored.
  [[nodiscard]] bool step(double cutoff);

  /// The last route that was found, from the root to the target. Its cost is by the prices of its
  /// search.
  [[nodiscard]] const Route& route() const;
  /// Whether all searches have ended.
  [[nodiscard]] bool is_finished() const { return finished_; }
  [[nodiscard]] Counts counts() const;

 private:
  /// One of the searches.
  struct Search {
    Search(const Task& task, const CostRule& rule) : connector(task, rule) {}
    Connector connector;
    std::unique_ptr<Lattice> lattice;  // null before the first turn and after the end
    bool done = false;
  };

  bool begin_turn();

  LocalPose root_;
  LocalPose target_;
  DrivenBeside beside_;
  const Guide& guide_;
  std::vector<std::unique_ptr<Search>> searches_;
  std::size_t current_ = 0;  // index of the search whose turn it is
  std::size_t joined_;       // number of searches that take turns
  std::int64_t turn_;        // expansions of one turn
  std::int64_t left_ = 0;    // expansions left in this turn
  bool finished_ = false;
};

}  // namespace vandplan::anytime
