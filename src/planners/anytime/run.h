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
#include "planners/path_search.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// Lets the workers of a portfolio work in rounds. Workers hear of each other only between rounds,
/// and results are merged in a fixed order. So the outcome does not depend on the number of
/// threads.
class Run final : public planning::PathSearch {
 public:
  /// `budget` has begun; it was made from `options`.
  Run(Portfolio portfolio, const search::Budget& budget, const BudgetOptions& options);

  bool advance(std::int64_t most) override;
  /// Does one round, which only the budget limits. False as above.
  bool advance() { return advance(std::numeric_limits<std::int64_t>::max()); }

  [[nodiscard]] std::int64_t iterations() const override { return budget_.iterations(); }
  [[nodiscard]] std::optional<std::vector<Segment>> path() override;
  [[nodiscard]] PlannerAnswer answer() override;
  [[nodiscard]] Proven proven() const override;

 private:
  [[nodiscard]] std::int64_t left(std::int64_t wanted, std::int64_t promised) const;
  [[nodiscard]] Progress progress() const;
  [[nodiscard]] Told told(const Slot& slot, double enough_cost) const;
  [[nodiscard]] Drive best() const;
  [[nodiscard]] bool has_path() const { return route_ || drive_; }
  [[nodiscard]] double cost() const;
  [[nodiscard]] double cost_of_search() const;
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
  std::int64_t last_ = 0;               // iteration at which the round ends
  std::optional<PlanStatus> end_;       // why the run ended, if the budget was spent
  std::optional<search::Route> route_;  // cheapest route
  std::optional<Drive> drive_;          // cheapest drive
  std::vector<CostSample> trace_;       // costs of each improvement
  std::int64_t rounds_ = 0, rounds_with_path_ = 0;
  std::int64_t proofs_of_round_ = 0;  // steps of proving in this round
  int idle_rounds_ = 0;               // rounds in a row without any work
  /// Cost of the best path when it last fell clearly.
  double noted_cost_ = std::numeric_limits<double>::infinity();
  /// Iteration at which the best cost last fell clearly.
  std::int64_t noted_at_ = 0;
  /// Cost of the path whose strokes were lengthened last to test the gap, before and after that.
  double cost_before_strokes_ = 0.0;
  double cost_with_strokes_ = 0.0;
  std::vector<Segment> raw_;       // segments that `segments_` were made of
  std::vector<Segment> segments_;  // segments of the answer, tidied
};

}  // namespace vandplan::anytime
