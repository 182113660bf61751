// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What happens in a run of the anytime planner?
//
// The steps in brackets are those of docs/algorithms/anytime.md.

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "planners/anytime/portfolio.h"
#include "vandplan/outcome.h"
#include "vandplan/plan_options.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// Lets the workers of a portfolio work in rounds. A worker hears of the others between rounds
/// only, and what they bring is merged in a fixed order: the outcome does not depend on the number
/// of threads.
class Run {
 public:
  /// The budget has begun.
  Run(Portfolio portfolio, const search::Budget& budget, const BudgetOptions& options);

  /// One round. False if there is nothing left to do or the budget is spent.
  bool advance();
  /// Rounds do at most so many more iterations together, until this is called again.
  void pause_after(std::int64_t iterations) { pause_ = budget_.iterations() + iterations; }

  [[nodiscard]] std::int64_t iterations() const { return budget_.iterations(); }
  /// What is driven along the cheapest path so far, tidied; none while there is none.
  [[nodiscard]] std::optional<std::vector<Segment>> path();
  /// The answer, as if the run ended here.
  [[nodiscard]] PlannerAnswer answer();

 private:
  [[nodiscard]] std::int64_t left(std::int64_t wanted, std::int64_t promised) const;
  [[nodiscard]] Progress progress() const;
  [[nodiscard]] Told told(const Slot& slot, double enough_cost) const;
  [[nodiscard]] Best best() const;
  [[nodiscard]] double cost() const;
  [[nodiscard]] double cost_of_search() const;
  [[nodiscard]] Proven proven() const;
  [[nodiscard]] double enough() const;
  [[nodiscard]] bool is_optimal() const;
  [[nodiscard]] bool is_good_enough();
  [[nodiscard]] bool is_exhausted() const;

  void take(search::Route route);
  void round();
  void work_before(Slot& slot);
  void work_together();
  void work_after(Slot& slot, std::int64_t iterations);
  void merge(const Slot& slot, Found& found);
  void merge_relaxed(Found& found);
  void note(std::span<const CostSample> improvements);
  void note_cost();
  void make_drivable();

  Portfolio portfolio_;
  search::Budget budget_;
  std::uint64_t seed_;
  int threads_;
  bool has_time_limit_;
  std::int64_t pause_ = std::numeric_limits<std::int64_t>::max();  // iteration of the next pause
  std::optional<PlanStatus> end_;                                  // why the budget ended
  std::optional<search::Route> route_;                             // the cheapest
  std::optional<Drive> drive_;                                     // the cheapest
  std::vector<CostSample> trace_;
  std::int64_t rounds_ = 0, rounds_with_route_ = 0;
  std::int64_t proofs_of_round_ = 0;                             // steps of proving in this round
  int idle_rounds_ = 0;                                          // rounds in a row without any work
  double noted_cost_ = std::numeric_limits<double>::infinity();  // of the best route
  std::int64_t noted_at_ = 0;         // iteration at which that last fell a good deal
  double cost_before_strokes_ = 0.0;  // of the route that was made drivable last
  double cost_with_strokes_ = 0.0;    // of what was made of it
  std::vector<Segment> raw_;          // that `segments_` were made from
  std::vector<Segment> segments_;     // what is driven
};

}  // namespace vandplan::anytime
