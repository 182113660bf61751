// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/geodesic.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/boxes.h"

namespace vandplan::search {
namespace {

constexpr double coarsest = 1.0;        // Cell of the first lattice [disc radii].
constexpr double finest = 1.0 / 32;     // Cell of the last lattice [disc radii].
constexpr double max_cells = 4000.0;    // Cells along the longer side of a lattice.
constexpr double rounding_near = 1e-6;  // Slack of distances to obstacles [m].
constexpr int work_of_step = 32;        // Intervals expanded by one call.

double distance(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// Bounding box of the ellipse of all places on ways of this length between two points.
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

Bounds box_of_paths(const Task& task, const Disc& disc, double longest) {
  const Bounds& bounds = task.world->local().bounds;
  const double stretch = stretch_of(disc, task.vehicle.min_turning_radius);
  const Bounds ways = box_of_ways(centre_of(disc, task.start), centre_of(disc, task.goal),
                                  longest * stretch + disc.radius + task.least_margin);
  const double beside = std::abs(disc.ahead);  // The centre may be beside the bounds by this much.
  return geometry::shared(geometry::widened(bounds, beside), ways);
}

Geodesic::Geodesic(const Task& task, double longest, GearSign only)
    : task_(task), longest_(longest) {
  const Disc disc = bound_disc(task.vehicle);
  disc_ = disc.radius + task.least_margin;
  stretch_ = stretch_of(disc, task.vehicle.min_turning_radius);
  from_ = centre_of(disc, task.start);
  to_ = centre_of(disc, task.goal);
  closed_ = closed_areas(task, disc, only);
  box_ = box_of_paths(task, disc, longest);
  bound_ = distance(from_, to_);
  side_ = 2 * coarsest * disc_;
  next_lattice();
}

bool Geodesic::next_lattice() {
  side_ /= 2;
  const double extent = std::max(box_.x_max - box_.x_min, box_.y_max - box_.y_min);
  if (side_ < finest * disc_ || side_ * max_cells < extent) return false;
  const double near = disc_ - side_ * std::sqrt(0.5) - rounding_near;
  if (!(near > 0)) return false;
  OpenRows lattice(task_, box_, side_, near, closed_);
  const Point start = lattice.in_cells(from_);
  const Point goal = lattice.in_cells(to_);
  ways_ = TautWays(std::move(lattice), start, goal);
  is_settled_ = ways_.start_run() == ways_.goal_run();
  return true;
}

bool Geodesic::step() {
  const std::int64_t end = ways_.work() + work_of_step;
  while (ways_.work() < end) {
    const std::optional<TautWays::Node> node = is_settled_ ? std::nullopt : ways_.take();
    if (!node) return next_lattice();
    bound_ = std::max(bound_, node->rank * side_ * (1 - TautWays::rounding));
    is_settled_ = node->into == ways_.goal_run();
    if (!is_settled_ && ways_.is_current(*node)) ways_.expand(*node);
  }
  return true;
}

}  // namespace vandplan::search
