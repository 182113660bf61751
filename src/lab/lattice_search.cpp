// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/lattice_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/estimate_options.h"
#include "vandplan/steering.h"

namespace vandplan::lattice {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::int32_t border = 1 << 23;      // largest |x| and |y| of a vertex [steps]
constexpr std::size_t first_slots = 1 << 12;  // slots of the hash table at first
constexpr int most_looks = 32;                // blocked edges in one step
constexpr double shot_spacing = 2.0;  // distance to go per expansion between shots [turning radii]

std::size_t hash_of(const Vertex& v) {
  std::uint64_t key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(v.x)) << 40) ^
                      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(v.y)) << 12) ^
                      static_cast<std::uint64_t>(v.heading);
  key *= 0x9e3779b97f4a7c15U;
  return static_cast<std::size_t>(key ^ (key >> 32));
}

}  // namespace

double length_on_open_ground(const Task& task) {
  constexpr double slack = 1e-9;  // relative rounding error
  return (1 - slack) * reeds_shepp_length(task.start, task.goal, task.vehicle.min_turning_radius);
}

LatticeSearch::LatticeSearch(const Task& task, const Ground& ground, Connector& connector,
                             const Settings& settings)
    : task_(task),
      graph_(*ground.graph),
      guide_(ground.guide),
      connector_(connector),
      settings_(settings),
      joints_(graph_.joints(task.start)),
      slots_(first_slots, -1) {
  if (settings_.keep_tree) tree_ = {{task.start}, {-1}};
  if (settings_.shots) {
    const std::optional<Connection> shot = connector.connect(task.start, task.goal);
    ++shots_;
    if (shot) take({{shot->piece, task.goal}});
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    open(joints_[i].vertex, joints_[i].piece.length, -1, static_cast<std::int32_t>(i));
  }
}

void LatticeSearch::grow_slots() {
  slots_.assign(4 * slots_.size(), -1);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    std::size_t slot = hash_of(nodes_[i].vertex) & (slots_.size() - 1);
    while (slots_[slot] >= 0) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = static_cast<Id>(i);
  }
}

LatticeSearch::Id LatticeSearch::node_at(const Vertex& vertex) {
  if (2 * nodes_.size() >= slots_.size()) grow_slots();
  std::size_t slot = hash_of(vertex) & (slots_.size() - 1);
  while (slots_[slot] >= 0) {
    if (node(slots_[slot]).vertex == vertex) return slots_[slot];
    slot = (slot + 1) & (slots_.size() - 1);
  }
  slots_[slot] = static_cast<Id>(nodes_.size());
  nodes_.push_back({.vertex = vertex, .to_go = guide_.length(vertex)});
  return slots_[slot];
}

void LatticeSearch::push(Id id) {
  const double cost = edge(node(id).waiting).cost;
  open_.push({cost + settings_.weight * node(id).to_go, cost, id});
}

void LatticeSearch::open(const Vertex& vertex, double cost, Id parent, std::int32_t via) {
  if (std::max(std::abs(vertex.x), std::abs(vertex.y)) >= border) return;
  const Id id = node_at(vertex);
  Node& end = node(id);
  if (cost >= end.cost || cost + end.to_go >= best_) return;
  const auto added = static_cast<std::int32_t>(edges_.size());
  if (end.waiting >= 0 && edge(end.waiting).cost <= cost) {
    edges_.push_back({cost, parent, via, edge(end.waiting).next});
    edge(end.waiting).next = added;
    return;
  }
  edges_.push_back({cost, parent, via, end.waiting});
  end.waiting = added;
  if (end.round != round_) push(id);
}

// Drops the cheapest edge to a vertex. The next cheapest one becomes the first of the list.
void LatticeSearch::drop_cheapest(Id id) {
  Node& end = node(id);
  end.waiting = edge(end.waiting).next;
  if (end.waiting < 0) return;
  std::int32_t least = end.waiting;
  for (std::int32_t i = end.waiting; i >= 0; i = edge(i).next) {
    if (edge(i).cost < edge(least).cost) least = i;
  }
  Edge& first = edge(end.waiting);
  Edge& cheapest = edge(least);
  std::swap(first.cost, cheapest.cost);
  std::swap(first.parent, cheapest.parent);
  std::swap(first.via, cheapest.via);
}

bool LatticeSearch::may_improve(const Node& end) const {
  if (end.waiting < 0) return false;
  const double cost = edge(end.waiting).cost;
  return cost < end.cost && cost + end.to_go < best_;
}

bool LatticeSearch::has_next() {
  while (!open_.empty()) {
    const Entry& entry = open_.top();
    if (entry.rank >= best_) return false;
    const Node& end = node(entry.node);
    if (end.round != round_ && may_improve(end) && entry.cost == edge(end.waiting).cost)
      return true;
    open_.pop();
  }
  return false;
}

bool LatticeSearch::is_free(Node& end, const Edge& edge) {
  const LocalPose pose = graph_.pose_of(end.vertex);
  if (!end.is_free) {
    end.is_free = connector_.is_free(pose);
    if (!end.is_free) end.cost = -infinity;  // no edge to this vertex is checked again
  }
  if (!end.is_free) return false;
  const LocalPose from = edge.parent < 0 ? task_.start : graph_.pose_of(node(edge.parent).vertex);
  return connector_.is_free(from, piece_of(edge.parent, edge.via));
}

bool LatticeSearch::step() {
  for (int looks = 0; looks < most_looks && has_next(); ++looks) {
    const double before = best_;
    if (look()) return best_ < before;
  }
  return false;
}

// Checks the next edge. True if it is free: then its end is closed and expanded.
bool LatticeSearch::look() {
  const Id id = open_.top().node;
  open_.pop();
  Node& end = node(id);
  const Edge last = edge(end.waiting);
  if (!is_free(end, last)) {
    drop_cheapest(id);
    if (may_improve(end)) push(id);
    return false;
  }
  end.waiting = -1;
  end.cost = last.cost;
  end.parent = last.parent;
  end.via = last.via;
  end.round = round_;
  if (settings_.keep_tree) show(id);
  if (end.vertex == graph_.goal()) {
    take(way_to(id));
    return true;
  }
  if (settings_.shots) shoot(id);
  expand(id);
  return true;
}

const Piece& LatticeSearch::piece_of(Id parent, std::int32_t via) const {
  return parent < 0 ? joints_[static_cast<std::size_t>(via)].piece : graph_.piece(via);
}

void LatticeSearch::expand(Id id) {
  ++expansions_;
  const Node begin = node(id);
  std::int32_t via = graph_.first_move(begin.vertex.heading);
  for (const LatticeGraph::Move& move : graph_.moves(begin.vertex.heading)) {
    const Vertex next{begin.vertex.x + move.dx, begin.vertex.y + move.dy, move.to};
    open(next, begin.cost + move.length, id, via++);
  }
}

// Tries the exact piece from a vertex to the goal, the more often the nearer the goal is.
void LatticeSearch::shoot(Id id) {
  if (expansions_ < next_shot_) return;
  const Node& begin = node(id);
  const double wait = begin.to_go / (shot_spacing * connector_.radius());
  next_shot_ = expansions_ + 1 + static_cast<std::int64_t>(std::min(wait, 1e6));
  ++shots_;
  const std::optional<Connection> shot =
      connector_.connect(graph_.pose_of(begin.vertex), task_.goal, {begin.cost, best_, {}});
  if (!shot) return;
  std::vector<Leg> way = way_to(id);
  way.push_back({shot->piece, task_.goal});
  take(std::move(way));
}

void LatticeSearch::take(std::vector<Leg> way) {
  const double length = length_of(way);  // sum, as parents may have become cheaper
  if (length >= best_) return;
  best_ = length;
  best_way_ = std::move(way);
}

void LatticeSearch::begin_round(double weight) {
  settings_.weight = weight;
  ++round_;
  open_ = {};
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (may_improve(nodes_[i])) push(static_cast<Id>(i));
  }
}

double LatticeSearch::lattice_bound() const {
  double least = best_;
  for (const Node& end : nodes_) {
    if (may_improve(end)) least = std::min(least, edge(end.waiting).cost + end.to_go);
  }
  return least;
}

std::optional<LatticeSearch::Id> LatticeSearch::front() const {
  if (open_.empty()) return std::nullopt;
  const Id parent = edge(node(open_.top().node).waiting).parent;
  return parent < 0 ? std::nullopt : std::optional<Id>(parent);
}

std::vector<Leg> LatticeSearch::way_to(Id id) const {
  std::vector<Leg> way;
  while (id >= 0) {
    const Node& end = node(id);
    way.push_back({piece_of(end.parent, end.via), graph_.pose_of(end.vertex), id});
    id = end.parent;
  }
  std::ranges::reverse(way);
  return way;
}

void LatticeSearch::show(Id id) {
  Node& end = node(id);
  end.shown = static_cast<std::int32_t>(tree_.poses.size());
  tree_.poses.push_back(graph_.pose_of(end.vertex));
  tree_.parents.push_back(end.parent < 0 ? 0 : node(end.parent).shown);
}

void LatticeSearch::report(PlannerAnswer& answer) const {
  answer.counters = {{"nodes", static_cast<std::int64_t>(nodes_.size())},
                     {"expansions", expansions_},
                     {"exact_solves", connector_.solves()},
                     {"edge_checks", connector_.checks()},
                     {"shots", shots_},
                     {"joints", static_cast<std::int64_t>(joints_.size())}};
  if (settings_.keep_tree) answer.tree = tree_;
}

std::vector<Segment> segments_of(const std::vector<Leg>& way) {
  std::vector<Segment> segments;
  for (const Leg& leg : way) {
    segments.insert(segments.end(), leg.piece.view().begin(), leg.piece.view().end());
  }
  return merged(segments);
}

double length_of(const std::vector<Leg>& way) {
  double sum = 0.0;
  for (const Leg& leg : way) sum += leg.piece.length;
  return sum;
}

}  // namespace vandplan::lattice
