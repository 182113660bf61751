// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/rrt.h"

#include <optional>

#include "lab/estimate_options.h"
#include "lab/grown_tree.h"
#include "lab/tree_parts.h"

namespace vandplan::rrt {
namespace {

using namespace search;
using planning::Adoption, planning::GrownTree;

RankBy rank_by(Strategy strategy) {
  return strategy == Strategy::nearest ? RankBy::length : RankBy::total_cost;
}

// Steps [3] and [4]: finds a parent for a sample; none if no edge that was tried is free.
std::optional<Adoption> adopt(GrownTree& tree, const State& sample, std::size_t max_parents) {
  std::optional<Adoption> best;
  for (const Candidate& candidate : tree.first(max_parents, sample)) {
    if (best && best->cost_to_come <= static_cast<double>(candidate.rank)) break;
    const double cutoff = best ? best->cost_to_come : Adoption{}.cost_to_come;
    if (auto edge = tree.try_edge(candidate.id, sample, cutoff)) best = edge;
  }
  return best;
}

}  // namespace

std::vector<OptionInfo> options(bool tries_goal) {
  return {planning::region_option(),
          planning::goal_bias_option(),
          planning::max_nodes_option(5000),
          {.name = "max_parents",
           .summary = "parents tried per sample (OPT)",
           .default_value = std::int64_t{50},
           .least = 1,
           .most = 10'000'000},
          planning::try_goal_option(tries_goal),
          planning::keep_tree_option(),
          planning::profile_option()};
}

// The tree of Guo 2020, Algorithms 1 and 2; LaValle 1998 with goal bias and Reeds-Shepp edges.
//
//   [1] tree := {start}
//   until the budget is spent or the tree is full:
//   [2]   sample := goal with probability goal_bias, else a random pose of the region
//   [3]   order the nodes by estimate (BSC) or by cost-to-come + estimate (OPT)
//   [4]   parent := in that order the first whose path to the sample is free; OPT goes on while
//         a later one could be cheaper still, BSC tries one only
//   [5]   add the sample to the tree, unless it is the goal
//   [6]   with try_goal: try the path from the new node to the goal, if it could be the cheapest
//   [7]   keep the cheapest way to the goal
PlannerAnswer plan(const Task& task, const PlanOptions& options, Variant variant) {
  PlannerAnswer answer;
  Budget budget(options.budget);
  planning::Sampler sampler(task, options);
  const bool try_goal = options.planner.flag("try_goal");
  const std::size_t max_parents =
      variant.strategy == Strategy::nearest
          ? 1
          : static_cast<std::size_t>(options.planner.integer("max_parents"));
  GrownTree tree(task, options, variant.estimate, rank_by(variant.strategy));  // [1]
  Adoption best;
  PlanStatus unsolved = PlanStatus::node_limit;
  while (!tree.is_full()) {
    if (!budget.next()) {
      unsolved = budget.reason();
      break;
    }
    const auto [sample, is_goal] = sampler.next();                              // [2]
    const std::optional<Adoption> adoption = adopt(tree, sample, max_parents);  // [3] [4]
    if (!adoption) continue;
    std::optional<Adoption> to_goal;
    if (is_goal) {
      to_goal = adoption;
    } else {
      const NodeId added = tree.add(sample, *adoption);                              // [5]
      if (try_goal) to_goal = tree.try_edge(added, tree.goal(), best.cost_to_come);  // [6]
    }
    if (to_goal && to_goal->cost_to_come < best.cost_to_come && tree.keep_way(*to_goal)) {
      best = *to_goal;  // [7]
      answer.anytime.push_back({budget.elapsed(), budget.iterations(), best.cost_to_come});
    }
  }
  answer.iterations = budget.iterations();
  tree.report(options, best, unsolved, answer);
  answer.phases.push_back({"setup", budget.set_up_time()});
  return answer;
}

}  // namespace vandplan::rrt
