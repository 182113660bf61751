// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which other kinds of way are there?
//
// With prices, ways of many kinds cost about as much as the best: around the other side, or with
// another number of strokes. One search finds one of them first.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "planners/anytime/lattice.h"

namespace vandplan::anytime {

/// Lattice searches from one root, with different cells and greediness, that take turns. Each goes
/// on where it was, and none blocks the others.
class Rotation {
 public:
  /// A turn has `turn` expansions. The guide and the connector, which has the prices in the
  /// direction of the search, outlive the rotation.
  Rotation(const LocalPose& root, const LocalPose& target, const DrivenBeside& beside,
           std::span<const LatticeOptions> searches, std::int64_t turn, const Guide& guide,
           Connector& connector);

  /// Expands one pose. True when a route was found: `route`. Routes that do not cost less than
  /// `cutoff` are ignored [m].
  [[nodiscard]] bool step(double cutoff);

  /// The last route that was found, from the root to the target.
  [[nodiscard]] const Route& route() const { return lattices_[current_]->route(); }
  /// Whether all searches have ended.
  [[nodiscard]] bool is_finished() const { return finished_; }
  /// Nodes of all searches.
  [[nodiscard]] std::int64_t size() const;

 private:
  bool begin_turn();

  std::vector<std::optional<Lattice>> lattices_;  // from coarse to fine; none: the search has ended
  std::size_t current_ = 0;                       // index of the search whose turn it is
  std::int64_t turn_;                             // expansions of a turn
  std::int64_t left_;                             // expansions left in this turn
  bool finished_ = false;
};

}  // namespace vandplan::anytime
