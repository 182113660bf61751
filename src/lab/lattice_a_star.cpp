// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/lattice_a_star.h"

#include <algorithm>
#include <cmath>

#include "lab/lattice_search.h"
#include "search/open_ground.h"

namespace vandplan::lattice {
namespace {

/// Weights of the rounds: `first`, then smaller by `step` in each round, down to `last`.
struct Weights {
  double first, step, last;
};

/// Result that a search has proven.
struct Proof {
  double factor = 0.0;  ///< upper bound of best way / shortest way over the lattice; 0: none
};

void conclude(const Task& task, const CostRule& rule, const LatticeSearch& search,
              const Proof& proof, PlannerAnswer& answer) {
  search.report(answer);
  if (!std::isfinite(search.best())) return;
  answer.status = PlanStatus::solved;
  answer.segments = segments_of(search.best_way());
  // In one gear the bound is less by a leeway: the judge lets a path end slightly beside the goal.
  answer.lower_bound = rule.is_length()
                           ? length_on_open_ground(task)
                           : search::cost_lower_bound(search::open_ground(task, rule), rule, 0.0);
  if (proof.factor > 0.0) {
    answer.counters.push_back(
        {"lattice_factor_per_mille", static_cast<std::int64_t>(std::ceil(1000 * proof.factor))});
  }
}

// ARA* of Likhachev, Gordon and Thrun (2003) over a lattice; A* is one round of it.
//
//   [1] lay the lattice through the goal, join the start to the vertices around it
//   for each weight, from the first one down to the last one:
//     while there is an edge whose cost + weight * estimate is below the length of the best way:
//   [2]   take the edge of least cost + weight * estimate whose end is not closed in this round
//   [3]   if it is free, close its end; from there, now and then, try the exact piece to the goal
//   [4]   and find the edges that begin there; those that improve what is closed wait
//   [5] the best way is at most min(weight, best / least(cost + estimate)) times the shortest one
//   [6] what waited may come, with the next weight
PlannerAnswer plan(const Task& task, const PlanOptions& options, const Weights& weights) {
  PlannerAnswer answer;
  Budget budget(options.budget);
  const Ground ground = ground_of(task, options, budget);  // [1]
  if (ground.graph == nullptr) {
    answer.status = budget.exhausted().value_or(PlanStatus::stopped);
    return answer;
  }
  Connector connector(task, length_rule(cost_rule(options.cost)));
  LatticeSearch search(task, ground, connector,
                       {.weight = weights.first,
                        .shots = options.planner.flag("shots"),
                        .max_nodes = static_cast<std::size_t>(options.planner.integer("max_nodes")),
                        .keep_tree = options.planner.flag("keep_tree")});
  const auto improved = [&] {
    answer.anytime.push_back({budget.elapsed(), budget.iterations(), search.best()});
  };
  if (std::isfinite(search.best())) improved();
  answer.status = PlanStatus::node_limit;
  Proof proof;
  double weight = weights.first;
  while (answer.status == PlanStatus::node_limit && !search.is_full()) {
    while (!search.is_full() && search.has_next()) {
      if (!budget.next()) {
        answer.status = budget.reason();
        break;
      }
      if (search.step()) improved();  // [2] [3] [4]
    }
    const bool is_whole = answer.status == PlanStatus::node_limit && !search.is_full();
    if (is_whole && ground.guide.is_admissible && std::isfinite(search.best())) {  // [5]
      const double least = search.lattice_bound();
      proof.factor = search.best() / least;
      if (ground.guide.is_consistent) proof.factor = std::min(weight, proof.factor);
    }
    if (weight <= weights.last || proof.factor == 1.0) break;
    weight = std::max(weights.last, weight - weights.step);
    search.begin_round(weight);  // [6]
  }
  answer.iterations = budget.iterations();
  if (answer.status == PlanStatus::node_limit) {
    answer.reason = search.is_full() ? "the search has found as many vertices as it may"
                                     : "no way over the lattice is free";
  }
  conclude(task, connector.rule(), search, proof, answer);
  if (answer.segments) answer.reason.clear();
  return answer;
}

OptionInfo weight_option(const char* name, const char* summary, double default_value,
                         double least) {
  return {.name = name,
          .summary = summary,
          .default_value = default_value,
          .least = least,
          .most = 100};
}

std::vector<OptionInfo> with_shared(std::vector<OptionInfo> own) {
  for (OptionInfo& option : shared_options()) own.push_back(std::move(option));
  return own;
}

}  // namespace

std::vector<OptionInfo> a_star_options() {
  return with_shared({weight_option("weight", "weight of the estimate, 1: shortest path", 1, 1)});
}

std::vector<OptionInfo> ara_star_options() {
  return with_shared(
      {weight_option("first_weight", "weight of the estimate in the first round", 3, 1),
       weight_option("weight_step", "decrease of the weight per round", 0.5, 0.01),
       weight_option("last_weight", "weight of the estimate in the last round", 1, 1)});
}

PlannerAnswer plan_a_star(const Task& task, const PlanOptions& options) {
  const double weight = options.planner.number("weight");
  return plan(task, options, {weight, 1.0, weight});
}

PlannerAnswer plan_ara_star(const Task& task, const PlanOptions& options) {
  return plan(task, options,
              {options.planner.number("first_weight"), options.planner.number("weight_step"),
               options.planner.number("last_weight")});
}

}  // namespace vandplan::lattice
