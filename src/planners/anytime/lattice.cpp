// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vandplan::anytime {
namespace {

constexpr double hopeless_shot = 1.2;   // ways around that are longer than the shot by this
constexpr double guide_trust = 0.9;     // of a way around on the grid, which is no bound
constexpr double straight_cells = 1.5;  // length of a straight step: it leaves its cell
constexpr int looks = 8;                // at open ground, for one entry

std::size_t slot_of(std::uint64_t key, std::size_t size) {
  return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15U) >> 20) & (size - 1);
}

}  // namespace

Lattice::Lattice(const Pose& root, const Pose& target, const LatticeOptions& options,
                 const GridDistance& guide, Connector& connector)
    : connector_(connector),
      guide_(guide),
      options_(options),
      target_(target),
      cutoff_(std::numeric_limits<double>::infinity()),
      step_length_(2 * std::numbers::pi / options.headings * connector.radius()),
      cell_(options.cell * connector.radius()),
      closed_(1024, 0) {
  route_.start = root;
  open({root, {}, 0.0, -1});
}

// Never 0, which marks a free slot.
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
  if (connector_.rule().curvature_change_cost == 0.0) return key;
  const double curvature = node.segment.curvature;
  return (key << 2) | (curvature > 0.0 ? 2U : curvature < 0.0 ? 1U : 0U);
}

bool Lattice::is_closed(std::uint64_t key) const {
  std::size_t slot = slot_of(key, closed_.size());
  while (closed_[slot] != 0 && closed_[slot] != key) slot = (slot + 1) & (closed_.size() - 1);
  return closed_[slot] == key;
}

Driven Lattice::driven_to(const Node& node) const {
  if (node.parent < 0) return connector_.rule().initial_gear;
  return last_driven(node.segment);
}

// False if it was closed before.
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

void Lattice::push(const Entry& entry) {
  open_.push_back(entry);
  std::push_heap(open_.begin(), open_.end());
}

Lattice::Entry Lattice::pop() {
  std::pop_heap(open_.begin(), open_.end());
  const Entry entry = open_.back();
  open_.pop_back();
  return entry;
}

void Lattice::open(const Node& node) {
  const double around = guide_.at(node.pose.x, node.pose.y);
  if (node.cost_to_come + guide_trust * around >= cutoff_) return;
  const double rank = node.cost_to_come + options_.greediness * around;
  push({rank, around, 0.0, static_cast<std::int32_t>(nodes_.size())});
  nodes_.push_back(node);
}

// Packs the steps into pieces and appends the last one.
void Lattice::build_route(std::int32_t node, const Piece& last) {
  std::vector<std::int32_t> branch;
  for (std::int32_t i = node; nodes_[static_cast<std::size_t>(i)].parent >= 0;
       i = nodes_[static_cast<std::size_t>(i)].parent) {
    branch.push_back(i);
  }
  route_.legs.clear();
  for (auto i = branch.rbegin(); i != branch.rend(); ++i) {
    const Node& step = nodes_[static_cast<std::size_t>(*i)];
    if (route_.legs.empty()) route_.legs.push_back({});
    Piece* piece = &route_.legs.back().piece;
    Segment* segment = piece->count > 0 ? &piece->segments[piece->count - 1U] : nullptr;
    if (segment != nullptr && segment->curvature == step.segment.curvature &&
        segment->length * step.segment.length > 0) {
      segment->length += step.segment.length;
    } else {
      if (piece->count == 5) {
        route_.legs.push_back({});
        piece = &route_.legs.back().piece;
      }
      piece->segments[piece->count++] = step.segment;
    }
    piece->length += std::abs(step.segment.length);
    route_.legs.back().end = step.pose;
  }
  route_.legs.push_back({last, target_});
  price(connector_, route_);
}

// The entry whose turn it is, if that is found out with a few looks at open ground.
std::optional<Lattice::Entry> Lattice::next() {
  for (int i = 0; i < looks && !open_.empty(); ++i) {
    Entry entry = pop();
    if (entry.open_ground > 0.0) return entry;
    const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
    entry.open_ground = connector_.least_cost(node.pose, target_, {driven_to(node), 0});
    if (entry.open_ground <= entry.around) return entry;
    entry.rank = node.cost_to_come + options_.greediness * entry.open_ground;
    if (open_.empty() || open_.front() < entry) return entry;
    push(entry);
  }
  return std::nullopt;
}

// Tries the exact path to the target, unless obstacles make the way much longer. True when that
// gives a cheaper route.
bool Lattice::shoot(const Entry& entry) {
  if (entry.around > hopeless_shot * entry.open_ground + cell_) return false;
  const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
  const std::optional<Connection> shot =
      connector_.connect(node.pose, target_, {node.cost_to_come, cutoff_, {driven_to(node), 0}});
  if (!shot) return false;
  build_route(entry.node, shot->piece);
  cutoff_ = std::min(cutoff_, route_.cost);
  return true;
}

void Lattice::expand(std::int32_t id) {
  const Node node = nodes_[static_cast<std::size_t>(id)];
  const bool is_length = connector_.rule().is_length();
  const Driven before = driven_to(node);
  for (const double side : {1.0, 0.0, -1.0}) {
    for (const double direction : {1.0, -1.0}) {
      const double stretch = side == 0.0 ? straight_cells * cell_ : step_length_;
      const Segment segment{side / connector_.radius(), direction * stretch};
      const bool back = node.parent >= 0 && node.segment.curvature == segment.curvature &&
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

// Adds what being near things costs on the way to a pose, which is known to be free. True if it is
// no longer the first one then.
bool Lattice::waits_for_cheaper(Entry entry) {
  Node& node = nodes_[static_cast<std::size_t>(entry.node)];
  node.is_free = true;
  if (options_.overlooks_clearance) return false;
  const Pose& from = nodes_[static_cast<std::size_t>(node.parent)].pose;
  const double near = connector_.clearance_cost(from, std::span(&node.segment, 1));
  node.cost_to_come += near;
  entry.rank += near;
  if (near == 0.0 || open_.empty() || open_.front() < entry) return false;
  push(entry);
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
    const Pose& from = nodes_[static_cast<std::size_t>(node.parent)].pose;
    if (!connector_.is_free(from, node.segment)) return false;
    if (waits_for_cheaper(*entry)) return false;
  }
  close(key);
  const bool found = shoot(*entry);
  expand(entry->node);
  return found;
}

}  // namespace vandplan::anytime
