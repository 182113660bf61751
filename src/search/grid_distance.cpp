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
constexpr double slack = 1e-3;  // Slack where a nearly level side is crossed [cells].
// Cells are settled on ways up to this factor longer than the shortest.
constexpr double detour = 1.1;

}  // namespace

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
      price_{std::min(price.weight, max_weight), price.distance},
      disc_(inner_radius(task.vehicle) + task.least_margin),
      buckets_(is_priced() ? priced_grid_buckets : grid_buckets),
      last_(unreached) {
  const double width = box.x_max - box.x_min;
  const double height = box.y_max - box.y_min;
  side_ = side_of_cells(task, box, side);
  columns_ = static_cast<std::int32_t>(width / side_) + 3;
  rows_ = static_cast<std::int32_t>(height / side_) + 3;
  costs_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), unreached);
  if (is_priced()) {
    price_.distance = std::min(price_.distance, max_distance * side_);
    gaps_.assign(costs_.size(), std::numeric_limits<float>::infinity());
    lengths_.assign(costs_.size(), 0);
  }
  mark_border();
  near_ = std::max(disc_ - side_ * std::sqrt(0.5), side_ / 2);
  root_ = cell_of({root.x, root.y});
}

void GridDistance::begin() {
  const RasterCell to = cell_of(target_);
  costs_[index_of(root_)] = unreached;
  costs_[index_of(to)] = unreached;
  front_ = cost_between(to, root_);
  reach(to, 0, 0, 0);
}

std::size_t GridDistance::index_of(const RasterCell& cell) const noexcept {
  return static_cast<std::size_t>(cell.y * columns_ + cell.x);
}

RasterCell GridDistance::cell_of(const Point& point) const noexcept {
  return {static_cast<std::int32_t>((point.x - box_.x_min) / side_) + 1,
          static_cast<std::int32_t>((point.y - box_.y_min) / side_) + 1};
}

// Blocks a frame of cells, so that each other cell has eight neighbours.
void GridDistance::mark_border() {
  for (std::int32_t x = 0; x < columns_; ++x) {
    costs_[index_of({x, 0})] = costs_[index_of({x, rows_ - 1})] = blocked;
  }
  for (std::int32_t y = 0; y < rows_; ++y) {
    costs_[index_of({0, y})] = costs_[index_of({columns_ - 1, y})] = blocked;
  }
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
    looks += is_kerb ? mark_side(a, b, side_ / 2, 0.0) : mark_side(a, b, near_, noted);
    if (++corner_ < polygon.size()) continue;
    corner_ = 0;
    ++polygon_;
  }
  return false;
}

std::int32_t GridDistance::inner_index(double offset, std::int32_t count) const noexcept {
  // Computed in double, as the offset of an obstacle may exceed an integer.
  const double cell = std::clamp(std::floor(offset / side_), 0.0, count - 3.0);
  return static_cast<std::int32_t>(cell) + 1;
}

// Blocks the cells whose centre is so near to a side that no point of them is free for the disc,
// and at least the cells that the side crosses. Each row looks only at the part of the side beside
// it.
std::int64_t GridDistance::mark_side(const Point& a, const Point& b, double near, double noted) {
  const double reach = std::max(near, noted) + side_ * slack;
  std::int64_t looks = 0;
  const std::int32_t y_end = inner_index(std::max(a.y, b.y) + reach - box_.y_min, rows_);
  for (std::int32_t y = inner_index(std::min(a.y, b.y) - reach - box_.y_min, rows_); y <= y_end;
       ++y) {
    const double middle = centre_of({0, y}).y;
    const double one = place_at(a, b, middle - reach);
    const double other = place_at(a, b, middle + reach);
    const std::int32_t x_end = inner_index(std::max(one, other) + reach - box_.x_min, columns_);
    const std::int32_t x_begin = inner_index(std::min(one, other) - reach - box_.x_min, columns_);
    for (std::int32_t x = x_begin; x <= x_end; ++x) {
      const std::size_t cell = index_of({x, y});
      if (noted == 0.0 && costs_[cell] == blocked) continue;
      const double squared = squared_distance(centre_of({x, y}), a, b);
      if (squared <= near * near) costs_[cell] = blocked;
      if (noted == 0.0) continue;
      gaps_[cell] = std::min(gaps_[cell], static_cast<float>(std::sqrt(squared)));
    }
    looks += x_end - x_begin + 1;
  }
  return looks;
}

// A map is looked up when a cell is first reached, as most cells of a large map never are.
bool GridDistance::is_blocked_by_map(const RasterCell& cell) const {
  if (cell == root_ || cell == cell_of(target_)) return false;
  return map_->map_is_within(Local(centre_of(cell)), near_);
}

Point GridDistance::centre_of(const RasterCell& cell) const noexcept {
  return {box_.x_min + (cell.x - 0.5) * side_, box_.y_min + (cell.y - 0.5) * side_};
}

// Price of a metre at the cheapest place of a cell.
double GridDistance::price_at(const RasterCell& cell) const {
  double gap = gaps_[index_of(cell)];
  if (map_ != nullptr) gap = std::min(gap, map_->map_distance(Local(centre_of(cell))).most);
  const double clearance = std::max(0.0, gap + side_ / 2 - disc_);
  return 1.0 + price_.weight * std::max(0.0, 1.0 - clearance / price_.distance);
}

void GridDistance::reach(const RasterCell& cell, std::int32_t cost, std::int32_t length,
                         std::int32_t step) {
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
  const RasterCell cell = cell_of({x, y});
  const std::int32_t cost = costs_[index_of(cell)];
  if (cost == blocked || (cost == unreached && !reached_)) return euclid;
  const std::int32_t least = cost == unreached ? front_ - cost_between(cell, root_) : cost;
  return std::max(euclid, least * side_ / straight_cost);
}

double GridDistance::length_at(double x, double y) const noexcept {
  if (!is_priced() || !contains(box_, {x, y})) return at(x, y);
  const std::size_t cell = index_of(cell_of({x, y}));
  if (costs_[cell] == blocked || costs_[cell] == unreached) return at(x, y);
  return std::max(std::hypot(x - target_.x, y - target_.y), lengths_[cell] * side_ / straight_cost);
}

}  // namespace vandplan::search
