// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/geodesic.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace vandplan::search {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double coarsest = 1.0;        // cell of the first lattice [disc radii]
constexpr double finest = 1.0 / 32;     // of the last one
constexpr double most_cells = 4000.0;   // along the longer side of a lattice
constexpr double rounding = 1e-9;       // of places in cells; errs towards visible
constexpr double rounding_near = 1e-6;  // of distances to obstacles [m]
constexpr int work_of_step = 32;        // intervals
constexpr int cells_per_work = 16;      // that take as long to look at as an interval
constexpr std::size_t most_nodes = 400000;

double distance(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// Around the ellipse of all places on ways of that length between two points.
Bounds box_of_ways(const Point& p, const Point& q, double length) {
  const double dx = (q.x - p.x) / 2;
  const double dy = (q.y - p.y) / 2;
  const double square = std::max(0.0, length * length / 4 - dx * dx - dy * dy);
  const Point middle{p.x + dx, p.y + dy};
  const double x = std::sqrt(square + dx * dx);
  const double y = std::sqrt(square + dy * dy);
  return {middle.x - x, middle.x + x, middle.y - y, middle.y + y};
}

}  // namespace

Geodesic::Geodesic(const Task& task, double longest) : task_(task), longest_(longest) {
  const Disc disc = bound_disc(task.vehicle);
  disc_ = disc.radius + task.least_margin;
  stretch_ = stretch_of(disc, task.vehicle.min_turning_radius);
  from_ = centre_of(disc, task.start);
  to_ = centre_of(disc, task.goal);
  const Bounds& bounds = task.world->local().bounds;
  const Bounds ways = box_of_ways(from_, to_, longest * stretch_ + disc_);
  const double beside = std::abs(disc.ahead);  // of the bounds
  box_ = {std::max(bounds.x_min - beside, ways.x_min), std::min(bounds.x_max + beside, ways.x_max),
          std::max(bounds.y_min - beside, ways.y_min), std::min(bounds.y_max + beside, ways.y_max)};
  bound_ = distance(from_, to_);
  side_ = 2 * coarsest * disc_;
  next_lattice();
}

bool Geodesic::next_lattice() {
  side_ /= 2;
  const double extent = std::max(box_.x_max - box_.x_min, box_.y_max - box_.y_min);
  if (side_ < finest * disc_ || side_ * most_cells < extent) return false;
  const double near = disc_ - side_ * std::sqrt(0.5) - rounding_near;
  if (!(near > 0)) return false;
  lattice_ = OpenRows(task_, box_, side_, near);
  turn_costs_.clear();
  open_ = {};
  goal_ = lattice_.in_cells(to_);
  goal_run_ = run_at(goal_);
  const Point start = lattice_.in_cells(from_);
  const RunId start_run = run_at(start);
  if (!(start_run == goal_run_)) spread(start, 0.0, start_run, {-1, -1});
  return true;
}

Geodesic::RunId Geodesic::run_at(const Point& point) {
  const std::int32_t row = std::clamp(static_cast<std::int32_t>(point.y), 0, lattice_.rows() - 1);
  const OpenRows::Row& all = runs(row);
  const auto after =
      std::upper_bound(all.begin(), all.end(), point.x,
                       [](double x, const OpenRows::Run& run) { return x < run.begin; });
  assert(after != all.begin());
  return {row, static_cast<std::int32_t>(after - all.begin()) - 1};
}

const OpenRows::Row& Geodesic::runs(std::int32_t row) {
  if (!lattice_.is_known(row)) work_ += lattice_.columns() / cells_per_work;
  return lattice_.row(row);
}

template <typename Visit>
void Geodesic::for_neighbours(const RunId& id, std::int32_t line, Visit visit) {
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

// By way of the point of the interval that is best for a goal that may be seen from it.
double Geodesic::rank(const Node& node) const {
  const double y = node.line;
  const bool goes_up = node.into.row == node.line;
  const double ahead = std::abs(goal_.y - y);  // a goal behind is as far as its mirror image
  const double behind = goes_up ? y - node.root.y : node.root.y - y;
  const double share = behind + ahead > 0 ? behind / (behind + ahead) : 1.0;
  const double x = std::clamp(node.root.x + share * (goal_.x - node.root.x), node.interval.left,
                              node.interval.right);
  return node.cost + std::hypot(x - node.root.x, behind) + std::hypot(goal_.x - x, ahead);
}

// Whether no shorter way to the corner is known.
bool Geodesic::reaches(const Point& corner, double cost) {
  const auto key = static_cast<std::int64_t>(corner.y) * (lattice_.columns() + 1) +
                   static_cast<std::int64_t>(corner.x);
  double& least = turn_costs_.try_emplace(key, cost).first->second;
  if (cost > least + rounding) return false;
  least = std::min(least, cost);
  return true;
}

// A root on the line of the interval but outside of it: ways turn at the interval's end.
void Geodesic::push(Node node) {
  if (node.root.y == node.line) {
    const double x = std::clamp(node.root.x, node.interval.left, node.interval.right);
    node.cost += std::abs(x - node.root.x);
    if (x != node.root.x && !reaches({x, node.root.y}, node.cost)) return;
    node.root.x = x;
  }
  node.rank = rank(node);
  open_.push(node);
}

// To all that `in` touches, all of which is seen from the root.
void Geodesic::spread(const Point& root, double cost, const RunId& in, const RunId& from) {
  for (const std::int32_t line : {in.row, in.row + 1}) {
    for_neighbours(in, line, [&](const Interval& shared, const RunId& into) {
      if (!(into == from)) push({root, cost, 0.0, shared, line, in, into});
    });
  }
}

// Across the run that a node enters, to what lies on the far line between two places.
void Geodesic::cross(const Node& node, const Point& root, double cost, double left, double right) {
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

// Ways that turn at the left or right end of the node's interval, and are not seen from its root:
// beyond `limit` on the far line, or on the near line.
void Geodesic::turn(const Node& node, double limit, bool to_left) {
  const Point root{to_left ? node.interval.left : node.interval.right,
                   static_cast<double>(node.line)};
  const double cost = node.cost + distance(node.root, root);
  if (!reaches(root, cost)) return;
  cross(node, root, cost, to_left ? -infinity : limit, to_left ? limit : infinity);
  for_neighbours(node.into, node.line, [&](const Interval& shared, const RunId& into) {
    const bool is_beyond = to_left ? into.index < node.from.index : into.index > node.from.index;
    if (is_beyond) push({root, cost, 0.0, shared, node.line, node.into, into});
  });
}

void Geodesic::expand(const Node& node) {
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

bool Geodesic::step() {
  for (work_ = 0; work_ < work_of_step; ++work_) {
    if (open_.empty() || open_.size() > most_nodes) return next_lattice();
    const Node node = open_.top();
    open_.pop();
    bound_ = std::max(bound_, node.rank * side_ * (1 - rounding));
    if (node.into == goal_run_) {
      open_ = {};
    } else if (node.cost == 0.0 || reaches(node.root, node.cost)) {
      expand(node);
    }
  }
  return true;
}

}  // namespace vandplan::search
