// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/rrt_star.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "lab/estimate_options.h"
#include "lab/rewired_tree.h"
#include "lab/tree_parts.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan::rrt_star {
namespace {

using namespace search;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The last edge of a path: to a new node or to the goal.
struct LastEdge {
  NodeId from = -1;        // node where the edge begins; -1: there is no edge
  double cost = infinity;  // cost of the edge [m]
};

// A node near a pose.
struct Candidate {
  NodeId id;
  double length;  // length from the node to the pose without obstacles [m]
  double total;   // cost-to-come of the node plus `length` [m]
};

// One run of the planner: the tree, and the steps that grow and improve it.
class RrtStarRun {
 public:
  RrtStarRun(const Task& task, const PlanOptions& options)
      : task_(task),
        factor_(options.planner.number("rewire_factor")),
        informed_(options.planner.flag("informed")),
        max_nodes_(static_cast<std::size_t>(options.planner.integer("max_nodes"))),
        profile_(options.planner.flag("profile")),
        connector_(task, length_rule(cost_rule(options.cost)), profile_),
        range_(options.planner.number("range") * connector_.radius()),
        ranking_time_(profile_),
        tree_(task.start),
        nearest_(connector_.radius()) {
    nearest_.add(task.start);
  }

  [[nodiscard]] bool is_full() const { return tree_.size() >= max_nodes_; }
  [[nodiscard]] double cost() const {
    return goal_.from < 0 ? infinity : tree_.cost_to_come(goal_.from) + goal_.cost;
  }

  // Part of a region where samples can be of use: paths through other places are longer than the
  // best path.
  [[nodiscard]] Bounds region_of_use(const Bounds& region) const {
    if (!informed_ || goal_.from < 0) return region;
    const Pose& a = task_.start;
    const Pose& b = task_.goal;
    const double reach = cost() / 2;
    return {std::max(region.x_min, (a.x + b.x) / 2 - reach),
            std::min(region.x_max, (a.x + b.x) / 2 + reach),
            std::max(region.y_min, (a.y + b.y) / 2 - reach),
            std::min(region.y_max, (a.y + b.y) / 2 + reach)};
  }
  // Whether a path through a pose could be shorter than the best path.
  [[nodiscard]] bool is_of_use(const LocalPose& pose) const {
    return !informed_ || goal_.from < 0 ||
           length(task_.start, pose) + length(pose, task_.goal) < cost();
  }

  // Step [3]: a pose on the way from the nearest node to the sample, as far as an edge may go.
  std::optional<LocalPose> towards(const LocalPose& sample) {
    ranking_time_.start();
    const auto [near, length, solves] = *nearest_.nearest(sample);
    ranking_time_.stop();
    nearest_solves_ += solves;
    if (length <= range_) return sample;
    return planning::part_way(connector_, tree_.pose(near), sample, range_);
  }

  // Step [4]: finds the nodes near a pose, and sorts them by the pose's cost through them.
  void find_near(const LocalPose& pose) {
    ranking_time_.start();
    const auto size = static_cast<double>(tree_.size());
    // Number of near nodes: factor e (1 + 1/d) ln n, d = 3 dimensions (Karaman & Frazzoli 2011).
    const double wanted = factor_ * std::numbers::e * (1.0 + 1.0 / 3.0) * std::log(size + 1.0);
    near_.clear();
    const NearWanted query{.count = static_cast<std::size_t>(std::ceil(wanted))};
    for (const auto& [node, length] : nearest_.nearest(pose, query)) {
      near_.push_back({node, length, tree_.cost_to_come(node) + length});
    }
    nearest_solves_ += static_cast<std::int64_t>(near_.size());
    std::ranges::stable_sort(near_, {}, &Candidate::total);
    ranking_time_.stop();
  }

  // Step [5]: the edge from the near node through which the pose costs least; none if no edge is
  // free and reaches the pose below the cutoff.
  std::optional<LastEdge> best_parent(const LocalPose& pose, double cutoff) {
    std::optional<LastEdge> best;
    for (const Candidate& candidate : near_) {
      if (candidate.total >= cutoff) break;
      const double so_far = tree_.cost_to_come(candidate.id);
      const auto edge =
          planning::edge_between(connector_, tree_.pose(candidate.id), pose, so_far, cutoff);
      if (!edge) continue;
      best = LastEdge{candidate.id, edge->piece.length};
      cutoff = edge->cost;
    }
    return best;
  }

  NodeId add(const LocalPose& pose, const LastEdge& edge) {
    nearest_.add(pose);
    return tree_.add(pose, edge.from, edge.cost);
  }

  // Step [6]: moves near nodes that cost less through the new node below it.
  void rewire(NodeId added) {
    const LocalPose pose = tree_.pose(added);
    const double so_far = tree_.cost_to_come(added);
    for (const Candidate& candidate : near_) {
      const double cost = tree_.cost_to_come(candidate.id);
      if (so_far + candidate.length >= cost) continue;
      const auto edge =
          planning::edge_between(connector_, pose, tree_.pose(candidate.id), so_far, cost);
      if (!edge) continue;
      tree_.move(candidate.id, added, edge->piece.length);
      ++rewired_;
    }
  }

  // Step [7]: tries the edge from the new node to the goal.
  void try_goal(NodeId node) {
    const double so_far = tree_.cost_to_come(node);
    if (so_far + length(tree_.pose(node), task_.goal) >= cost()) return;
    const auto edge =
        planning::edge_between(connector_, tree_.pose(node), task_.goal, so_far, cost());
    if (edge) goal_ = {node, edge->piece.length};
  }

  void set_last_edge(const LastEdge& to_goal) { goal_ = to_goal; }

  // Fills in path, counters and times, and the tree if the options ask for it.
  void report(const PlanOptions& options, PlannerAnswer& answer) {
    if (goal_.from >= 0) {
      std::vector<LocalPose> poses = tree_.branch(goal_.from);
      poses.push_back(task_.goal);
      answer.status = PlanStatus::solved;
      answer.segments = planning::segments_along(connector_, poses);
    }
    answer.counters = planning::counters_of(tree_.size(), connector_.solves() + nearest_solves_,
                                            connector_.checks());
    answer.counters.push_back({"rewired", rewired_});
    if (profile_) {
      answer.phases = {{"ranking", ranking_time_.seconds()},
                       {"steering", connector_.steering_time()},
                       {"checking", connector_.checking_time()}};
    }
    if (options.planner.flag("keep_tree")) answer.tree = tree_.snapshot();
  }

 private:
  [[nodiscard]] double length(const Pose& from, const Pose& to) const {
    return reeds_shepp_length(from, to, connector_.radius());
  }

  const Task& task_;
  double factor_;
  bool informed_;
  std::size_t max_nodes_;
  bool profile_;
  Connector connector_;
  double range_;  // longest edge that is grown [m]
  PhaseTimer ranking_time_;
  RewiredTree tree_;
  NearestNodes nearest_;
  std::vector<Candidate> near_;  // nodes near the pose of this iteration
  LastEdge goal_;                // last edge of the best path
  std::int64_t nearest_solves_ = 0;
  std::int64_t rewired_ = 0;
};

// RRT*, Karaman & Frazzoli 2011; informed: Gammell, Srinivasa & Barfoot 2014.
//
//   [1] tree := {start}
//   until the budget is spent or the tree is full:
//   [2]   sample := goal with probability goal_bias, else a random pose of the region; informed: if
//         no shorter way than the best leads through it, the next sample
//   [3]   new := at most `range` on the way from the nearest node to the sample
//   [4]   near := the k nearest nodes, k = rewire_factor e (1 + 1/3) ln n
//   [5]   parent := the near node through which new costs least on a free path; none: the next
//         sample
//   [6]   rewire: new becomes the parent of every near node that then costs less on a free path
//   [7]   with try_goal: try the path from new to the goal, if it could be the cheapest
//   [8]   keep the cheapest way to the goal
PlannerAnswer plan(const Task& task, const PlanOptions& options) {
  PlannerAnswer answer;
  Budget budget(options.budget);
  planning::Sampler sampler(task, options);
  const bool try_goal = options.planner.flag("try_goal");
  RrtStarRun run(task, options);  // [1]
  double best = infinity;
  answer.status = PlanStatus::node_limit;
  while (!run.is_full()) {
    if (!budget.next()) {
      answer.status = budget.reason();
      break;
    }
    const auto [state, is_goal] = sampler.next(run.region_of_use(sampler.region()));  // [2]
    const LocalPose sample(state.pose);
    if (!run.is_of_use(sample)) continue;
    const std::optional<LocalPose> pose = is_goal ? sample : run.towards(sample);  // [3]
    if (!pose) continue;
    run.find_near(*pose);                                                         // [4]
    const auto parent = run.best_parent(*pose, is_goal ? run.cost() : infinity);  // [5]
    if (!parent) continue;
    if (is_goal) {
      run.set_last_edge(*parent);
    } else {
      const NodeId added = run.add(*pose, *parent);
      run.rewire(added);                  // [6]
      if (try_goal) run.try_goal(added);  // [7]
    }
    if (run.cost() >= best) continue;
    best = run.cost();  // [8]
    answer.anytime.push_back({budget.elapsed(), budget.iterations(), best});
  }
  answer.iterations = budget.iterations();
  run.report(options, answer);
  return answer;
}

}  // namespace

Planner planner() {
  return {.name = "rrt-star",
          .summary = "RRT*: rewires edges as the tree grows",
          .properties = {.family = "rrt-star",
                         .tries_goal = true,
                         .capabilities = {Capability::gears, Capability::steering},
                         .anytime = true,
                         .groups = {"family"}},
          .options = {planning::region_option(),
                      planning::goal_bias_option(),
                      planning::range_option(10.0),
                      {.name = "rewire_factor",
                       .summary = "number of rewired nodes, times e (1 + 1/3) ln(nodes)",
                       .default_value = 1.1,
                       .least = 0.1,
                       .most = 10},
                      {.name = "informed",
                       .summary = "draw only samples that could improve the path",
                       .default_value = true},
                      planning::try_goal_option(true),
                      planning::max_nodes_option(200'000),
                      planning::keep_tree_option(),
                      planning::profile_option()},
          .function = plan};
}

}  // namespace vandplan::rrt_star
