// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/hrrt.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lab/estimate_options.h"
#include "lab/grown_tree.h"
#include "lab/tree_parts.h"

namespace vandplan::hrrt {
namespace {

using namespace search;
using planning::Adoption, planning::GrownTree;

// Quality of the paths through nodes, by cost-to-come plus estimated cost-to-go.
class Quality {
 public:
  Quality(const Task& task, const PlanOptions& options)
      : to_goal_(planning::estimate_of(options, task)),
        floor_(options.planner.number("floor")),
        reads_max_(options.planner.word("floor_reading") == "max") {
    add(task.start, 0.0);
  }

  void add(const LocalPose& pose, double cost_to_come) {
    costs_.push_back(cost_to_come + to_goal_.length(pose));
    if (std::isfinite(costs_.back())) worst_ = std::max(worst_, costs_.back());
  }

  /// Cost-to-come plus estimated cost-to-go of a node [m].
  [[nodiscard]] double cost_through(NodeId node) const {
    return costs_[static_cast<std::size_t>(node)];
  }

  /// Probability that a node passes: 1 if the path through the node is as short as the estimate
  /// from the start, less for longer paths. The floor bounds it from below, or with `min` from
  /// above.
  [[nodiscard]] double of(NodeId node) const {
    const double best = costs_.front();
    const double quality =
        worst_ > best ? 1.0 - (cost_through(node) - best) / (worst_ - best) : 1.0;
    return reads_max_ ? std::max(quality, floor_) : std::min(quality, floor_);
  }

 private:
  GoalEstimate to_goal_;
  double floor_;
  bool reads_max_;
  std::vector<double> costs_;
  double worst_ = 0.0;  // largest finite cost through a node [m]
};

// Step [4]: selects a parent among the nodes near a sample; none if no node passes.
std::optional<NodeId> select(Selection selection, const std::vector<Candidate>& near,
                             const Quality& quality, Rng& rng) {
  const auto passes = [&](NodeId node) { return uniform01(rng) < quality.of(node); };
  if (selection == Selection::best_of_k) {
    const NodeId best = std::ranges::min_element(near, {}, [&](const Candidate& candidate) {
                          return quality.cost_through(candidate.id);
                        })->id;
    return passes(best) ? std::optional(best) : std::nullopt;
  }
  const auto first = std::ranges::find_if(near, passes, &Candidate::id);
  return first == near.end() ? std::nullopt : std::optional(first->id);
}

// Heuristically guided trees, Urmson & Simmons 2003. The cost through a node is its cost-to-come
// plus its estimated cost-to-go. The quality of a node is 1 at the start's cost and falls linearly
// to 0 at the largest cost of all nodes.
//
//   [1] tree := {start}
//   until the budget is spent or the tree is full:
//   [2]   sample := goal with probability goal_bias, else a random pose of the region
//   [3]   near := the node nearest to the sample (hRRT), the k nearest (IkRRT, BkRRT)
//   [4]   parent := in that order the first that passes, with probability max(quality, floor);
//         BkRRT lets the one of least cost try alone. Nobody passes: the next sample
//   [5]   add the sample to the tree if the path from the parent is free, unless it is the goal
//   [6]   with try_goal: try the path from the new node to the goal, if it could be the cheapest
//   [7]   keep the cheapest way to the goal
PlannerAnswer plan(const Task& task, const PlanOptions& options, Selection selection) {
  PlannerAnswer answer;
  Budget budget(options.budget);
  planning::Sampler sampler(task, options);
  const bool try_goal = options.planner.flag("try_goal");
  const std::size_t count =
      selection == Selection::nearest ? 1 : static_cast<std::size_t>(options.planner.integer("k"));
  GrownTree tree(task, options, estimate_named(options.planner.word("ranking")),
                 RankBy::length);  // [1]
  Quality quality(task, options);
  std::int64_t refused = 0;
  Adoption best;
  PlanStatus unsolved = PlanStatus::node_limit;
  while (!tree.is_full()) {
    if (!budget.next()) {
      unsolved = budget.reason();
      break;
    }
    const auto [sample, is_goal] = sampler.next();                        // [2]
    const std::vector<Candidate>& near = tree.first(count, sample);       // [3]
    const auto parent = select(selection, near, quality, sampler.rng());  // [4]
    refused += parent ? 0 : 1;
    if (!parent) continue;
    std::optional<Adoption> to_goal;
    if (is_goal) {
      to_goal = tree.try_edge(*parent, sample, best.cost_to_come);
    } else if (const auto edge = tree.try_edge(*parent, sample)) {
      const NodeId added = tree.add(sample, *edge);  // [5]
      quality.add(Local(sample.pose), edge->cost_to_come);
      if (try_goal) to_goal = tree.try_edge(added, tree.goal(), best.cost_to_come);  // [6]
    }
    if (!to_goal) continue;
    best = *to_goal;  // [7]
    answer.anytime.push_back({budget.elapsed(), budget.iterations(), best.cost_to_come});
  }
  answer.iterations = budget.iterations();
  tree.report(options, best, unsolved, answer);
  answer.phases.push_back({"setup", budget.set_up_time()});
  answer.counters.push_back({"refused", refused});
  return answer;
}

std::vector<OptionInfo> options(Selection selection) {
  std::vector<OptionInfo> all = planning::estimate_options("reeds-shepp");
  all.insert(all.end(), {planning::region_option(), planning::goal_bias_option()});
  if (selection != Selection::nearest) {
    all.push_back({.name = "k",
                   .summary = "nearest nodes asked per sample",
                   .default_value = std::int64_t{5},
                   .least = 1,
                   .most = 10'000});
  }
  all.push_back({.name = "floor",
                 .summary = "floor of the probability that a node passes",
                 .default_value = 0.1,
                 .least = 0,
                 .most = 1});
  all.push_back({.name = "floor_reading",
                 .summary = "larger or smaller value of quality and floor",
                 .default_value = std::string("max"),
                 .words = {"max", "min"}});
  all.push_back({.name = "ranking",
                 .summary = "distance that ranks the nodes",
                 .default_value = std::string("reeds-shepp"),
                 .words = {estimate_names.begin(), estimate_names.end()}});
  all.insert(all.end(), {planning::max_nodes_option(5000), planning::try_goal_option(false),
                         planning::keep_tree_option(), planning::profile_option()});
  return all;
}

}  // namespace

Planner planner(Selection selection) {
  Planner made{.name = "hrrt",
               .summary = "RRT that prefers nodes on good paths: the nearest, if it is good",
               .properties = {.family = "hrrt",
                              .strategy = "nearest",
                              .capabilities = {Capability::gears, Capability::steering},
                              .anytime = true,
                              .groups = {"family"}},
               .options = options(selection),
               .function = [selection](const Task& task, const PlanOptions& options) {
                 return plan(task, options, selection);
               }};
  if (selection == Selection::first_of_k) {
    made.name = "ikrrt";
    made.summary = "RRT that prefers nodes on good paths: the first good one of the k nearest";
    made.properties.strategy = "first-of-k";
  } else if (selection == Selection::best_of_k) {
    made.name = "bkrrt";
    made.summary = "RRT that prefers nodes on good paths: the best of the k nearest, if good";
    made.properties.strategy = "best-of-k";
  }
  return made;
}

}  // namespace vandplan::hrrt
