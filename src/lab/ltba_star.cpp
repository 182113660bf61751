// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/ltba_star.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lab/committed_drive.h"
#include "lab/lattice_search.h"

namespace vandplan::lattice {
namespace {

/// Tells when a cycle ends: after some iterations if these are limited, otherwise after a time.
class Clock {
 public:
  explicit Clock(const PlanOptions& options)
      : looks_(options.planner.integer("cycle_expansions")),
        time_(options.planner.number("cycle_time")),
        is_by_time_(!options.budget.max_iterations) {}

  [[nodiscard]] bool is_over(const Budget& budget) const {
    if (is_by_time_) return budget.elapsed() >= static_cast<double>(cycles_ + 1) * time_;
    return budget.iterations() >= (cycles_ + 1) * looks_;
  }
  void begin_next() { ++cycles_; }
  [[nodiscard]] std::int64_t cycles() const { return cycles_; }
  /// Duration of a cycle [s].
  [[nodiscard]] double time() const { return time_; }

 private:
  std::int64_t looks_;  // iterations of a cycle
  double time_;         // duration of a cycle [s]
  bool is_by_time_;
  std::int64_t cycles_ = 0;
};

/// A run: one search, one vehicle that drives meanwhile, and the whole way once it is found.
class LtbaStarRun {
 public:
  LtbaStarRun(const Task& task, const PlanOptions& options, const Ground& ground)
      : connector_(task),
        search_(task, ground, connector_,
                {.weight = options.planner.number("weight"),
                 .shots = options.planner.flag("shots"),
                 .max_nodes = static_cast<std::size_t>(options.planner.integer("max_nodes")),
                 .keep_tree = options.planner.flag("keep_tree")}),
        drive_(task),
        clock_(options) {
    if (std::isfinite(search_.best())) (void)take_best();
  }

  [[nodiscard]] bool has_next() { return !search_.is_full() && search_.has_next(); }
  /// Step [2]: goes on with the search. True when the whole way became cheaper.
  bool look() { return search_.step() && take_best(); }

  /// Steps [4] to [6] for each cycle that is over.
  void end_cycles(const Budget& budget) {
    while (clock_.is_over(budget)) {
      clock_.begin_next();
      if (whole_.empty()) {
        const std::optional<LatticeSearch::Id> front =
            search_.has_next() ? search_.front() : std::nullopt;
        std::vector<Leg> way = front ? search_.way_to(*front) : std::vector<Leg>();
        if (!way.empty() && drive_.agrees(way)) drive_.follow(std::move(way));
      }
      drive_.commit(clock_.time());
      drive_.drive(clock_.time());
      if (!drive_.can_stop()) ++without_plan_;
    }
  }

  [[nodiscard]] double cost() const { return length_of(whole_); }

  void report(PlannerAnswer& answer) const {
    search_.report(answer);
    answer.counters.push_back({"cycles", clock_.cycles()});
    answer.counters.push_back({"cycles_without_plan", without_plan_});
    answer.counters.push_back({"braking_events", drive_.forced_stops()});
    answer.counters.push_back(
        {"committed_mm", static_cast<std::int64_t>(1000 * drive_.committed())});
    if (whole_.empty()) return;
    answer.status = PlanStatus::solved;
    answer.segments = segments_of(whole_);
    answer.reason.clear();
  }

 private:
  // Step [3]: joins the search's best way to the committed part. True when the whole way became
  // cheaper.
  bool take_best() {
    const double cutoff = whole_.empty() ? std::numeric_limits<double>::infinity() : cost();
    std::optional<std::vector<Leg>> way = drive_.joined(search_.best_way(), cutoff, connector_);
    if (!way) return false;
    whole_ = *std::move(way);
    drive_.follow(whole_);
    return true;
  }

  Connector connector_;
  LatticeSearch search_;
  CommittedDrive drive_;
  Clock clock_;
  std::vector<Leg> whole_;         // way from start to goal; empty until it is found
  std::int64_t without_plan_ = 0;  // cycles after which the vehicle could not stop in time
};

}  // namespace

std::vector<OptionInfo> ltba_star_options() {
  std::vector<OptionInfo> all = {{.name = "cycle_expansions",
                                  .summary = "edges per cycle under an iteration limit",
                                  .default_value = std::int64_t{500},
                                  .least = 1,
                                  .most = 1'000'000'000},
                                 {.name = "cycle_time",
                                  .summary = "duration of a cycle [s]",
                                  .default_value = 0.01,
                                  .least = 0.001,
                                  .most = 10},
                                 {.name = "weight",
                                  .summary = "weight of the estimate, 1: shortest path",
                                  .default_value = 1.0,
                                  .least = 1,
                                  .most = 100}};
  for (OptionInfo& option : shared_options()) all.push_back(std::move(option));
  return all;
}

// LTBA* of Cirillo (2017), after TBA* of Bjornsson, Bulitko and Sturtevant (2009).
//
//   [1] lay the lattice through the goal, join the start to the vertices around it
//   in cycles, until the search has nothing left that is cheaper than the best way:
//   [2]   go on with the one A*
//   [3]   where it reaches the goal: the whole way is what is committed, and the rest of that way,
//         joined by an exact piece or driven back to; it is changed for a cheaper one only
//   at the end of each cycle:
//   [4]   the way is the whole one, or else the one back from the front of the search to the start,
//         if that begins with what is committed
//   [5]   commit what the vehicle needs to go on in the next cycle and still come to a standstill
//   [6]   the vehicle drives for a cycle along what is committed
PlannerAnswer plan_ltba_star(const Task& task, const PlanOptions& options) {
  PlannerAnswer answer;
  Budget budget(options.budget);
  const Ground ground = ground_of(task, options, budget);  // [1]
  if (ground.graph == nullptr) {
    answer.status = budget.exhausted().value_or(PlanStatus::stopped);
    return answer;
  }
  LtbaStarRun run(task, options, ground);
  const auto improved = [&] {
    answer.anytime.push_back({budget.elapsed(), budget.iterations(), run.cost()});
  };
  if (run.cost() > 0.0) improved();
  answer.status = PlanStatus::node_limit;
  answer.reason = "no way over the lattice is free, or it has too many vertices";
  while (run.has_next()) {
    if (!budget.next()) {
      answer.status = budget.reason();
      answer.reason.clear();
      break;
    }
    if (run.look()) improved();  // [2] [3]
    run.end_cycles(budget);      // [4] [5] [6]
  }
  answer.iterations = budget.iterations();
  run.report(answer);
  if (answer.segments) answer.lower_bound = length_on_open_ground(task);
  return answer;
}

}  // namespace vandplan::lattice
