// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which other kinds of way are there? When driving has prices, ways of many kinds come near to the
// best: around the other side, with another number of strokes. One search finds one of them first.

#include <cstdint>
#include <memory>
#include <vector>

#include "planners/anytime/lattice.h"

namespace vandplan::anytime {

/// Lattice searches from one root, of different cells, greediness and prices, that take turns. No
/// search holds the others up, and each goes on where it was.
class Rotation {
 public:
  /// `rule` is that of the direction of the search. All arguments but the poses and the rule
  /// outlive the rotation.
  Rotation(const Task& task, const CostRule& rule, const LocalPose& root, const LocalPose& target,
           const Gears& gears, const Guide& guide);

  /// Expands one pose. True when a route was found: `route`. Only routes that cost less than
  /// `cutoff` by now, or a little more, are of interest.
  [[nodiscard]] bool step(double cutoff);

  /// From the root to the target; its cost is that under the prices of its search.
  [[nodiscard]] const Route& route() const;
  /// No search has anything left.
  [[nodiscard]] bool is_finished() const { return finished_; }
  [[nodiscard]] std::int64_t solves() const;
  [[nodiscard]] std::int64_t checks() const;
  [[nodiscard]] std::size_t size() const;

 private:
  struct Search {
    Search(const Task& task, const CostRule& rule) : connector(task, rule) {}
    Connector connector;
    std::unique_ptr<Lattice> lattice;  // null before its first turn and when it is done
    bool done = false;
  };

  bool begin_turn();

  LocalPose root_;
  LocalPose target_;
  Gears gears_;
  const Guide& guide_;
  std::vector<std::unique_ptr<Search>> searches_;
  std::size_t current_ = 0;
  std::size_t joined_;  // how many take turns
  std::int64_t turn_;   // expansions of one turn
  std::int64_t left_ = 0;
  bool finished_ = false;
};

}  // namespace vandplan::anytime
