// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rrt.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "planners/shared_options.h"
#include "vandplan/nearest.h"
#include "vandplan/random.h"
#include "vandplan/reeds_shepp.h"
#include "vandplan/search.h"

namespace vandplan::rrt {
namespace {

using namespace search;

constexpr double infinity = std::numeric_limits<double>::infinity();

// A parent for a sample and what the sample then costs.
struct Adoption {
  NodeId parent;
  double cost_to_come;
};

// A node as a candidate for a parent: its rank is what the strategy orders by. Ties go to the
// older node.
struct Candidate {
  float rank;
  NodeId id;
  bool operator<(const Candidate& other) const {
    return rank != other.rank ? rank < other.rank : id < other.id;
  }
};

// The `count` best candidates in order (or all, if there are fewer).
void best_candidates(std::span<const float> ranks, std::size_t count,
                     std::vector<Candidate>& best) {
  best.clear();  // a max-heap until the end
  float limit = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    if (ranks[i] >= limit) continue;
    if (best.size() == count) {
      std::pop_heap(best.begin(), best.end());
      best.pop_back();
    }
    best.push_back({ranks[i], static_cast<NodeId>(i)});
    std::push_heap(best.begin(), best.end());
    if (best.size() == count) limit = best.front().rank;
  }
  std::sort_heap(best.begin(), best.end());
}

// One run: the tree, and the buffers that its loop needs.
class Run {
 public:
  Run(const Task& task, const PlanOptions& options, Variant variant)
      : task_(task),
        variant_(variant),
        max_parents_(variant.strategy == Strategy::nearest
                         ? 1
                         : static_cast<std::size_t>(options.planner.integer("max_parents"))),
        max_nodes_(static_cast<std::size_t>(options.planner.integer("max_nodes"))),
        profile_(options.planner.flag("profile")),
        connector_(task, {}, profile_),
        tree_(task.start, max_nodes_),
        ranking_(profile_) {
    if (variant.strategy == Strategy::nearest && variant.estimate == Estimate::reeds_shepp) {
      exact_nearest_.emplace(connector_.radius()).add(task.start);
    }
    ranks_.resize(max_nodes_);
    candidates_.reserve(max_parents_ + 1);
  }

  // Steps [3] and [4] of the tree.
  std::optional<Adoption> adopt(const Pose& sample) {
    rank(sample);
    std::optional<Adoption> best;
    for (const Candidate& candidate : candidates_) {
      if (best && best->cost_to_come <= static_cast<double>(candidate.rank)) break;
      if (auto edge = try_edge(candidate.id, sample, best ? best->cost_to_come : infinity)) {
        best = edge;
      }
    }
    return best;
  }

  // The edge from a node to a pose, if it is free and reaches the pose below the cutoff of cost.
  std::optional<Adoption> try_edge(NodeId node, const Pose& to, double cutoff) {
    // An edge is steered again in the end: a continuous piece is the same one if both times nothing
    // cuts the search for it short.
    const double limit = connector_.continuous() != nullptr ? infinity : cutoff;
    const std::optional<Connection> edge =
        connector_.connect(tree_.pose(node), to, {tree_.cost_to_come(node), limit, {}});
    if (!edge || edge->cost >= cutoff) return std::nullopt;
    return Adoption{node, edge->cost};
  }

  NodeId add(const Pose& pose, const Adoption& adoption) {
    if (exact_nearest_) exact_nearest_->add(pose);
    return tree_.add(pose, adoption.parent, adoption.cost_to_come);
  }

  [[nodiscard]] bool is_full() const { return tree_.size() >= max_nodes_; }

  // The segments through a node to the goal.
  [[nodiscard]] std::vector<Segment> segments_through(NodeId node) {
    std::vector<Pose> poses = tree_.branch(node);
    poses.push_back(task_.goal);
    std::vector<Segment> segments;
    for (std::size_t i = 1; i < poses.size(); ++i) {
      const std::optional<Piece> piece = connector_.steer(poses[i - 1], poses[i]);
      segments.insert(segments.end(), piece->view().begin(), piece->view().end());
    }
    return merged(segments);
  }

  // What was counted and measured, and the tree if it is wanted.
  void report(const PlanOptions& options, PlannerAnswer& answer) const {
    answer.counters = {{"nodes", static_cast<std::int64_t>(tree_.size())},
                       {"exact_solves", connector_.solves() + nearest_solves_},
                       {"edge_checks", connector_.checks()}};
    if (profile_) {
      answer.phases = {{"ranking", ranking_.seconds()},
                       {"steering", connector_.steering_time()},
                       {"checking", connector_.checking_time()}};
    }
    if (options.planner.flag("keep_tree")) answer.tree = tree_.snapshot();
  }

 private:
  void rank(const Pose& sample) {
    ranking_.start();
    if (exact_nearest_) {
      const auto [node, length, solves] = *exact_nearest_->nearest(sample);
      candidates_ = {{static_cast<float>(length), node}};
      nearest_solves_ += solves;
    } else {
      const std::span<float> ranks(ranks_.data(), tree_.size());
      estimate_lengths(variant_.estimate, tree_, sample, connector_.radius(), ranks);
      if (variant_.strategy == Strategy::least_total_cost) {
        for (std::size_t i = 0; i < ranks.size(); ++i) ranks[i] += tree_.cost_to_come()[i];
      }
      best_candidates(ranks, max_parents_, candidates_);
    }
    ranking_.stop();
  }

  const Task& task_;
  Variant variant_;
  std::size_t max_parents_;
  std::size_t max_nodes_;
  bool profile_;
  Connector connector_;
  Tree tree_;
  std::optional<NearestNodes> exact_nearest_;  // where it says what ranking would
  std::int64_t nearest_solves_ = 0;
  PhaseTimer ranking_;
  std::vector<float> ranks_;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<OptionInfo> options(bool tries_goal) {
  return {
      planning::region_option(),
      {.name = "goal_bias",
       .summary = "share of samples that are the goal",
       .standard = 0.05,
       .least = 0,
       .most = 1},
      {.name = "max_nodes",
       .summary = "of the search tree",
       .standard = std::int64_t{5000},
       .least = 1,
       .most = 10'000'000},
      {.name = "max_parents",
       .summary = "parents tried for one sample (OPT)",
       .standard = std::int64_t{50},
       .least = 1,
       .most = 10'000'000},
      {.name = "try_goal", .summary = "try the goal from every new node", .standard = tries_goal},
      {.name = "keep_tree", .summary = "return the search tree as well", .standard = false},
      {.name = "profile", .summary = "measure where the time goes", .standard = false}};
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
  Rng rng(options.budget.seed);
  const Bounds region = sampling_region(task, planning::region_of(options));
  const double goal_bias = options.planner.number("goal_bias");
  const bool try_goal = options.planner.flag("try_goal");
  Run run(task, options, variant);  // [1]
  Adoption best{-1, infinity};
  answer.status = PlanStatus::node_limit;
  while (!run.is_full()) {
    if (!budget.next()) {
      answer.status = budget.reason();
      break;
    }
    const bool is_goal = uniform01(rng) < goal_bias;
    const Pose sample = is_goal ? task.goal : uniform_pose(region, rng);  // [2]
    const std::optional<Adoption> adoption = run.adopt(sample);           // [3] [4]
    if (!adoption) continue;
    std::optional<Adoption> to_goal;
    if (is_goal) {
      to_goal = adoption;
    } else {
      const NodeId added = run.add(sample, *adoption);                            // [5]
      if (try_goal) to_goal = run.try_edge(added, task.goal, best.cost_to_come);  // [6]
    }
    if (to_goal && to_goal->cost_to_come < best.cost_to_come) {
      best = *to_goal;  // [7]
      answer.anytime.push_back({budget.elapsed(), budget.iterations(), best.cost_to_come});
    }
  }
  if (best.parent >= 0) {
    answer.status = PlanStatus::solved;
    answer.segments = run.segments_through(best.parent);
  }
  answer.iterations = budget.iterations();
  run.report(options, answer);
  return answer;
}

}  // namespace vandplan::rrt
