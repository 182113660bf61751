// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which other way leads from one place of a route to another?
//
// Shortening never leaves its way, and a search over the whole task finds few kinds of way. A
// search between two places of a good route is small.

#include <cstdint>
#include <memory>
#include <optional>

#include "planners/anytime/lattice.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/source.h"
#include "search/grid_distance.h"
#include "search/route.h"
#include "vandplan/random.h"

namespace vandplan::anytime {

/// Replaces random stretches of a long route by results of a lattice search between their ends. A
/// result is shortened first. If it is cheaper than the stretch, it becomes a part of the route.
class Detours final : public Source {
 public:
  Detours(const Task& task, const CostRule& rule, std::uint64_t seed);

  /// Sets the route whose stretches are replaced. Its length is above 0.
  void set_route(const Route& route) override;

  /// Expands one pose, settles some cells of a grid, or shortens a result; needs a route. True when
  /// a cheaper route was found: `route`.
  [[nodiscard]] bool step() override;

  [[nodiscard]] Route route() const override { return found_; }
  [[nodiscard]] Counts counts() const override;

 private:
  void choose();
  void begin();
  void end();
  void make_guide(const LocalPose& root, const LocalPose& target);
  [[nodiscard]] bool is_hopeless() const;
  bool search();
  void put_in_place(const Route& way);
  bool patch();

  const Task& task_;
  CostRule rule_;
  Bounds scene_;
  Rng rng_;
  Route base_;              // best route
  Route before_, after_;    // parts of the route that stay
  Route old_;               // stretch that is to be replaced
  bool backwards_ = false;  // whether the search begins at the end of the stretch
  DrivenBeside beside_;     // gears beside the stretch, in the direction of the search
  std::optional<Connector> connector_;
  std::optional<GridDistance> guide_;
  bool guided_ = false;  // whether the guide is complete
  LatticeOptions options_;
  std::optional<Lattice> lattice_;
  std::int64_t left_ = 0;           // expansions left for this search
  std::optional<Shortener> patch_;  // shortens a result of the search
  int trials_ = 0;                  // trials of shortening it
  Route found_;
  Counts former_;  // counts of earlier searches
};

}  // namespace vandplan::anytime
