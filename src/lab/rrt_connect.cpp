// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/rrt_connect.h"

#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "lab/estimate_options.h"
#include "lab/tree_parts.h"
#include "vandplan/tables.h"

namespace vandplan::rrt_connect {
namespace {

using namespace search;

constexpr double least_progress = 0.1;  // progress of a step towards a pose [ranges]

// One of the two trees. Edges of the goal's tree are driven towards its root.
struct Side {
  Side(const LocalPose& root, double radius, bool of_goal)
      : tree(root, 64), nearest(radius), is_goal(of_goal) {
    nearest.add(root);
  }

  Tree tree;
  NearestNodes nearest;
  bool is_goal;  ///< whether the root is the goal
};

// Result of a step of a tree towards a target pose.
struct Reached {
  NodeId node;         ///< node at the end of the step
  LocalPose pose;      ///< pose at the end of the step
  bool is_there;       ///< whether the step ends at its target
  double left_before;  ///< length from the nearest node to the target, before the step [m]
};

// Both trees, and how they grow.
class Trees {
 public:
  Trees(const Task& task, const PlanOptions& options)
      : max_nodes_(static_cast<std::size_t>(options.planner.integer("max_nodes"))),
        profile_(options.planner.flag("profile")),
        connector_(task, length_rule(cost_rule(options.cost)), profile_),
        back_(task, reversed(connector_.rule(), 0), profile_),
        range_(options.planner.number("range") * connector_.radius()),
        ranking_time_(profile_),
        sides_{Side(task.start, connector_.radius(), false),
               Side(task.goal, connector_.radius(), true)} {
    order_ = {{0, 0}, {1, 0}};
  }

  Side& side(bool of_goal) { return sides_[of_goal ? 1 : 0]; }

  // Makes one step from the nearest node of a tree towards a pose. None if the step is blocked.
  std::optional<Reached> extend(Side& side, const LocalPose& to) {
    ranking_time_.start();
    const auto [near, length, solves] = *side.nearest.nearest(to);
    ranking_time_.stop();
    nearest_solves_ += solves;
    if (length == 0.0) return Reached{near, to, true, length};
    std::optional<LocalPose> end = to;
    Connector& outward = side.is_goal ? back_ : connector_;
    if (length > range_) end = planning::part_way(outward, side.tree.pose(near), to, range_);
    if (!end) return std::nullopt;
    const auto node = add(side, near, *end);
    return node ? std::optional(Reached{*node, *end, *end == to, length}) : std::nullopt;
  }

  // Makes steps of a tree towards a pose until one ends there, and gives the node at the pose. None
  // if a step is blocked or makes hardly any progress.
  std::optional<NodeId> connect(Side& side, const LocalPose& to, const Budget& budget) {
    double left = std::numeric_limits<double>::infinity();
    while (!is_full() && !budget.is_interrupted()) {
      const std::optional<Reached> reached = extend(side, to);
      if (!reached) break;
      if (reached->is_there) return reached->node;
      if (reached->left_before > left - least_progress * range_) break;
      left = reached->left_before;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_full() const { return order_.size() >= max_nodes_; }

  // Fills in the path through a pose that both trees have reached.
  void finish(NodeId of_start, NodeId of_goal, const Budget& budget, PlannerAnswer& answer) {
    std::vector<LocalPose> poses = sides_[0].tree.branch(of_start);
    const std::vector<LocalPose> rest = sides_[1].tree.branch(of_goal);
    poses.insert(poses.end(), rest.rbegin() + 1, rest.rend());
    answer.status = PlanStatus::solved;
    answer.anytime.push_back(
        {budget.elapsed(), budget.iterations(),
         sides_[0].tree.cost_to_come(of_start) + sides_[1].tree.cost_to_come(of_goal)});
    answer.segments = planning::segments_along(connector_, poses);
  }

  // Fills in counters and times, and both trees if the options ask for them.
  void report(const PlanOptions& options, PlannerAnswer& answer) const {
    const std::int64_t solves = connector_.solves() + back_.solves() + nearest_solves_;
    answer.counters = planning::counters_of(order_.size(), solves, connector_.checks());
    if (profile_) {
      answer.phases = {{"ranking", ranking_time_.seconds()},
                       {"steering", connector_.steering_time() + back_.steering_time()},
                       {"checking", connector_.checking_time()}};
    }
    if (!options.planner.flag("keep_tree")) return;
    TreeSnapshot& kept = answer.tree.emplace();
    std::array<std::vector<std::int32_t>, 2> places;
    for (const auto& [side, node] : order_) {
      const Tree& tree = sides_[side].tree;
      const NodeId parent = tree.parent(node);
      kept.parents.push_back(parent < 0 ? -1 : places[side][static_cast<std::size_t>(parent)]);
      places[side].push_back(static_cast<std::int32_t>(kept.poses.size()));
      kept.poses.push_back(tree.pose(node));
    }
  }

 private:
  // Adds a node below the node `near` if the edge between them is free.
  std::optional<NodeId> add(Side& side, NodeId near, const LocalPose& pose) {
    const LocalPose from = side.tree.pose(near);
    const auto edge = side.is_goal ? planning::edge_between(connector_, pose, from)
                                   : planning::edge_between(connector_, from, pose);
    if (!edge) return std::nullopt;
    const NodeId node =
        side.tree.add(pose, near, side.tree.cost_to_come(near) + edge->piece.length);
    side.nearest.add(pose);
    order_.emplace_back(side.is_goal ? 1 : 0, node);
    return node;
  }

  std::size_t max_nodes_;
  bool profile_;
  Connector connector_;
  Connector back_;  // steers from the goal's tree outwards, against the direction of driving
  double range_;    // longest step [m]
  PhaseTimer ranking_time_;
  std::int64_t nearest_solves_ = 0;
  std::array<Side, 2> sides_;
  std::vector<std::pair<std::size_t, NodeId>> order_;  // side and node, in the order of `add`
};

// RRT-Connect, Kuffner & LaValle 2000.
//
//   [1] two trees: {start} and {goal}
//   until the budget is spent or the trees are full:
//   [2]   sample := a random pose of the region; the first one is the goal
//   [3]   extend: one step of at most `range` from the nearest node of one tree to the sample, and
//         a new node there if it is free
//   [4]   connect: step after step from the other tree to the new node, as long as they are free
//   [5]   if that comes there, the path leads from tree to tree through the new node
//   [6]   else the trees change places
PlannerAnswer plan(const Task& task, const PlanOptions& options) {
  PlannerAnswer answer;
  Budget budget(options.budget);
  Rng rng(options.budget.seed);
  const Local<Bounds> region = sampling_region(task, planning::region_of(options));
  Trees trees(task, options);  // [1]
  bool from_goal = false;
  answer.status = PlanStatus::node_limit;
  while (!trees.is_full()) {
    if (!budget.next()) {
      answer.status = budget.reason();
      break;
    }
    const bool is_first = budget.iterations() == 1;
    const LocalPose sample = is_first ? task.goal : uniform_pose(region, rng);        // [2]
    if (const auto reached = trees.extend(trees.side(from_goal), sample)) {           // [3]
      const auto met = trees.connect(trees.side(!from_goal), reached->pose, budget);  // [4]
      if (met) {
        trees.finish(from_goal ? *met : reached->node, from_goal ? reached->node : *met, budget,
                     answer);  // [5]
        break;
      }
    }
    from_goal = !from_goal;  // [6]
  }
  answer.iterations = budget.iterations();
  trees.report(options, answer);
  return answer;
}

}  // namespace

Planner planner() {
  return {.name = "rrt-connect",
          .summary = "two RRTs, from start and goal, until they meet",
          .properties = {.family = "rrt-connect",
                         .capabilities = {Capability::gears, Capability::steering},
                         .groups = {"family"}},
          .options = {planning::region_option(), planning::range_option(10.0),
                      planning::max_nodes_option(100'000), planning::keep_tree_option(),
                      planning::profile_option()},
          .function = plan};
}

}  // namespace vandplan::rrt_connect
