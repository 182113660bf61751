// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/hybrid_a_star.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

#include "base/trigonometry.h"
#include "lab/cell_costs.h"
#include "lab/estimate_options.h"
#include "lab/voronoi_field.h"
#include "planners/anytime/shorten.h"
#include "search/open_ground.h"
#include "search/route.h"
#include "vandplan/search.h"

namespace vandplan::hybrid {
namespace {

using namespace search;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;     // relative rounding error of a bound
constexpr double reach_of_field = 4;  // reach of the Voronoi potential [vehicle widths]

/// A reached pose, whose way from the start is free.
struct Node {
  LocalPose pose;
  Segment segment;  // segment from the parent
  double cost_to_come;
  double to_go;         // estimated cost-to-go
  std::int32_t parent;  // index of the parent; -1: this is the start
};

/// A segment, and the pose to which it leads from the origin.
struct Step {
  Segment segment;
  Pose shape;
};

/// A node in the open list. Ties go to the younger node.
struct Entry {
  double rank;
  std::int32_t node;
  bool operator<(const Entry& other) const {  // the largest entry comes first
    return rank != other.rank ? rank > other.rank : node < other.node;
  }
};

/// Largest number of halvings of steps and cells.
constexpr int most_halvings = 2;

/// A path to the goal: along the tree to a node, then by an exact piece.
struct Found {
  std::int32_t node = -1;
  Piece last = {};
  double cost = infinity;
};

// One search: its nodes, its cells and its open list.
class HybridAStarSearch {
 public:
  HybridAStarSearch(const Task& task, const PlanOptions& options)
      : task_(task),
        connector_(task, cost_rule(options.cost, task)),
        estimate_(planning::estimate_of(options, task)),
        cell_(options.planner.number("cell")),
        headings_(static_cast<int>(options.planner.integer("headings"))),
        step_(step_of(options.planner.number("step"))),
        weight_(options.planner.number("weight")),
        voronoi_weight_(options.planner.number("voronoi_weight")),
        shot_spacing_(options.planner.number("shot_spacing")),
        improves_(options.planner.flag("improve")),
        keeps_tree_(options.planner.flag("keep_tree")),
        max_nodes_(static_cast<std::size_t>(options.planner.integer("max_nodes"))) {
    is_variable_ = options.planner.flag("variable_step");
    if (is_variable_ || voronoi_weight_ > 0.0) voronoi_.emplace(task, cell_);
    for (int halvings = 0; halvings <= most_halvings; ++halvings) make_steps(halvings);
    nodes_.push_back({task.start, {}, 0.0, 0.0, -1});  // the start waits whatever its estimate
    open_.push({0.0, 0});
  }

  // A part of step [1]: computes the Voronoi field. False when the field is complete or not needed.
  bool prepare() { return voronoi_ && voronoi_->step(); }

  [[nodiscard]] const Found& found() const { return found_; }
  // Whether the best path is as cheap as the cheapest path without obstacles.
  [[nodiscard]] bool is_shortest() const { return is_shortest_; }
  [[nodiscard]] bool is_full() const { return nodes_.size() >= max_nodes_; }

  // Steps [2] and [3]: the node that is expanded next; none if no node can lead to a cheaper path.
  std::optional<std::int32_t> next() {
    while (!open_.empty() && !is_shortest_) {
      const auto [rank, id] = open_.top();
      if (rank >= found_.cost && !improves_) return std::nullopt;
      open_.pop();
      const Node& node = at(id);
      double& least = cells_.cost(key_of(node));
      if (node.cost_to_come > least || node.cost_to_come + node.to_go >= found_.cost) continue;
      least = -infinity;  // closed: no later pose costs less
      return id;
    }
    return std::nullopt;
  }

  // Step [4]: tries the exact piece from a node to the goal. True if it makes the best path
  // cheaper.
  bool shoot(std::int32_t id) {
    if (--until_shot_ > 0) return false;
    const Node& node = at(id);
    until_shot_ = 1 + static_cast<int>(std::min(node.to_go / shot_spacing_, 1e6));
    ++shots_;
    const std::optional<Connection> shot = connector_.connect(
        node.pose, task_.goal, {node.cost_to_come, found_.cost, {driven_to(node), {}}});
    if (!shot) return false;
    const double cost = shot->cost + aside(node.pose, shot->piece.view());
    if (cost >= found_.cost) return false;
    found_ = {id, shot->piece, cost};
    const double least = connector_.least_cost(task_.start, task_.goal, ends());
    is_shortest_ = found_.cost <= least * (1 + rounding);
    return true;
  }

  // Steps [5] to [7]: drives a step from a node to either side and straight on, in both gears.
  void expand(std::int32_t id) {
    ++expansions_;
    if (keeps_tree_) keep(id);
    if (is_shortest_) return;
    const Node node = at(id);
    const Driven before = driven_to(node);
    const auto [sin, cos] = base::sin_cos(node.pose.heading);
    for (const auto& [segment, shape] : steps_[halvings_at(node.pose)]) {
      Driven driven = before;
      const double cost = drive_cost(connector_.rule(), std::span(&segment, 1), driven);
      const LocalPose pose({node.pose.x + cos * shape.x - sin * shape.y,
                            node.pose.y + sin * shape.x + cos * shape.y,
                            wrap_angle(node.pose.heading + shape.heading)});
      open({pose, segment, node.cost_to_come + cost, 0.0, id});
    }
  }

  // Whether it is proven that there is no path.
  [[nodiscard]] bool is_cut_off() const {
    return estimate_.is_admissible && std::isinf(estimate_.length(task_.start));
  }

  // The best path as a route: legs of as many steps as a piece holds, then the exact piece.
  [[nodiscard]] Route route() const {
    std::vector<std::int32_t> branch;
    for (std::int32_t id = found_.node; at(id).parent >= 0; id = at(id).parent) {
      branch.push_back(id);
    }
    Route route{task_.start, {}, 0.0};
    for (auto id = branch.rbegin(); id != branch.rend(); ++id) append(at(*id), route.legs);
    route.legs.push_back({found_.last, task_.goal});
    price(connector_, route);
    return route;
  }

  [[nodiscard]] Connector& connector() { return connector_; }
  [[nodiscard]] bool keeps_to_middle() const { return voronoi_weight_ > 0.0; }

  // Cost of a route plus its surcharge for leaving the middle between obstacles [m].
  [[nodiscard]] double measure(const Route& route) const {
    return cost_of(connector_.rule(), route) + aside(route.start, path_of(route).segments);
  }

  void report(PlannerAnswer& answer) {
    answer.counters = {{"nodes", static_cast<std::int64_t>(nodes_.size())},
                       {"expansions", expansions_},
                       {"shots", shots_},
                       {"exact_solves", connector_.solves()},
                       {"edge_checks", connector_.checks()}};
    if (keeps_tree_) answer.tree = std::move(tree_);
    if (!answer.segments || !estimate_.is_admissible) return;
    const double least = is_shortest_ ? found_.cost : estimate_.length(task_.start);
    if (!std::isfinite(least)) return;
    answer.lower_bound = least * (1 - rounding);
    const CostRule& rule = connector_.rule();
    if (rule.allows_both()) return;
    // The judge lets a path end slightly beside the goal, so it may be shorter by the leeway.
    const double leeway = search::open_ground(task_, rule).leeway;
    answer.lower_bound = std::min(*answer.lower_bound, estimate_.length(task_.start)) - leeway;
  }

 private:
  [[nodiscard]] const Node& at(std::int32_t id) const {
    return nodes_[static_cast<std::size_t>(id)];
  }

  [[nodiscard]] DrivenBeside ends() const { return {connector_.rule().initial_gear, {}}; }

  [[nodiscard]] double turn() const { return 2 * std::numbers::pi / headings_; }

  static void append(const Node& node, std::vector<Leg>& legs) {
    const auto goes_on = [&](const Segment& last) {
      return last.curvature == node.segment.curvature && last.length * node.segment.length > 0.0;
    };
    if (legs.empty() || legs.back().piece.count == segments_of_leg) legs.emplace_back();
    Piece& piece = legs.back().piece;
    if (piece.count > 0 && goes_on(piece.segments[piece.count - 1U])) {
      piece.segments[piece.count - 1U].length += node.segment.length;
    } else {
      piece.segments[piece.count++] = node.segment;
    }
    piece.length += std::abs(node.segment.length);
    legs.back().end = node.pose;
  }

  // Length of a step [m]: as wanted, or else out of the cell and a turn by whole heading cells.
  [[nodiscard]] double step_of(double wanted) const {
    const double unit = turn() * connector_.radius();
    const double least = wanted > 0.0 ? wanted : std::sqrt(2.0) * cell_;
    return wanted > 0.0 ? wanted : std::ceil(least / unit) * unit;
  }

  // Makes the steps of a halving: full lock to either side and straight on, in the allowed gears.
  void make_steps(int halvings) {
    const double step = std::ldexp(step_, -halvings);
    for (const double curvature : {1 / connector_.radius(), 0.0, -1 / connector_.radius()}) {
      for (const double length : {step, -step}) {
        const Segment segment{curvature, length};
        if (!connector_.rule().allows(gear_of(segment))) continue;
        steps_[static_cast<std::size_t>(halvings)].push_back({segment, advance(Pose{}, segment)});
      }
    }
  }

  // Number of halvings at a pose. Dolgov's step is a tenth of the room between obstacles, and from
  // 0.2 to 1 m long.
  [[nodiscard]] std::size_t halvings_at(const Pose& pose) const {
    if (!is_variable_) return 0;
    const auto [obstacle, middle] = voronoi_->at({pose.x, pose.y});
    const double wanted = std::clamp(0.1 * (obstacle + middle), 0.2, 1.0);
    return static_cast<std::size_t>(
        std::lround(std::min(-std::log2(wanted), double{most_halvings})));
  }

  [[nodiscard]] Driven driven_to(const Node& node) const {
    if (node.parent < 0) return connector_.rule().initial_gear;
    return last_driven(node.segment);
  }

  // Key of a node's cell. Headings count from the start's heading, so that arcs end in the middle
  // of a heading cell. Gear and steering side are part of the key if prices depend on them.
  [[nodiscard]] std::uint64_t key_of(const Node& node) const {
    const auto index = [](double value) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value)));
    };
    const CostRule& rule = connector_.rule();
    const double turned = wrap_angle(node.pose.heading - task_.start.heading) / turn();
    const std::uint64_t headings = static_cast<std::uint64_t>(headings_);
    const std::size_t halvings = halvings_at(node.pose);
    const double cell = std::ldexp(cell_, -static_cast<int>(halvings));
    std::uint64_t key = 4 + halvings;
    key = (key << 22) | (index((node.pose.x - task_.goal.x) / cell) & 0x3fffffU);
    key = (key << 22) | (index((node.pose.y - task_.goal.y) / cell) & 0x3fffffU);
    key = (key << 12) | (index(turned + 0.5 + headings_) % headings);
    const bool in_reverse = !rule.is_length() && node.segment.length < 0.0;
    key = (key << 1) | (in_reverse ? 1U : 0U);
    const double curvature = rule.curvature_change_cost > 0.0 ? node.segment.curvature : 0.0;
    return (key << 2) | (curvature > 0.0 ? 1U : curvature < 0.0 ? 2U : 0U);
  }

  [[nodiscard]] double to_go(const Node& node) {
    const double length = estimate_.length(node.pose);
    if (connector_.rule().is_length()) return length;
    return std::max(length, connector_.least_cost(node.pose, task_.goal, {driven_to(node), {}}));
  }

  // Surcharge along segments for leaving the middle between obstacles [m].
  [[nodiscard]] double aside(const Pose& from, std::span<const Segment> segments) const {
    if (voronoi_weight_ == 0.0) return 0.0;
    const double falloff = task_.vehicle.width;
    return voronoi_weight_ * voronoi_->along(from, segments, {falloff, reach_of_field * falloff});
  }

  // Steps [6] and [7]: adds a node unless its cell was reached at less cost, or the way is blocked.
  void open(Node node) {
    if (node.cost_to_come >= found_.cost) return;
    double& least = cells_.cost(key_of(node));
    if (node.cost_to_come >= least) return;
    const LocalPose& from = at(node.parent).pose;
    if (!connector_.is_free(from, node.segment)) return;
    node.cost_to_come += connector_.clearance_cost(from, std::span(&node.segment, 1)) +
                         aside(from, std::span(&node.segment, 1));
    if (node.cost_to_come >= least) return;
    node.to_go = to_go(node);
    if (!(node.cost_to_come + node.to_go < found_.cost)) return;  // drops infinite costs, too
    least = node.cost_to_come;
    open_.push({least + weight_ * node.to_go, static_cast<std::int32_t>(nodes_.size())});
    nodes_.push_back(node);
  }

  // Adds an expanded node to the tree of the answer.
  void keep(std::int32_t id) {
    place_.resize(nodes_.size(), -1);
    place_[static_cast<std::size_t>(id)] = static_cast<std::int32_t>(tree_.poses.size());
    const std::int32_t parent = at(id).parent;
    tree_.poses.push_back(at(id).pose);
    tree_.parents.push_back(parent < 0 ? -1 : place_[static_cast<std::size_t>(parent)]);
  }

  const Task& task_;
  Connector connector_;
  GoalEstimate estimate_;
  double cell_;
  int headings_;
  double step_;
  std::array<std::vector<Step>, most_halvings + 1> steps_;  // steps by the number of halvings
  std::optional<VoronoiField> voronoi_;
  bool is_variable_ = false;
  double weight_;
  double voronoi_weight_;
  double shot_spacing_;
  bool improves_;
  bool keeps_tree_;
  std::size_t max_nodes_;
  std::vector<Node> nodes_;
  std::priority_queue<Entry> open_;
  CellCosts cells_;
  Found found_;
  bool is_shortest_ = false;
  int until_shot_ = 0;
  std::int64_t shots_ = 0;
  std::int64_t expansions_ = 0;
  TreeSnapshot tree_;
  std::vector<std::int32_t> place_;  // position of each node in `tree_`; -1: none
};

// Step [8]: shortens the best path. With a Voronoi weight trials are compared by `measure`, and
// only the final cost is traced.
template <typename Trace>
std::vector<Segment> shortened(HybridAStarSearch& search, Budget& budget,
                               const PlanOptions& options, const Trace& trace) {
  const bool shortens = options.planner.flag("shorten") && !search.is_shortest();
  Route route = search.route();
  std::function<double(const Route&)> measure;
  if (search.keeps_to_middle()) {
    measure = [&](const Route& changed) { return search.measure(changed); };
    route.cost = measure(route);
  }
  anytime::Shortener shortener(search.connector(), std::move(route), options.budget.seed, measure);
  while (shortens && !shortener.is_stalled() && budget.next()) {
    if (shortener.step() && !measure) trace(shortener.route().cost);
  }
  if (measure) trace(cost_of(search.connector().rule(), shortener.route()));
  return merged(path_of(shortener.route()).segments);
}

}  // namespace

// Dolgov, Thrun, Montemerlo and Diebel 2010, with exact ends and edges.
//
//   [1] the start waits; with variable_step or voronoi_weight: find the middle between things
//   until nothing waits, the budget is spent or the tree is full:
//   [2]   node := the one that waits with the least cost-to-come + weight * estimate; end if a path
//         is known that costs no more than that
//   [3]   close its cell, unless another pose of that cell was expanded
//   [4]   now and then, the more often the nearer the goal is: try the exact way to the goal
//   [5]   from the node drive a step at full lock to either side or straight on, in both gears
//   [6]   drop where this leads if its cell was reached for less, or if the way is not free
//   [7]   else it waits, ranked by the estimate
//   [8] with shorten: cut the path short, until that brings next to nothing
PlannerAnswer plan(const Task& task, const PlanOptions& options) {
  PlannerAnswer answer;
  Budget budget(options.budget);
  HybridAStarSearch search(task, options);  // [1]
  const auto trace = [&](double cost) {
    answer.anytime.push_back({budget.elapsed(), budget.iterations(), cost});
  };
  while (!budget.is_interrupted() && search.prepare()) {
  }
  answer.status = PlanStatus::node_limit;
  answer.reason = "every cell that steps of this length lead to was searched";
  while (const std::optional<std::int32_t> node = search.next()) {  // [2] [3]
    if (search.is_full() || !budget.next()) {
      answer.status = search.is_full() ? PlanStatus::node_limit : budget.reason();
      answer.reason = search.is_full() ? "the search tree is full" : "";
      break;
    }
    const bool is_better = search.shoot(*node);  // [4]
    if (is_better && !search.keeps_to_middle()) trace(search.found().cost);
    search.expand(*node);  // [5] [6] [7]
  }
  if (search.found().node >= 0) {
    answer.status = PlanStatus::solved;
    answer.reason.clear();
    answer.segments = shortened(search, budget, options, trace);  // [8]
  } else if (answer.status == PlanStatus::node_limit && search.is_cut_off()) {
    answer.status = PlanStatus::no_path;
    answer.reason = "no way for the vehicle's width leads to the goal";
  }
  answer.iterations = budget.iterations();
  search.report(answer);
  return answer;
}

}  // namespace vandplan::hybrid
