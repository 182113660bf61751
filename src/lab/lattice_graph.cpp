// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/lattice_graph.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/trigonometry.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::search {
namespace {

constexpr double joint_reach = 1.25;     // longest piece from the start [turning radii]
constexpr double rounding = 1e-9;        // relative rounding error of a curvature
constexpr double farthest_vertex = 1e8;  // largest distance from the goal [steps]

/// Primitives for a turning radius [m], scaled from those for 1 m.
std::shared_ptr<const Primitives> scaled(const Primitives& unit, double radius) {
  std::vector<Primitive> all(unit.all().begin(), unit.all().end());
  for (Primitive& primitive : all) {
    primitive.piece.length *= radius;
    for (std::size_t i = 0; i < primitive.piece.count; ++i) {
      Segment& segment = primitive.piece.segments[i];
      segment = {segment.curvature / radius, segment.length * radius};
    }
  }
  const auto headings = unit.headings();
  return std::make_shared<const Primitives>(
      unit.step() * radius, std::vector<double>(headings.begin(), headings.end()), std::move(all));
}

/// The primitives that are driven in the allowed gears alone. Throws InputError naming "primitives"
/// if there is none.
std::shared_ptr<const Primitives> driven_in(const Primitives& primitives, AllowedGears gears) {
  const CostRule rule = restricted({}, gears);
  std::vector<Primitive> all(primitives.all().begin(), primitives.all().end());
  std::erase_if(all, [&](const Primitive& p) { return !may_drive(rule, p.piece.view()); });
  const auto headings = primitives.headings();
  return std::make_shared<const Primitives>(
      primitives.step(), std::vector<double>(headings.begin(), headings.end()), std::move(all));
}

/// Primitives for a turning radius of 1 m, made once in a process.
std::shared_ptr<const Primitives> unit_primitives(AllowedGears gears) {
  static const std::shared_ptr<const Primitives> both = make_primitives(1.0);
  static const auto forward = driven_in(*both, AllowedGears::forward);
  static const auto reverse = driven_in(*both, AllowedGears::reverse);
  return gears == AllowedGears::both ? both : gears == AllowedGears::forward ? forward : reverse;
}

}  // namespace

LatticeParts standard_lattice(const Task& task, const std::function<bool()>& is_interrupted,
                              AllowedGears gears) {
  const std::shared_ptr<const Primitives> unit = unit_primitives(gears);
  const double radius = task.vehicle.min_turning_radius;
  return {scaled(*unit, radius), table_of(*unit, is_interrupted), radius, gears};
}

LatticeParts given_lattice(const Task& task, std::shared_ptr<const Primitives> primitives,
                           const std::function<bool()>& is_interrupted, AllowedGears gears) {
  if (gears != AllowedGears::both) primitives = driven_in(*primitives, gears);
  const double sharpest = 1 / primitives->largest_curvature();
  const double radius = task.vehicle.min_turning_radius;
  if (sharpest < radius * (1 - rounding)) {
    throw InputError("primitives", "turn with a radius of " + std::to_string(sharpest) +
                                       " m, expected that of the vehicle at least, " +
                                       std::to_string(radius) + " m");
  }
  std::shared_ptr<const LatticeTable> table = table_of(*primitives, is_interrupted);
  return {std::move(primitives), std::move(table), 1.0, gears};
}

LatticeGraph::LatticeGraph(const Task& task, LatticeParts parts)
    : task_(task),
      parts_(std::move(parts)),
      radius_(task.vehicle.min_turning_radius),
      goal_{0, 0, heading_ahead(*parts_.primitives)} {
  const Primitives& primitives = *parts_.primitives;
  const double ahead = primitives.headings()[static_cast<std::size_t>(goal_.heading)];
  frame_ = compose(task.goal, {0.0, 0.0, -ahead});
  const auto [sin, cos] = base::sin_cos(frame_.heading);
  sin_ = sin;
  cos_ = cos;
  for (const double heading : primitives.headings()) {
    headings_.push_back(wrap_angle(task.goal.heading + wrap_angle(heading - ahead)));
  }
  for (const Primitive& p : primitives.all()) moves_.push_back({p.dx, p.dy, p.to, p.piece.length});
}

LocalPose LatticeGraph::pose_of(const Vertex& vertex) const noexcept {
  const double x = vertex.x * parts_.primitives->step();
  const double y = vertex.y * parts_.primitives->step();
  return Local(Pose{frame_.x + cos_ * x - sin_ * y, frame_.y + sin_ * x + cos_ * y,
                    headings_[static_cast<std::size_t>(vertex.heading)]});
}

std::int32_t LatticeGraph::first_move(std::int32_t heading) const noexcept {
  return parts_.primitives->first_from(static_cast<std::size_t>(heading));
}

std::span<const LatticeGraph::Move> LatticeGraph::moves(std::int32_t heading) const noexcept {
  return std::span(moves_).subspan(
      static_cast<std::size_t>(first_move(heading)),
      static_cast<std::size_t>(first_move(heading + 1) - first_move(heading)));
}

std::vector<Joint> LatticeGraph::joints(const Pose& start) const {
  const double longest = std::max(joint_reach * radius_, parts_.primitives->longest());
  const double step = parts_.primitives->step();
  const Pose there = relative(frame_, start);
  const double farthest = std::max(std::abs(there.x), std::abs(there.y)) / step;
  if (!(farthest < farthest_vertex)) return {};
  const auto reach = std::min(static_cast<std::int32_t>(longest / step), 40);
  const auto x_near = static_cast<std::int32_t>(std::lround(there.x / step));
  const auto y_near = static_cast<std::int32_t>(std::lround(there.y / step));
  std::vector<Vertex> vertices;
  std::vector<float> x, y, heading;
  for (std::int32_t dx = -reach; dx <= reach; ++dx) {
    for (std::int32_t dy = -reach; dy <= reach; ++dy) {
      if (dx * dx + dy * dy > reach * reach) continue;
      for (std::int32_t h = 0; h < static_cast<std::int32_t>(headings_.size()); ++h) {
        vertices.push_back({x_near + dx, y_near + dy, h});
        const Pose pose = relative(start, pose_of(vertices.back()));
        x.push_back(static_cast<float>(pose.x));
        y.push_back(static_cast<float>(pose.y));
        heading.push_back(static_cast<float>(pose.heading));
      }
    }
  }
  // The Reeds-Shepp length from a vertex to the start equals that from the start to the vertex.
  std::vector<float> lengths(vertices.size());
  reeds_shepp_lengths({x, y, heading}, Pose{}, radius_, lengths);
  const CostRule rule = restricted({}, parts_.gears);
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (static_cast<double>(lengths[i]) > longest) continue;
    const Piece piece = reeds_shepp(start, pose_of(vertices[i]), radius_);
    if (may_drive(rule, piece.view())) joints.push_back({vertices[i], piece});
  }
  return joints;
}

double LatticeGraph::least_way(const Vertex& vertex) const noexcept {
  const double way = parts_.table->length_from(vertex);
  if (way < parts_.table->most()) return way * parts_.table_scale;
  return std::max(way * parts_.table_scale,
                  reeds_shepp_length(pose_of(vertex), task_.goal, radius_));
}

}  // namespace vandplan::search
