// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which sources of routes does the anytime planner have?
//
// Tasks and rules outlive the sources.

#include <cstdint>
#include <memory>
#include <optional>

#include "planners/anytime/lattice.h"
#include "planners/anytime/rotation.h"
#include "planners/anytime/source.h"
#include "planners/anytime/strung.h"
#include "search/grid_distance.h"
#include "search/route.h"
#include "vandplan/planner.h"

namespace vandplan::anytime {

/// End of the task at which a lattice search begins.
enum class Root { start, goal };

/// Lattice searches from coarse to fine, all from the same root. With prices they go by length
/// until a route is known. Afterwards different searches take turns (`Rotation`); if only a fine
/// one found a route, because a slot is tight, it is repeated by price instead, and finer ones
/// follow. Over a whole site there is one search, in a strip, and others only if that finds no
/// route.
class Ladder final : public Source {
 public:
  /// Task and rule outlive the object.
  Ladder(const Task& task, const CostRule& rule, Root root);

  /// Works for a few microseconds. True when a route was found: `route`.
  [[nodiscard]] bool step() override;

  void set_cutoff(double cost) override { cutoff_ = cost; }
  [[nodiscard]] Route route() const override;
  /// False once the finest search is done.
  [[nodiscard]] bool has_work() const override { return !finished_; }
  [[nodiscard]] Counts counts() const override;
  /// Number of searches begun before there is a route, from coarse to fine.
  [[nodiscard]] std::int64_t stage() const override { return static_cast<std::int64_t>(level_); }

 private:
  [[nodiscard]] bool takes_turns() const;
  [[nodiscard]] bool is_known() const;
  bool step_rotation();
  bool step_strung();
  [[nodiscard]] DrivenBeside driven_beside_route(const CostRule& rule) const;
  void next_search();
  void next_guide();
  [[nodiscard]] bool needs_next_guide() const;
  [[nodiscard]] bool goes_far() const;

  const Task& task_;
  Bounds scene_;
  LocalPose from_;
  LocalPose to_;
  Root root_;
  bool is_far_;    // whether the task goes over a whole site
  CostRule rule_;  // prices of the route
  /// Steers searches before a route is known.
  Connector by_length_;
  /// Steers searches once a route is known, in their direction.
  Connector by_price_;
  /// Steers along a way over a whole site.
  std::optional<Connector> by_gears_;
  std::optional<GridDistance> guide_;
  double guide_side_ = 1.0;  // side of the next guide's cells [vehicle widths]
  bool guided_ = false;      // whether the guide is complete
  bool finished_ = false;
  std::size_t level_ = 0;  // index of the next search
  bool is_done_ = false;   // whether the current search has found what it can
  double cutoff_;
  /// Drives along the way of the guide over a whole site; none if that failed.
  std::optional<Strung> strung_;
  std::optional<Lattice> lattice_;  // current search, where `strung_` is none
  std::optional<Rotation> rotation_;
};

/// Replaces random stretches of a long route by results of a lattice search between their ends. A
/// result is shortened first. If it is cheaper than the stretch, it becomes a part of the route.
/// `set_route`, with a length above 0, comes before the first step.
[[nodiscard]] std::unique_ptr<Source> detours(const Task& task, const CostRule& rule,
                                              std::uint64_t seed);

/// Searches everywhere for routes of other kinds. Two fields hold the cost of driving from each
/// pose to the goal, and from the start to each pose. Where both add up to little more than the
/// least cost, a way leads through. Ways of different kinds become routes of arcs and lines. A
/// cutoff comes before the first step. The first pass has the coarsest cells.
/// Method: docs/algorithms/anytime.md, "Survey".
[[nodiscard]] std::unique_ptr<Source> survey(const Task& task, const CostRule& rule);

/// Makes a free route of each path that a source of the caller proposes, if it finds one. `paths`
/// must not be null.
[[nodiscard]] std::unique_ptr<Source> proposals(const Task& task, const CostRule& rule,
                                                std::unique_ptr<PathSource> paths,
                                                std::uint64_t seed);

}  // namespace vandplan::anytime
