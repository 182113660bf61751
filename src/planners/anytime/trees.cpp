// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/trees.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "vandplan/random.h"

namespace vandplan::anytime {
namespace {

constexpr std::size_t ranked = 8;  // nodes whose exact length is looked at for one sample
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int connect_tries = 3;  // ranked nodes from which an edge is tried
/// Least length of an edge that is cut short [turning radii].
constexpr double least_extension = 0.1;

}  // namespace

TwoTrees::TwoTrees(const Task& task, const Bounds& region, Connector& forth, Connector& back,
                   double far_share, std::uint64_t seed)
    : radius_(forth.radius()),
      rule_(forth.rule()),
      region_(region),
      far_share_(far_share),
      rng_(seed),
      sides_{Side{Tree(task.start, 64), {Piece{}}, forth},
             Side{Tree(task.goal, 64), {Piece{}}, back}} {
  nearest_.reserve(ranked + 1);
}

// A far sample: half of them from the region, half around the middle between the roots, at several
// scales. Most ways around obstacles are as far away as the roots are from each other.
LocalPose TwoTrees::sample_far() {
  if (uniform01(rng_) < 0.5) return uniform_pose(region_, rng_);
  const LocalPose& a = sides_[0].tree.pose(0);
  const LocalPose& b = sides_[1].tree.pose(0);
  const double apart = std::max(std::hypot(a.x - b.x, a.y - b.y), radius_);
  const double reach = apart * std::exp2(uniform(-1.0, 1.5, rng_));
  const Pose pose = uniform_pose({-reach, reach, -reach, reach}, rng_);
  return Local(Pose{(a.x + b.x) / 2 + pose.x, (a.y + b.y) / 2 + pose.y, pose.heading});
}

// A near sample: around one of the two roots, at several scales, because narrow places are there.
LocalPose TwoTrees::sample_near() {
  const std::size_t side = uniform01(rng_) < 0.5 ? 0 : 1;
  const LocalPose& root = sides_[side].tree.pose(0);
  const double reach = radius_ * std::exp2(uniform(-2.0, 2.5, rng_));
  const Pose pose = uniform_pose({-reach, reach, -reach, reach}, rng_);
  return Local(Pose{root.x + pose.x, root.y + pose.y, pose.heading});
}

// Fills `nearest_` with the edges from the nodes that are nearest by a rough measure, the shortest
// edge first.
void TwoTrees::rank(Side& side, const LocalPose& target) {
  const Tree& tree = side.tree;
  struct Candidate {
    float rank;
    NodeId id;
  };
  std::array<Candidate, ranked> best;
  std::size_t count = 0;
  const auto x = static_cast<float>(target.x);
  const auto y = static_cast<float>(target.y);
  const auto heading = static_cast<float>(wrap_angle(target.heading));
  const auto radius = static_cast<float>(radius_);
  constexpr auto pi = std::numbers::pi_v<float>;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const float dx = tree.x()[i] - x;
    const float dy = tree.y()[i] - y;
    float turn = std::abs(tree.heading()[i] - heading);
    turn = std::min(turn, 2 * pi - turn) * radius;
    const float rank = dx * dx + dy * dy + turn * turn;
    if (count == ranked && rank >= best[ranked - 1].rank) continue;
    std::size_t j = count < ranked ? count++ : ranked - 1;
    for (; j > 0 && best[j - 1].rank > rank; --j) best[j] = best[j - 1];
    best[j] = {rank, static_cast<NodeId>(i)};
  }
  nearest_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<Piece> piece = side.connector.steer(tree.pose(best[i].id), target);
    if (piece) nearest_.push_back({best[i].id, *piece});
  }
  std::sort(nearest_.begin(), nearest_.end(), [](const Edge& a, const Edge& b) {
    return a.piece.length != b.piece.length ? a.piece.length < b.piece.length : a.from < b.from;
  });
}

NodeId TwoTrees::add(Side& side, NodeId parent, const Piece& piece, const LocalPose& end) {
  side.pieces.push_back(piece);
  return side.tree.add(end, parent, side.tree.cost_to_come(parent) + piece.length);
}

// Drives from the nearest node towards the target as far as that is free. The new node; -1 if the
// edge is too short.
NodeId TwoTrees::extend(Side& side, const LocalPose& target) {
  rank(side, target);
  if (nearest_.empty()) return -1;
  const auto [from, piece] = nearest_.front();
  const LocalPose& pose = side.tree.pose(from);
  if (side.connector.is_free(pose, piece)) return add(side, from, piece, target);
  const Piece part = side.connector.free_prefix(pose, piece);
  if (part.length < least_extension * radius_) return -1;
  return add(side, from, part, end_of(pose, part));
}

// Tries to join a new node to the other tree.
bool TwoTrees::connect(std::size_t from_side, NodeId node) {
  Side& own = sides_[from_side];
  Side& other = sides_[1 - from_side];
  const LocalPose target = own.tree.pose(node);
  rank(other, target);
  for (std::size_t i = 0; i < std::min<std::size_t>(connect_tries, nearest_.size()); ++i) {
    const auto& [from, piece] = nearest_[i];
    if (!other.connector.is_free(other.tree.pose(from), piece)) continue;
    if (from_side == 0) {
      join(node, from, reversed(piece));
    } else {
      join(from, node, piece);
    }
    return true;
  }
  return false;
}

void TwoTrees::join(NodeId from_start, NodeId from_goal, const Piece& bridge) {
  const Side& start = sides_[0];
  const Side& goal = sides_[1];
  route_ = {start.tree.pose(0), {}, 0.0};
  for (NodeId i = from_start; i > 0; i = start.tree.parent(i)) {
    route_.legs.push_back({start.pieces[static_cast<std::size_t>(i)], start.tree.pose(i)});
  }
  std::reverse(route_.legs.begin(), route_.legs.end());
  route_.legs.push_back({bridge, goal.tree.pose(from_goal)});
  for (NodeId i = from_goal; i > 0; i = goal.tree.parent(i)) {
    const Piece& piece = goal.pieces[static_cast<std::size_t>(i)];
    route_.legs.push_back({reversed(piece), goal.tree.pose(goal.tree.parent(i))});
  }
  route_.cost = cost_of(rule_, route_);
}

// The edge to the target from one of the two nearest nodes by Euclidean distance, if it is free.
std::optional<TwoTrees::Edge> TwoTrees::reach(Side& side, const LocalPose& target) {
  const Tree& tree = side.tree;
  std::array<NodeId, 2> ids{-1, -1};
  std::array<float, 2> distances{infinity, infinity};
  const auto x = static_cast<float>(target.x);
  const auto y = static_cast<float>(target.y);
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const float dx = tree.x()[i] - x;
    const float dy = tree.y()[i] - y;
    const float distance = dx * dx + dy * dy;
    if (distance < distances[0]) {
      ids = {static_cast<NodeId>(i), ids[0]};
      distances = {distance, distances[0]};
    } else if (distance < distances[1]) {
      ids[1] = static_cast<NodeId>(i);
      distances[1] = distance;
    }
  }
  for (const NodeId id : ids) {
    if (id < 0) break;
    const std::optional<Piece> piece = side.connector.steer(tree.pose(id), target);
    if (piece && side.connector.is_free(tree.pose(id), *piece)) return Edge{id, *piece};
  }
  return std::nullopt;
}

// A sample that both trees reach joins them; one that one of them reaches becomes its node.
bool TwoTrees::step_far() {
  const LocalPose target = sample_far();
  const std::optional<Edge> from_start = reach(sides_[0], target);
  const std::optional<Edge> from_goal = reach(sides_[1], target);
  if (from_start) {
    const NodeId node = add(sides_[0], from_start->from, from_start->piece, target);
    if (from_goal) join(node, from_goal->from, reversed(from_goal->piece));
  } else if (from_goal) {
    add(sides_[1], from_goal->from, from_goal->piece, target);
  }
  return from_start && from_goal;
}

// Drives one tree towards a near sample as far as that is free, then the other tree towards its new
// node.
bool TwoTrees::step_near() {
  const std::size_t side = turn_;
  turn_ = 1 - turn_;
  const LocalPose target = sample_near();
  const NodeId node = extend(sides_[side], target);
  if (node < 0) return false;
  if (connect(side, node)) return true;
  if (nearest_.empty()) return false;
  // The other tree keeps the free part of its shortest edge.
  Side& other = sides_[1 - side];
  const auto [from, piece] = nearest_.front();
  const LocalPose& pose = other.tree.pose(from);
  const Piece part = other.connector.free_prefix(pose, piece);
  if (part.length >= least_extension * radius_) add(other, from, part, end_of(pose, part));
  return false;
}

bool TwoTrees::step() { return uniform01(rng_) < far_share_ ? step_far() : step_near(); }

}  // namespace vandplan::anytime
