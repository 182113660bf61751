// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/taut_ways.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace vandplan::search {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int cells_per_work = 16;  // Cells whose look-up takes as long as a node.
constexpr std::size_t max_nodes = 400000;

double distance(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

double way_to_interval(const TautWays::Node& node) {
  const auto& [left, right, turns_left, turns_right] = node.interval;
  const Point nearest{std::clamp(node.root.x, left, right), static_cast<double>(node.line)};
  return node.cost + distance(node.root, nearest);
}

}  // namespace

TautWays::TautWays(OpenRows lattice, const Point& start, const Point& goal,
                   std::optional<double> longest)
    : lattice_(std::move(lattice)), longest_(longest) {
  const auto in_lattice = [&](const Point& point) {  // Clamped, as rounding may lead outside.
    return Point{std::clamp(point.x, 0.0, lattice_.columns() + 0.0),
                 std::clamp(point.y, 0.0, lattice_.rows() + 0.0)};
  };
  start_ = in_lattice(start);
  goal_ = in_lattice(goal);
  const std::optional<RunId> first = run_at(start_);
  const std::optional<RunId> last = run_at(goal_);
  assert(first && last);
  if (!first || !last) return;
  start_run_ = *first;
  goal_run_ = *last;
  spread(start_, 0.0, start_run_, {-1, -1});
}

std::optional<TautWays::Node> TautWays::take() {
  if (open_.empty() || is_full()) return std::nullopt;
  const Node node = open_.top();
  open_.pop();
  ++work_;
  return node;
}

bool TautWays::is_full() const noexcept { return open_.size() > max_nodes; }

bool TautWays::is_current(const Node& node) {
  return node.cost == 0.0 || reaches(node.root, node.cost);
}

std::optional<TautWays::RunId> TautWays::run_at(const Point& point) {
  if (!(point.x >= 0 && point.y >= 0 && point.x <= lattice_.columns() &&
        point.y <= lattice_.rows())) {
    return std::nullopt;
  }
  const std::int32_t row = std::min(static_cast<std::int32_t>(point.y), lattice_.rows() - 1);
  const OpenRows::Row& all = runs(row);
  const auto after =
      std::upper_bound(all.begin(), all.end(), point.x,
                       [](double x, const OpenRows::Run& run) { return x < run.begin; });
  if (after == all.begin() || (after - 1)->end < point.x) return std::nullopt;
  return RunId{row, static_cast<std::int32_t>(after - all.begin()) - 1};
}

const OpenRows::Row& TautWays::runs(std::int32_t row) {
  if (!lattice_.is_known(row)) work_ += lattice_.columns() / cells_per_work;
  return lattice_.row(row);
}

template <typename Visit>
void TautWays::for_neighbours(const RunId& id, std::int32_t line, Visit visit) {
  const OpenRows::Run run = runs(id.row)[static_cast<std::size_t>(id.index)];
  const std::int32_t row = line > id.row ? line : line - 1;
  if (row < 0 || row >= lattice_.rows()) return;
  const OpenRows::Row& others = runs(row);
  auto other = std::lower_bound(others.begin(), others.end(), run.begin,
                                [](const OpenRows::Run& r, std::int32_t x) { return r.end < x; });
  for (; other != others.end() && other->begin <= run.end; ++other) {
    const Interval shared{static_cast<double>(std::max(run.begin, other->begin)),
                          static_cast<double>(std::min(run.end, other->end)), true, true};
    visit(shared, RunId{row, static_cast<std::int32_t>(other - others.begin())});
  }
}

double TautWays::Node::way_to(const Point& point) const {
  const double before = std::abs(line - root.y);
  const double behind = std::abs(point.y - line);
  const double share = before + behind > 0 ? before / (before + behind) : 1.0;
  const double x = std::clamp(root.x + share * (point.x - root.x), interval.left, interval.right);
  return cost + std::hypot(x - root.x, before) + std::hypot(point.x - x, behind);
}

std::int64_t TautWays::key_of(const Point& corner) const noexcept {
  return static_cast<std::int64_t>(corner.y) * (lattice_.columns() + 1) +
         static_cast<std::int64_t>(corner.x);
}

// Whether no shorter way to the corner is known; stores the way.
bool TautWays::reaches(const Point& corner, double cost) {
  double& least = corner_costs_.try_emplace(key_of(corner), cost).first->second;
  if (cost > least + rounding) return false;
  least = std::min(least, cost);
  return true;
}

// Adds a node. If the root is on the interval's line but outside it, ways turn at the interval's
// end.
void TautWays::push(Node node) {
  if (node.root.y == node.line) {
    const double x = std::clamp(node.root.x, node.interval.left, node.interval.right);
    node.cost += std::abs(x - node.root.x);
    if (x != node.root.x && !reaches({x, node.root.y}, node.cost)) return;
    node.root.x = x;
  }
  const double way = node.way_to(goal_);  // a lower bound unless the goal is in sight
  if (longest_ && way > *longest_) return;
  node.rank = longest_ ? way_to_interval(node) : way;
  open_.push(node);
}

// Adds nodes to all runs that touch `in`; the root sees all of `in`.
void TautWays::spread(const Point& root, double cost, const RunId& in, const RunId& from) {
  for (const std::int32_t line : {in.row, in.row + 1}) {
    for_neighbours(in, line, [&](const Interval& shared, const RunId& into) {
      if (!(into == from)) push({root, cost, 0.0, shared, line, in, into});
    });
  }
}

// Adds nodes across the run that a node enters, to the far line between two places.
void TautWays::cross(const Node& node, const Point& root, double cost, double left, double right) {
  const std::int32_t far = node.into.row == node.line ? node.line + 1 : node.line - 1;
  for_neighbours(node.into, far, [&](Interval shared, const RunId& into) {
    if (shared.left > right || shared.right < left) return;
    if (shared.left < left) {
      shared.left = left;
      shared.turns_left = false;
    }
    if (shared.right > right) {
      shared.right = right;
      shared.turns_right = false;
    }
    push({root, cost, 0.0, shared, far, node.into, into});
  });
}

// Adds nodes of ways that turn at the left or right end of the node's interval and are hidden from
// its root: beyond `limit` on the far line, or on the near line. One of equally short ways to a
// corner is enough. Places to which only another way turns are seen from the first way and are
// nearer that way.
void TautWays::turn(const Node& node, double limit, bool to_left) {
  const Point root{to_left ? node.interval.left : node.interval.right,
                   static_cast<double>(node.line)};
  const double cost = node.cost + distance(node.root, root);
  if (!reaches(root, cost)) return;
  const bool goes_up = node.into.row == node.line;
  const std::int64_t key = 4 * key_of(root) + (goes_up ? 2 : 0) + (to_left ? 1 : 0);
  const auto [turned, is_first] = turn_costs_.try_emplace(key, cost);
  if (!is_first && cost > turned->second - rounding) return;
  turned->second = cost;
  cross(node, root, cost, to_left ? -infinity : limit, to_left ? limit : infinity);
  for_neighbours(node.into, node.line, [&](const Interval& shared, const RunId& into) {
    const bool is_beyond = to_left ? into.index < node.from.index : into.index > node.from.index;
    if (is_beyond) push({root, cost, 0.0, shared, node.line, node.into, into});
  });
}

void TautWays::expand(const Node& node) {
  const double behind = std::abs(node.line - node.root.y);
  if (behind == 0.0) {
    spread(node.root, node.cost, node.into, node.from);
    return;
  }
  const double stretch = (behind + 1.0) / behind;
  const auto seen = [&](double x, double slack) {
    const double there = node.root.x + (x - node.root.x) * stretch;
    return there + slack * rounding * (1.0 + std::abs(there));
  };
  const double left = seen(node.interval.left, -1.0);
  const double right = seen(node.interval.right, 1.0);
  cross(node, node.root, node.cost, left, right);
  if (node.interval.turns_left) turn(node, left, true);
  if (node.interval.turns_right) turn(node, right, false);
}

}  // namespace vandplan::search
