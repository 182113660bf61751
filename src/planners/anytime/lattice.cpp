// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vandplan::anytime {
namespace {

constexpr double straight_cells = 1.5;  // length of a straight step [cells], which leaves its cell
/// Expanded poses for one exact path, with continuous curvature and a known route. Exact paths take
/// half of the time then, and one of a hundred is cheaper.
constexpr std::size_t continuous_shot = 4;
/// Cost-to-go within which exact paths are always tried [turning radii].
constexpr double always_shot = 2.0;

std::size_t slot_of(std::uint64_t key, std::size_t size) {
  return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15U) >> 20) & (size - 1);
}

/// Most locks to either side of straight: each lock is one more cell at every pose. In tight slots,
/// where fine searches look, two locks miss paths with fewer gear changes.
constexpr int max_locks = 3;
/// Most locks to either side in coarse searches, which find the first route where there is room.
constexpr int max_coarse_locks = 2;

/// Number of locks to either side that makes a clothoid from lock to lock about one step long.
int locks_for(const Connector& connector, double step, int headings) {
  if (connector.continuous() == nullptr) return 1;
  const double clothoid = 1 / (connector.radius() * connector.continuous()->curvature_rate());
  const double most =
      headings > coarse_to_fine[coarse_searches - 1].headings ? max_locks : max_coarse_locks;
  return static_cast<int>(std::clamp(std::round(clothoid / step), 1.0, most));
}

}  // namespace

Lattice::Lattice(const LocalPose& root, const LocalPose& target, const DrivenBeside& beside,
                 const LatticeOptions& options, const Guide& guide, Connector& connector)
    : connector_(connector),
      guide_(guide),
      options_(options),
      target_(target),
      beside_(beside),
      cutoff_(std::numeric_limits<double>::infinity()),
      step_length_(2 * std::numbers::pi / options.headings * connector.radius()),
      cell_(options.cell * connector.radius()),
      locks_(locks_for(connector, step_length_, options.headings)),
      closed_(1024, 0) {
  route_.start = root;
  open({root, {beside.before.is_known() ? beside.before.curvature : 0.0, 0.0}, 0.0, -1});
}

// Number of a node's cell; never 0, which marks a free slot.
std::uint64_t Lattice::key_of(const Node& node) const {
  const double turn = 2 * std::numbers::pi / options_.headings;
  const auto x = static_cast<std::int64_t>(std::floor((node.pose.x - target_.x) / cell_));
  const auto y = static_cast<std::int64_t>(std::floor((node.pose.y - target_.y) / cell_));
  const auto heading = static_cast<std::int64_t>(
      std::floor((wrap_angle(node.pose.heading - target_.heading) + std::numbers::pi) / turn));
  std::uint64_t key = 1;
  key = (key << 20) | (static_cast<std::uint64_t>(x) & 0xfffffU);
  key = (key << 20) | (static_cast<std::uint64_t>(y) & 0xfffffU);
  key = (key << 12) | (static_cast<std::uint64_t>(heading) & 0xfffU);
  const bool reverse = !connector_.rule().is_length() && node.segment.length < 0.0;
  key = (key << 1) | (reverse ? 1U : 0U);
  const bool is_continuous = connector_.continuous() != nullptr;
  if (connector_.rule().curvature_change_cost == 0.0 && !is_continuous) return key;
  const int lock = lock_of(last_driven(node.segment).curvature);
  return (key << 3) | static_cast<std::uint64_t>(lock + max_locks);
}

bool Lattice::is_closed(std::uint64_t key) const {
  std::size_t slot = slot_of(key, closed_.size());
  while (closed_[slot] != 0 && closed_[slot] != key) slot = (slot + 1) & (closed_.size() - 1);
  return closed_[slot] == key;
}

Driven Lattice::driven_to(const Node& node) const {
  if (node.parent < 0) return beside_.before;
  return last_driven(node.segment);
}

// Closes a cell. False if it was closed before.
bool Lattice::close(std::uint64_t key) {
  if (2 * closed_count_ >= closed_.size()) grow_table();
  std::size_t slot = slot_of(key, closed_.size());
  while (closed_[slot] != 0 && closed_[slot] != key) slot = (slot + 1) & (closed_.size() - 1);
  if (closed_[slot] == key) return false;
  closed_[slot] = key;
  ++closed_count_;
  return true;
}

void Lattice::grow_table() {
  std::vector<std::uint64_t> old(4 * closed_.size(), 0);
  old.swap(closed_);
  closed_count_ = 0;
  for (const std::uint64_t key : old) {
    if (key != 0) close(key);
  }
}

void Lattice::open(const Node& node) {
  const double around = guide_.at(node.pose.x, node.pose.y);
  if (node.cost_to_come + around >= cutoff_) return;
  const double rank = node.cost_to_come + options_.greediness * around;
  open_.push({rank, around, 0.0, static_cast<std::int32_t>(nodes_.size())});
  nodes_.push_back(node);
}

// Appends a step to the last leg of the route. A leg with continuous curvature ends where another
// piece may begin.
void Lattice::append(const Segment& step, const LocalPose& end) {
  if (connector_.continuous() == nullptr) return drive_on(route_.legs, step, end);
  const bool may_begin =
      is_straight(step.curvature) ||
      (!route_.legs.empty() &&
       connector_.may_jump(last_driven(route_.legs.back().piece), gear_of(step)));
  drive_on(route_.legs, step, end, SegmentRoom::size(), may_begin);
}

// Packs the steps to a node into legs and appends the exact path `last`.
void Lattice::build_route(std::int32_t node, const Piece& last) {
  std::vector<std::int32_t> branch;
  for (std::int32_t i = node; nodes_[static_cast<std::size_t>(i)].parent >= 0;
       i = nodes_[static_cast<std::size_t>(i)].parent) {
    branch.push_back(i);
  }
  route_.legs.clear();
  for (auto i = branch.rbegin(); i != branch.rend(); ++i) {
    const Node& step = nodes_[static_cast<std::size_t>(*i)];
    append(step.segment, step.pose);
  }
  route_.legs.push_back({last, target_});
  price(connector_, route_);
}

bool Lattice::is_straight(double curvature) const {
  return std::abs(curvature) * connector_.radius() < straight_wheels;
}

// The entry of least rank; none if none is left.
std::optional<Lattice::Entry> Lattice::next() {
  while (!open_.empty()) {
    Entry entry = open_.top();
    open_.pop();
    if (entry.open_ground > 0.0) return entry;
    const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
    entry.open_ground = connector_.least_cost(node.pose, target_, {driven_to(node), beside_.after});
    if (entry.open_ground <= entry.around) return entry;
    entry.rank = node.cost_to_come + options_.greediness * entry.open_ground;
    if (open_.empty() || open_.top() < entry) return entry;
    open_.push(entry);
  }
  return std::nullopt;
}

// Tries the exact path to the target. True when that gives a cheaper route.
bool Lattice::shoot(const Entry& entry) {
  const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
  const bool is_known = cutoff_ < std::numeric_limits<double>::infinity();
  const bool is_dear = connector_.continuous() != nullptr && is_known &&
                       entry.open_ground > always_shot * connector_.radius();
  if (is_dear && closed_count_ % continuous_shot != 0) return false;
  const std::optional<Connection> shot = connector_.connect(
      node.pose, target_, {node.cost_to_come, cutoff_, {driven_to(node), beside_.after}});
  if (!shot) return false;
  build_route(entry.node, shot->piece);
  cutoff_ = std::min(cutoff_, route_.cost);
  return true;
}

// A step to a side, or straight on for side 0: an arc at full lock, or a line. Where the curvature
// may not jump, it keeps its curvature or is a clothoid to the next lock.
std::optional<Segment> Lattice::step_from(const Node& node, int side, GearSign direction) const {
  const double arc = direction * step_length_;
  const double line = direction * straight_cells * cell_;
  const Driven before = driven_to(node);
  if (connector_.may_jump(before, direction)) {
    return Segment{side / connector_.radius(), side == 0 ? line : arc};
  }
  const double now = node.parent < 0 ? node.segment.curvature : before.curvature;
  const int lock = lock_of(now);
  const int next = std::clamp(lock + side, -locks_, locks_);
  const double wanted = next / (locks_ * connector_.radius());
  const double change = wanted - now;
  if (is_straight(change)) {
    if (side != 0) return std::nullopt;
    return Segment{wanted, next == 0 ? line : arc};
  }
  const double rate = connector_.continuous()->curvature_rate();
  return Segment{now, direction * std::abs(change) / rate, std::copysign(rate, change)};
}

// Number of the nearest lock: 0 is straight, `locks_` is full lock to the left.
int Lattice::lock_of(double curvature) const {
  return static_cast<int>(std::lround(curvature * connector_.radius() * locks_));
}

void Lattice::expand(std::int32_t id) {
  const Node node = nodes_[static_cast<std::size_t>(id)];
  const bool is_length = connector_.rule().is_length();
  const Driven before = driven_to(node);
  for (const int side : {1, 0, -1}) {
    for (const GearSign direction : {1, -1}) {
      if (!connector_.rule().allows(direction)) continue;
      const std::optional<Segment> step = step_from(node, side, direction);
      if (!step) continue;
      const Segment& segment = *step;
      const double stretch = std::abs(segment.length);
      const bool back = node.parent >= 0 && node.segment.curvature == segment.curvature &&
                        node.segment.curvature_rate == segment.curvature_rate &&
                        node.segment.length * segment.length < 0;
      if (back) continue;
      Node next{advance(node.pose, segment), segment, 0.0, id};
      if (is_closed(key_of(next))) continue;
      Driven last = before;
      next.cost_to_come =
          node.cost_to_come +
          (is_length ? stretch : drive_cost(connector_.rule(), std::span(&segment, 1), last));
      open(next);
    }
  }
}

// Adds the clearance cost of the step to a pose, which is known to be free. True if another entry
// comes first then.
bool Lattice::waits_for_cheaper(Entry entry) {
  Node& node = nodes_[static_cast<std::size_t>(entry.node)];
  node.is_free = true;
  const LocalPose& from = nodes_[static_cast<std::size_t>(node.parent)].pose;
  const double near = connector_.clearance_cost(from, std::span(&node.segment, 1));
  node.cost_to_come += near;
  entry.rank += near;
  if (near == 0.0 || open_.empty() || open_.top() < entry) return false;
  open_.push(entry);
  return true;
}

bool Lattice::step() {
  const std::optional<Entry> entry = next();
  if (!entry) return false;
  const Node& node = nodes_[static_cast<std::size_t>(entry->node)];
  if (node.cost_to_come + entry->open_ground >= cutoff_) return false;
  const std::uint64_t key = key_of(node);
  if (is_closed(key)) return false;
  if (node.parent >= 0 && !node.is_free) {
    const LocalPose& from = nodes_[static_cast<std::size_t>(node.parent)].pose;
    if (!connector_.is_free(from, node.segment)) return false;
    if (waits_for_cheaper(*entry)) return false;
  }
  close(key);
  const bool found = shoot(*entry);
  expand(entry->node);
  return found;
}

}  // namespace vandplan::anytime
