// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/rig_planner.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "planners/rig/rig_search.h"
#include "planners/rig/rig_shorten.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan::rig {
namespace {

using namespace search;

constexpr double rounding = 1e-9;  // of the bound, relative

/// What came of a run so far.
class Run {
 public:
  Run(const Task& task, const PlanOptions& options)
      : task_(task),
        options_(options),
        budget_(options.budget),
        rule_(cost_rule(options.cost)),
        unit_(0.3 * std::sqrt(task.vehicle.min_turning_radius * task.vehicle.trailer->wheelbase)),
        bound_(Connector(task, rule_).least_cost(task.start, task.goal, {rule_.initial_gear, {}})) {
  }

  /// Searches for a drive, coarsely at first. False when the budget is spent.
  bool search(int round);
  /// Makes a drive cheaper until that brings next to nothing. False when the budget is spent.
  bool shorten();
  [[nodiscard]] PlannerAnswer answer();

 private:
  void keep(const std::vector<Segment>& segments, double cost);
  [[nodiscard]] bool is_good_enough() const {
    const auto& gap = options_.budget.target_gap;
    return best_ &&
           (best_cost_ <= bound_ * (1 + rounding) || (gap && best_cost_ <= bound_ * (1 + *gap)));
  }

  const Task& task_;
  const PlanOptions& options_;
  Budget budget_;
  CostRule rule_;
  double unit_;   // of the steps of a search [m]
  double bound_;  // no drive costs less [m]
  std::optional<std::vector<Segment>> found_;
  std::optional<std::vector<Segment>> best_;
  double best_cost_ = 0.0;
  std::vector<CostSample> trace_;
  std::int64_t nodes_ = 0, checks_ = 0, closings_ = 0, trials_ = 0;
  std::uint64_t shortened_ = 0;
};

bool Run::search(int round) {
  // Each round looks more finely, then coarsely again with another weight.
  constexpr double steps[] = {1.0, 0.6, 0.35, 0.2};
  constexpr double weights[] = {2.5, 1.6, 4.0, 1.2};
  const Fineness fineness{
      .step = unit_ * steps[round % 4],
      .weight = weights[(round / 4) % 4],
      .most_nodes = static_cast<std::size_t>(40000 * std::exp2(0.5 * std::min(round, 16)))};
  RigSearch search(task_, rule_, fineness);
  bool goes_on = true;
  while (!found_ && goes_on && budget_.next()) {
    goes_on = search.step();
    found_ = search.take_found();
  }
  nodes_ += search.nodes();
  checks_ += search.checks();
  closings_ += search.closings();
  return !budget_.exhausted();
}

void Run::keep(const std::vector<Segment>& segments, double cost) {
  if (best_ && cost >= best_cost_) return;
  best_ = segments;
  best_cost_ = cost;
  trace_.push_back({budget_.elapsed(), budget_.iterations(), cost});
}

bool Run::shorten() {
  if (!found_) return !budget_.exhausted();
  RigShortener shortener(task_, rule_, *std::exchange(found_, std::nullopt),
                         stream_seed(options_.budget.seed, shortened_++));
  keep(shortener.segments(), shortener.cost());
  while (!shortener.is_stalled() && !is_good_enough() && budget_.next()) {
    ++trials_;
    if (shortener.step()) keep(shortener.segments(), shortener.cost());
  }
  checks_ += shortener.checks();
  return !budget_.exhausted() && !is_good_enough();
}

PlannerAnswer Run::answer() {
  PlannerAnswer answer;
  answer.status = best_ ? PlanStatus::solved : budget_.reason();
  answer.segments = std::move(best_);
  answer.lower_bound = answer.segments ? std::min(bound_ * (1 - rounding), best_cost_) : 0.0;
  answer.iterations = budget_.iterations();
  answer.anytime = std::move(trace_);
  answer.counters = {
      {"nodes", nodes_}, {"edge_checks", checks_}, {"closings", closings_}, {"trials", trials_}};
  return answer;
}

}  // namespace

// Two searches look for each other, and what they find is made exact and then cheaper:
//
//   until the budget is spent:
//   [1]   search, forward from the start and back from the goal, until two states are near: a drive
//         by way of both is bent until it ends exactly at the goal
//   [2]   change a few segments at random and close the gap; keep what is cheaper and free
PlannerAnswer plan_rig(const Task& task, const PlanOptions& options) {
  if (options.planner.number("min_stroke") > 0.0) {
    throw InputError("min_stroke", "is for a vehicle without a trailer");
  }
  Run run(task, options);
  for (int round = 0; run.search(round) && run.shorten(); ++round) {
  }
  return run.answer();
}

}  // namespace vandplan::rig
