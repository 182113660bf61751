// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rrt.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "base/random.h"
#include "geometry/random_pose.h"
#include "search/budget.h"
#include "search/tree.h"
#include "vandplan/nearest.h"
#include "vandplan/reeds_shepp.h"

namespace vandplan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A parent for a sample and what the sample then costs.
struct Connection {
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
class Search {
 public:
  Search(const Problem& problem, const PlanOptions& options, Strategy strategy, Estimate estimate)
      : problem_(problem),
        strategy_(strategy),
        estimate_(estimate),
        max_parents_(strategy == Strategy::nearest ? 1
                                                   : static_cast<std::size_t>(options.max_parents)),
        tree_(problem.start, static_cast<std::size_t>(options.max_nodes)),
        timer_(options.profile) {
    if (strategy == Strategy::nearest && estimate == Estimate::reeds_shepp) {
      exact_nearest_.emplace(radius()).add(problem.start);
    }
    ranks_.resize(static_cast<std::size_t>(options.max_nodes));
    candidates_.reserve(max_parents_ + 1);
  }

  // Steps [3] and [4] of plan_rrt.
  std::optional<Connection> connect(const Pose& sample, PlanResult& result) {
    rank(sample, result);
    std::optional<Connection> best;
    for (const Candidate& candidate : candidates_) {
      if (best && best->cost_to_come <= static_cast<double>(candidate.rank)) break;
      const double limit = best ? best->cost_to_come : infinity;
      if (auto edge = try_edge(candidate.id, sample, limit, result)) best = edge;
    }
    return best;
  }

  // The edge from a node to a pose, if it is free and reaches the pose below the limit of cost.
  std::optional<Connection> try_edge(NodeId node, const Pose& to, double limit,
                                     PlanResult& result) {
    const Pose& from = tree_.pose(node);
    timer_.start();
    const Piece piece = reeds_shepp(from, to, radius());
    timer_.stop(result.time_steering);
    ++result.exact_solves;
    const double cost = tree_.cost_to_come(node) + piece.length;
    if (cost >= limit) return std::nullopt;
    timer_.start();
    const bool free = problem_.world->checker().is_free(from, piece.view());
    timer_.stop(result.time_checking);
    ++result.edge_checks;
    if (!free) return std::nullopt;
    return Connection{node, cost};
  }

  const Tree& tree() const { return tree_; }

  NodeId add(const Pose& pose, const Connection& connection) {
    if (exact_nearest_) exact_nearest_->add(pose);
    return tree_.add(pose, connection.parent, connection.cost_to_come);
  }

  // The path through a node to the goal.
  Path path_through(NodeId node) const {
    std::vector<Pose> poses = tree_.branch(node);
    poses.push_back(problem_.goal);
    std::vector<Segment> segments;
    for (std::size_t i = 1; i < poses.size(); ++i) {
      const Piece piece = reeds_shepp(poses[i - 1], poses[i], radius());
      segments.insert(segments.end(), piece.view().begin(), piece.view().end());
    }
    return {problem_.start, merged(segments)};
  }

 private:
  double radius() const { return problem_.world->vehicle().min_turning_radius; }

  void rank(const Pose& sample, PlanResult& result) {
    timer_.start();
    if (exact_nearest_) {
      const auto [node, length, solves] = *exact_nearest_->nearest(sample);
      candidates_ = {{static_cast<float>(length), node}};
      result.exact_solves += solves;
      timer_.stop(result.time_ranking);
      return;
    }
    const std::span<float> ranks(ranks_.data(), tree_.size());
    estimate_lengths(estimate_, tree_, sample, radius(), ranks);
    if (strategy_ == Strategy::least_total_cost) {
      for (std::size_t i = 0; i < ranks.size(); ++i) ranks[i] += tree_.cost_to_come()[i];
    }
    best_candidates(ranks, max_parents_, candidates_);
    timer_.stop(result.time_ranking);
  }

  const Problem& problem_;
  Strategy strategy_;
  Estimate estimate_;
  std::size_t max_parents_;
  Tree tree_;
  std::optional<NearestNodes> exact_nearest_;  // where it says what ranking would
  PhaseTimer timer_;
  std::vector<float> ranks_;
  std::vector<Candidate> candidates_;
};

}  // namespace

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
PlanResult plan_rrt(const Problem& problem, const PlanOptions& options, Strategy strategy,
                    Estimate estimate) {
  PlanResult result;
  Budget budget(options);
  base::Rng rng(options.seed);
  const Bounds region = sampling_region(problem, options.region);
  const auto max_nodes = static_cast<std::size_t>(options.max_nodes);
  Search search(problem, options, strategy, estimate);  // [1]
  Connection best{-1, infinity};
  result.status = PlanStatus::node_limit;
  while (search.tree().size() < max_nodes) {
    if (!budget.next()) {
      result.status = budget.reason();
      break;
    }
    const bool is_goal = base::uniform01(rng) < options.goal_bias;
    const Pose sample = is_goal ? problem.goal : geometry::uniform_pose(region, rng);  // [2]
    const std::optional<Connection> connection = search.connect(sample, result);       // [3] [4]
    if (!connection) continue;
    std::optional<Connection> to_goal;
    if (is_goal) {
      to_goal = connection;
    } else {
      const NodeId added = search.add(sample, *connection);  // [5]
      if (options.try_goal) {
        to_goal = search.try_edge(added, problem.goal, best.cost_to_come, result);  // [6]
      }
    }
    if (to_goal && to_goal->cost_to_come < best.cost_to_come) {
      best = *to_goal;  // [7]
      result.anytime.push_back({budget.elapsed(), budget.iterations(), best.cost_to_come});
    }
  }
  if (best.parent >= 0) {
    result.status = PlanStatus::solved;
    result.path = search.path_through(best.parent);
    result.cost = length(result.path->segments);
  }
  result.iterations = budget.iterations();
  result.nodes = static_cast<std::int64_t>(search.tree().size());
  if (options.keep_tree) result.tree = search.tree().snapshot();
  result.time_total = budget.elapsed();
  return result;
}

}  // namespace vandplan
