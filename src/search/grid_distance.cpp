// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/grid_distance.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace vandplan::search {
namespace {

constexpr double max_cells = 40000.0;
constexpr std::int32_t blocked = -1;
constexpr std::int32_t unreached = std::numeric_limits<std::int32_t>::max();
constexpr double max_weight = 3.0;  // Largest weight of the price; a guide needs no more.
// Largest distance of the price [cells]; a guide needs no more.
constexpr double max_distance = 8.0;
constexpr std::size_t grid_buckets = 16;         // More than a step raises a rank, 7 + 7.
constexpr std::size_t priced_grid_buckets = 64;  // More than a priced step raises a rank, 28 + 7.
constexpr std::int64_t looks_of_step = 250'000;  // Cells beside sides that one call looks at.
// Cells are settled on ways up to this factor longer than the shortest.
constexpr double detour = 1.1;

}  // namespace

double blocked_within(const Task& task, double side) {
  const double disc = inner_radius(task.vehicle) + task.least_margin;
  return std::max(disc - side * std::sqrt(0.5), side / 2);
}

double GridDistance::side_of_cells(const Task& task, const Bounds& box, double side) {
  const double width = box.x_max - box.x_min;
  const double height = box.y_max - box.y_min;
  return std::max({side * task.vehicle.width, std::sqrt(width * height / max_cells),
                   std::max(width, height) / max_cells});
}

GridDistance::GridDistance(const Task& task, const Bounds& box, double side, const Pose& target,
                           const Pose& root, const ClearancePrice& price)
    : ground_(&task.world->local()),
      map_(ground_->map ? task.checker.get() : nullptr),
      box_(box),
      target_{target.x, target.y},
      raster_{{box.x_min, box.y_min}, side_of_cells(task, box, side)},
      near_(blocked_within(task, raster_.side)),
      columns_(static_cast<std::int32_t>((box.x_max - box.x_min) / raster_.side) + 1),
      rows_(static_cast<std::int32_t>((box.y_max - box.y_min) / raster_.side) + 1),
      costs_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), unreached),
      price_{std::min(price.weight, max_weight), price.distance},
      disc_(inner_radius(task.vehicle) + task.least_margin),
      buckets_(is_priced() ? priced_grid_buckets : grid_buckets),
      last_(unreached),
      root_(cell_in_box({root.x, root.y})),
      to_(cell_in_box(target_)) {
  if (is_priced()) {
    price_.distance = std::min(price_.distance, max_distance * raster_.side);
    gaps_.assign(costs_.size(), std::numeric_limits<float>::infinity());
    lengths_.assign(costs_.size(), 0);
  }
}

void GridDistance::begin() {
  costs_[index_of(root_)] = unreached;
  costs_[index_of(to_)] = unreached;
  front_ = cost_between(to_, root_);
  reach(to_, 0, 0, 0);
}

std::size_t GridDistance::index_of(const RasterCell& cell) const noexcept {
  return static_cast<std::size_t>(cell.y * columns_ + cell.x);
}

// Cell that contains a point of the box, the nearest one for other points.
RasterCell GridDistance::cell_in_box(const Point& point) const noexcept {
  const RasterCell cell = raster_.cell_of(point);
  return {std::clamp(cell.x, 0, columns_ - 1), std::clamp(cell.y, 0, rows_ - 1)};
}

bool GridDistance::mark() {
  const double noted = is_priced() ? disc_ + price_.distance : 0.0;
  const std::vector<Polygon>& obstacles = ground_->obstacles;
  for (std::int64_t looks = 0; looks < looks_of_step;) {
    const bool is_kerb = polygon_ >= obstacles.size();
    const std::size_t kerb = polygon_ - obstacles.size();
    if (is_kerb && kerb == ground_->kerbs.size()) return true;
    const Polygon& polygon = is_kerb ? ground_->kerbs[kerb] : obstacles[polygon_];
    const Point& a = corner_ == 0 ? polygon.back() : polygon[corner_ - 1];
    const Point& b = polygon[corner_];
    // The rear axle cannot get nearer to a kerb than this.
    looks += is_kerb ? mark_side(a, b, raster_.side / 2, 0.0) : mark_side(a, b, near_, noted);
    if (++corner_ < polygon.size()) continue;
    corner_ = 0;
    ++polygon_;
  }
  return false;
}

std::int64_t GridDistance::mark_side(const Point& a, const Point& b, double near, double noted) {
  const double reach = std::max(near, noted);
  const RasterCell last{columns_ - 1, rows_ - 1};
  return raster_.visit_near(a, b, reach, {0, 0}, last, [&](const RasterCell& at, double squared) {
    const std::size_t cell = index_of(at);
    if (squared <= near * near) costs_[cell] = blocked;
    if (noted == 0.0) return;
    gaps_[cell] = std::min(gaps_[cell], static_cast<float>(std::sqrt(squared)));
  });
}

// A map is looked up when a cell is first reached, as most cells of a large map never are.
bool GridDistance::is_blocked_by_map(const RasterCell& cell) const {
  if (cell == root_ || cell == to_) return false;
  return map_->map_is_within(Local(raster_.centre_of(cell)), near_);
}

// Price of a metre at the cheapest place of a cell.
double GridDistance::price_at(const RasterCell& cell) const {
  double gap = gaps_[index_of(cell)];
  if (map_ != nullptr) gap = std::min(gap, map_->map_distance(Local(raster_.centre_of(cell))).most);
  const double clearance = std::max(0.0, gap + raster_.side / 2 - disc_);
  return 1.0 + price_.weight * std::max(0.0, 1.0 - clearance / price_.distance);
}

void GridDistance::reach(const RasterCell& cell, std::int32_t cost, std::int32_t length,
                         std::int32_t step) {
  if (cell.x < 0 || cell.y < 0 || cell.x >= columns_ || cell.y >= rows_) return;
  std::int32_t& known = costs_[index_of(cell)];
  cost += step;
  if (known <= cost) return;  // Blocked cells return here too.
  if (is_priced()) {
    cost += static_cast<std::int32_t>(step * (price_at(cell) - 1.0));
    if (known <= cost) return;
  }
  if (map_ != nullptr && known == unreached && is_blocked_by_map(cell)) {
    known = blocked;
    return;
  }
  known = cost;
  if (is_priced()) lengths_[index_of(cell)] = length + step;
  const auto rank = static_cast<std::size_t>(cost + cost_between(cell, root_));
  buckets_[rank % buckets_.size()].push_back(cell);
}

// A* with a bucket for each rank.
bool GridDistance::step() {
  if (!is_marked_) {
    if (!mark()) return true;
    is_marked_ = true;
    begin();
  }
  std::size_t empty = 0;
  for (int settled = 0; settled < 64 && front_ <= last_;) {
    std::vector<RasterCell>& bucket = buckets_[static_cast<std::size_t>(front_) % buckets_.size()];
    if (bucket.empty()) {
      if (++empty == buckets_.size()) return false;
      ++front_;
      continue;
    }
    empty = 0;
    const RasterCell cell = bucket.back();
    bucket.pop_back();
    const std::int32_t cost = costs_[index_of(cell)];
    if (cost + cost_between(cell, root_) != front_) continue;
    const std::int32_t length = is_priced() ? lengths_[index_of(cell)] : cost;
    ++settled;
    if (cell == root_ && !reached_) {
      reached_ = true;
      last_ = static_cast<std::int32_t>(detour * front_);
    }
    for (const std::int32_t dy : {-1, 0, 1}) {
      for (const std::int32_t dx : {-1, 0, 1}) {
        const bool is_straight = dx == 0 || dy == 0;
        reach({cell.x + dx, cell.y + dy}, cost, length,
              is_straight ? straight_cost : diagonal_cost);
      }
    }
  }
  return front_ <= last_;
}

double GridDistance::at(double x, double y) const noexcept {
  const double euclid = std::hypot(x - target_.x, y - target_.y);
  if (!contains(box_, {x, y})) return euclid;
  const RasterCell cell = cell_in_box({x, y});
  const std::int32_t cost = costs_[index_of(cell)];
  if (cost == blocked || (cost == unreached && !reached_)) return euclid;
  const std::int32_t least = cost == unreached ? front_ - cost_between(cell, root_) : cost;
  return std::max(euclid, least * raster_.side / straight_cost);
}

double GridDistance::length_at(double x, double y) const noexcept {
  if (!is_priced() || !contains(box_, {x, y})) return at(x, y);
  const std::size_t cell = index_of(cell_in_box({x, y}));
  if (costs_[cell] == blocked || costs_[cell] == unreached) return at(x, y);
  return std::max(std::hypot(x - target_.x, y - target_.y),
                  lengths_[cell] * raster_.side / straight_cost);
}

}  // namespace vandplan::search
