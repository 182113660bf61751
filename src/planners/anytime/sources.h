// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which searches does the anytime planner have for a first route?

#include <cstdint>
#include <memory>
#include <optional>

#include "planners/anytime/lattice.h"
#include "planners/anytime/rotation.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/source.h"
#include "planners/anytime/strung.h"
#include "planners/anytime/trees.h"
#include "search/guide.h"
#include "search/route.h"

namespace vandplan::anytime {

/// Which end a systematic search begins at.
enum class Root { start, goal };

/// Lattice searches from coarse to fine, all from the same root. When driving has prices they go by
/// length until a route is known; from then on searches of many kinds take turns, or the one goes
/// on by price that a tight slot needed.
class Ladder final : public Source {
 public:
  /// `Scope::windows`: over a whole site, of which only a strip is looked at.
  Ladder(const Task& task, const CostRule& rule, Root root, Scope scope);

  /// A few microseconds of work. True when a route was found: `route`.
  [[nodiscard]] bool step() override;

  void set_cutoff(double cost) override { cutoff_ = cost; }
  [[nodiscard]] Route route() const override;
  /// False once the finest search is done.
  [[nodiscard]] bool has_work() const override { return !finished_; }
  [[nodiscard]] std::int64_t solves() const override;
  [[nodiscard]] std::int64_t checks() const override;
  [[nodiscard]] std::size_t size() const override;

 private:
  [[nodiscard]] bool takes_turns() const;
  [[nodiscard]] bool is_known() const;
  bool step_rotation();
  bool step_strung();
  [[nodiscard]] Gears gears_from(const CostRule& rule) const;
  void next_search();
  void next_guide();
  [[nodiscard]] bool needs_next_guide() const;
  [[nodiscard]] bool goes_far() const;

  const Task& task_;
  Bounds scene_;
  LocalPose from_;
  LocalPose to_;
  Root root_;
  bool is_far_;                        // over a whole site
  CostRule rule_;                      // of the route
  Connector by_length_;                // of searches before a route is known
  Connector by_price_;                 // of searches from then on, in their direction
  std::optional<Connector> by_gears_;  // over a whole site, along a way
  std::unique_ptr<Guide> guide_;
  double guide_side_;    // of its cells [vehicle widths]
  bool guided_ = false;  // the guide is complete
  bool finished_ = false;
  std::size_t level_ = 0;
  std::size_t guide_level_ = 0;  // that the guide was made for
  bool is_done_ = false;         // the search has found what it can
  double cutoff_;
  std::optional<Strung> strung_;  // along the way of the guide; else, or if that fails:
  std::optional<Lattice> lattice_;
  bool minds_prices_ = false;  // the searches that are under way
  std::optional<Rotation> rotation_;
};

/// Pairs of trees, one attempt after the other.
class Attempts final : public Source {
 public:
  Attempts(const Task& task, const CostRule& rule, const Bounds& region, std::uint64_t seed);

  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override;
  [[nodiscard]] std::int64_t solves() const override { return forth_.solves() + back_.solves(); }
  [[nodiscard]] std::int64_t checks() const override { return forth_.checks() + back_.checks(); }
  [[nodiscard]] std::size_t size() const override { return trees_->size(); }

 private:
  void next_attempt();

  const Task& task_;
  Bounds region_;
  CostRule rule_;           // of the route
  Connector forth_, back_;  // of the trees: by length, from the start and from the goal
  std::uint64_t seed_;
  std::uint64_t attempt_ = 0;
  std::int64_t patience_;     // samples after which an attempt is given up
  std::int64_t samples_ = 0;  // of this attempt
  bool met_ = false;
  std::optional<TwoTrees> trees_;
};

}  // namespace vandplan::anytime
