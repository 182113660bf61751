// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which other way is there from one place of a route to another? Shortening keeps to a way; a
// search over the whole task finds few of its kinds. One between two places of a good route is
// small.

#include <cstdint>
#include <memory>
#include <optional>

#include "planners/anytime/lattice.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/source.h"
#include "search/guide.h"
#include "search/route.h"
#include "vandplan/random.h"

namespace vandplan::anytime {

/// Replaces random stretches of a long route by what a lattice search finds between their ends.
/// What is found is shortened before it is offered, and is the route from then on.
class Detours final : public Source {
 public:
  Detours(const Task& task, const CostRule& rule, std::uint64_t seed);

  /// What it looks for ways off from now on. The route is longer than nothing.
  void set_route(const Route& route) override;

  /// Expands one pose, settles some cells of a grid, or shortens what was found; needs a route.
  /// True when a cheaper route was found: `route`.
  [[nodiscard]] bool step() override;

  [[nodiscard]] Route route() const override { return found_; }
  [[nodiscard]] std::int64_t solves() const override;
  [[nodiscard]] std::int64_t checks() const override;
  [[nodiscard]] std::size_t size() const override { return lattice_ ? lattice_->size() : 0; }

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
  Route base_;              // the route
  Route before_, after_;    // what stays of it
  Route old_;               // what is to be replaced
  bool backwards_ = false;  // the search begins at the end of the stretch
  Gears gears_;             // driven before and after it, in its direction
  std::optional<Connector> connector_;
  std::unique_ptr<Guide> guide_;
  bool guided_ = false;
  LatticeOptions options_;
  std::optional<Lattice> lattice_;
  std::int64_t left_ = 0;           // expansions of this search
  std::optional<Shortener> patch_;  // a way that was found
  int trials_ = 0;                  // to shorten it
  Route found_;
  std::int64_t solves_ = 0;  // of the searches before
  std::int64_t checks_ = 0;
};

}  // namespace vandplan::anytime
