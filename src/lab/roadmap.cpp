// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/graphs.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <queue>
#include <span>
#include <tuple>
#include <utility>

#include "base/require.h"
#include "lab/milestones.h"
#include "vandplan/input_error.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Result of the collision check of an edge.
enum EdgeState : std::uint8_t { edge_unknown, edge_free, edge_blocked };

/// An edge as one of its ends sees it.
struct Arc {
  std::int32_t node;  ///< node at the other end
  std::int32_t edge;  ///< index of the edge
  double length;      ///< length of the edge [m]
};

}  // namespace

struct Roadmap::Data {
  class Query;

  explicit Data(const search::Milestones& milestones);

  [[nodiscard]] std::span<const Arc> arcs_of(std::int32_t node) const {
    const auto i = static_cast<std::size_t>(node);
    return std::span(arcs).subspan(first_arc[i], first_arc[i + 1] - first_arc[i]);
  }
  [[nodiscard]] const LocalPose& pose(std::int32_t node) const {
    return poses[static_cast<std::size_t>(node)];
  }
  [[nodiscard]] std::atomic<std::uint8_t>& state(std::int32_t edge) const {
    return states[static_cast<std::size_t>(edge)];
  }
  [[nodiscard]] bool may_drive(const LocalPose& from, const LocalPose& to) const {
    return checker->is_free(from, reeds_shepp(from, to, radius).view());
  }
  /// Whether the edge between nodes `a` and `b` is free. The first call checks it, always in the
  /// direction from the newer to the older node; later calls look the result up.
  [[nodiscard]] bool may_drive(std::int32_t edge, std::int32_t a, std::int32_t b) const;

  std::shared_ptr<const CollisionChecker> checker;
  double radius;  // turning radius [m]
  std::int64_t samples;
  std::size_t neighbours;
  std::vector<LocalPose> poses;
  NearestNodes nearest;
  std::vector<std::size_t> first_arc;  // position of each node's first arc, then their number
  std::vector<Arc> arcs;
  /// `EdgeState` of each edge. Every thread finds the same state, so threads need not wait.
  mutable std::vector<std::atomic<std::uint8_t>> states;
};

Roadmap::Data::Data(const search::Milestones& milestones)
    : checker(milestones.checker()),
      radius(milestones.radius()),
      samples(milestones.samples()),
      neighbours(static_cast<std::size_t>(milestones.options().neighbours)),
      poses(milestones.poses()),
      nearest(milestones.nearest()),
      first_arc(poses.size() + 1, 0),
      arcs(2 * milestones.edges().size()),
      states(milestones.edges().size()) {
  const auto for_edges = [&](auto visit) {
    for (std::size_t node = 0; node < poses.size(); ++node) {
      const auto [begin, end] =
          std::pair(milestones.first_edge()[node], milestones.first_edge()[node + 1]);
      for (std::int32_t edge = begin; edge < end; ++edge) {
        const auto [other, length] = milestones.edges()[static_cast<std::size_t>(edge)];
        const Arc to_older{other, edge, length};
        const Arc to_newer{static_cast<std::int32_t>(node), edge, length};
        visit(node, to_older);
        visit(static_cast<std::size_t>(other), to_newer);
      }
    }
  };
  for_edges([&](std::size_t node, const Arc&) { ++first_arc[node + 1]; });
  for (std::size_t i = 1; i < first_arc.size(); ++i) first_arc[i] += first_arc[i - 1];
  std::vector<std::size_t> next(first_arc.begin(), first_arc.end() - 1);
  for_edges([&](std::size_t node, const Arc& arc) { arcs[next[node]++] = arc; });
}

bool Roadmap::Data::may_drive(std::int32_t edge, std::int32_t a, std::int32_t b) const {
  if (const std::uint8_t known = state(edge).load(std::memory_order_relaxed);
      known != edge_unknown) {
    return known == edge_free;
  }
  const bool may = may_drive(pose(std::max(a, b)), pose(std::min(a, b)));
  state(edge).store(may ? edge_free : edge_blocked, std::memory_order_relaxed);
  return may;
}

// Searches the shortest way through a roadmap by A* with late edge checks: an edge is checked when
// the way over it is the best in the open list (Cohen, Phillips and Likhachev 2014).
//
//   [1] open := {from}, joined to its nearest milestones and to the goal
//   until open is empty:
//   [2]   take the way of least length + estimate out of open; leave it if its end was reached by a
//         way no longer, or if its last edge is not free
//   [3]   it reaches its end; if that is the goal: done
//   [4]   for each neighbour: add the way on to there to open, unless a free one is shorter
class Roadmap::Data::Query {
 public:
  Query(const Data& map, const LocalPose& from, const LocalPose& to, const RouteOptions& options)
      : map_(map),
        options_(options),
        from_(from),
        to_(to),
        start_(static_cast<std::int32_t>(map.poses.size())),
        goal_(start_ + 1),
        nodes_(map.poses.size() + 2) {
    const NearWanted wanted{.count = 2 * map.neighbours};
    from_start_ = map.nearest.nearest(from, wanted);
    from_start_.push_back({goal_, reeds_shepp_length(from, to, map.radius)});
    for (const NearNode& near : map.nearest.nearest(to, wanted))
      at(near.node).to_goal = near.length;
  }

  RoadmapAnswer run() {
    RoadmapAnswer answer;
    push({0.0, 0.0, start_, -1, -1});  // [1]
    while (!open_.empty()) {
      const Way way = open_.top();  // [2]
      open_.pop();
      if (way.length >= at(way.node).length || !is_way_free(way)) continue;
      at(way.node).length = way.length;  // [3]
      reached_.push_back({way.node, way.via});
      if (way.node == goal_) {
        answer.route = route(way.length);
        break;
      }
      expand(way);  // [4]
      if (reached_.size() % 256 == 0 && options_.is_interrupted && options_.is_interrupted()) break;
    }
    answer.expansions = static_cast<std::int64_t>(reached_.size());
    if (options_.keep_tree) answer.tree = tree();
    return answer;
  }

 private:
  struct Node {
    double estimate = -1.0;     // estimated length to the goal [m]; negative: not computed
    double to_goal = infinity;  // length of the node's own piece to the goal [m]; infinite: none
    double bound = infinity;    // least length of the ways here that are known to be free [m]
    double length = infinity;   // length of the way that reached the node [m]; infinite: none
  };

  /// A reached node, and the position of the previous node in `reached_`; -1: none.
  struct Reached {
    std::int32_t node, via;
  };

  /// A way in the open list, from the start to `node`.
  struct Way {
    double rank, length;           // length with and without the estimate [m]
    std::int32_t node, via, edge;  // `via`: in `reached_`; `edge` -1: a piece of its own
    /// A total order: the way that comes next does not depend on how the queue breaks ties.
    bool operator<(const Way& other) const {
      return std::tie(other.rank, other.length, other.node, other.via) <
             std::tie(rank, length, node, via);
    }
  };

  Node& at(std::int32_t node) { return nodes_[static_cast<std::size_t>(node)]; }

  const LocalPose& pose(std::int32_t node) const {
    return node == start_ ? from_ : node == goal_ ? to_ : map_.pose(node);
  }

  double estimate(std::int32_t node) {
    double& known = at(node).estimate;
    if (known < 0.0) {
      known = options_.estimate ? options_.estimate(pose(node))
                                : reeds_shepp_length(pose(node), to_, map_.radius);
    }
    return known;
  }

  void push(Way way) {
    way.rank = way.length + estimate(way.node);
    if (way.rank < infinity) open_.push(way);
  }

  bool is_way_free(const Way& way) const {
    if (way.via < 0) return true;
    const std::int32_t from = reached_[static_cast<std::size_t>(way.via)].node;
    if (way.edge >= 0) return map_.may_drive(way.edge, from, way.node);
    return map_.may_drive(pose(from), pose(way.node));
  }

  void expand(const Way& way) {
    const auto here = static_cast<std::int32_t>(reached_.size()) - 1;
    if (way.node == start_) {
      for (const auto& [node, length] : from_start_) push({0.0, length, node, here, -1});
      return;
    }
    if (const double last = at(way.node).to_goal; last < infinity) {
      push({0.0, way.length + last, goal_, here, -1});
    }
    for (const Arc& arc : map_.arcs_of(way.node)) {
      Node& next = at(arc.node);
      const double length = way.length + arc.length;
      if (length >= next.length || length > next.bound) continue;
      const std::uint8_t known = map_.state(arc.edge).load(std::memory_order_relaxed);
      if (known == edge_blocked) continue;
      if (known == edge_free) next.bound = length;
      push({0.0, length, arc.node, here, arc.edge});
    }
  }

  RoadmapRoute route(double length) const {
    RoadmapRoute route{.length = length};
    auto last = static_cast<std::int32_t>(reached_.size()) - 1;
    for (; last >= 0; last = reached_[static_cast<std::size_t>(last)].via) {
      route.poses.push_back(pose(reached_[static_cast<std::size_t>(last)].node));
    }
    std::reverse(route.poses.begin(), route.poses.end());
    for (std::size_t i = 1; i < route.poses.size(); ++i) {
      const Piece piece = reeds_shepp(route.poses[i - 1], route.poses[i], map_.radius);
      route.segments.insert(route.segments.end(), piece.view().begin(), piece.view().end());
    }
    route.segments = merged(route.segments);
    return route;
  }

  TreeSnapshot tree() const {
    TreeSnapshot tree;
    for (const auto& [node, via] : reached_) {
      tree.poses.push_back(pose(node));
      tree.parents.push_back(via);
    }
    return tree;
  }

  const Data& map_;
  const RouteOptions& options_;
  LocalPose from_, to_;
  std::int32_t start_, goal_;
  std::vector<Node> nodes_;           // milestones, then start and goal
  std::vector<NearNode> from_start_;  // ends of the pieces from the start
  std::priority_queue<Way> open_;
  std::vector<Reached> reached_;  // reached nodes in their order
};

Roadmap::Roadmap(const search::Milestones& milestones, const Roadmap* earlier)
    : data_(std::make_unique<const Data>(milestones)) {
  if (earlier == nullptr) return;
  const auto& known = earlier->data_->states;
  for (std::size_t i = 0; i < known.size(); ++i) {
    data_->states[i].store(known[i].load(std::memory_order_relaxed), std::memory_order_relaxed);
  }
}

Roadmap::~Roadmap() = default;
Roadmap::Roadmap(Roadmap&& other) noexcept = default;
Roadmap& Roadmap::operator=(Roadmap&& other) noexcept = default;

RoadmapAnswer Roadmap::route(const LocalPose& from, const LocalPose& to,
                             const RouteOptions& options) const {
  return Data::Query(*data_, from, to, options).run();
}

void Roadmap::check_edges() const {
  for (std::int32_t node = 0; node < static_cast<std::int32_t>(data_->poses.size()); ++node) {
    for (const Arc& arc : data_->arcs_of(node)) (void)data_->may_drive(arc.edge, node, arc.node);
  }
}

std::int64_t Roadmap::nodes() const noexcept {
  return static_cast<std::int64_t>(data_->poses.size());
}

std::int64_t Roadmap::edges() const noexcept {
  return static_cast<std::int64_t>(data_->states.size());
}

std::int64_t Roadmap::samples() const noexcept { return data_->samples; }

namespace {

void expect_in_range(const char* option, double value, double least, double most) {
  base::require(value >= least && value <= most, option, value,
                base::shortest_text(least) + " to " + base::shortest_text(most));
}

}  // namespace

Roadmap build_roadmap(const World& world, const Vehicle& vehicle, const RoadmapOptions& options) {
  constexpr std::int64_t most_in_vain = 1'000'000;  // blocked poses in a row
  expect_in_range("nodes", static_cast<double>(options.nodes), 1, 1e6);
  expect_in_range("neighbours", options.neighbours, 1, 100);
  expect_in_range("margin", options.margin, 0, 1000);
  if (vehicle.trailer) throw InputError("vehicle.trailers", "are not honoured, expected none");
  const Local<Bounds> region = options.region.value_or(Local(world.local().bounds));
  search::Milestones milestones(world.checker(vehicle, {.wanted = options.margin}),
                                vehicle.min_turning_radius,
                                {region, options.neighbours, options.seed});
  std::int64_t in_vain = 0;
  while (static_cast<std::int64_t>(milestones.size()) < options.nodes) {
    const std::size_t before = milestones.size();
    milestones.sample();
    in_vain = milestones.size() > before ? 0 : in_vain + 1;
    if (in_vain == most_in_vain) throw InputError("region", "has no free poses");
  }
  return Roadmap(milestones);
}

}  // namespace vandplan
