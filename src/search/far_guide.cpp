// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/far_guide.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "search/grid_distance.h"

namespace vandplan::search {
namespace {

constexpr std::int32_t closed_cell = -1;
constexpr std::int32_t unknown_cell = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t whole = 64;       // Greediness is a multiple of 1 / 64.
constexpr std::size_t max_tiles = 8192;  // A tile has 32 x 32 cells and takes 4 KB.
constexpr int settled_at_once = 64;

/// Index of a world's polygons. It is kept with the world, as many plans share it.
std::shared_ptr<const SiteSquares> squares_of(const World& world) {
  return std::static_pointer_cast<const SiteSquares>(world.kept(typeid(SiteSquares), [&] {
    return std::make_shared<const SiteSquares>(
        SiteSquares{PolygonSquares(world.local().obstacles), PolygonSquares(world.local().kerbs)});
  }));
}

}  // namespace

bool FarGuide::is_wanted(const Task& task, const Bounds& box) {
  return GridDistance::side_of_cells(task, box, 1.0) > task.vehicle.width;
}

FarGuide::FarGuide(const Task& task, const Bounds& box, const Options& options, const Pose& target,
                   const Pose& root)
    : site_(squares_of(*task.world)),
      map_(task.world->local().map ? task.checker.get() : nullptr),
      box_(box),
      target_{target.x, target.y},
      root_place_{root.x, root.y},
      side_(options.side * task.vehicle.width),
      near_(std::max(inner_radius(task.vehicle) + task.least_margin - side_ * std::sqrt(0.5),
                     side_ / 2)),
      greediness_(std::llround(options.greediness * whole)),
      root_(cell_of({root.x, root.y})) {
  // The vehicle stands at the root, so its cell is open.
  cost_at(root_) = unknown_cell;
  const RasterCell to = cell_of(target_);
  cost_at(to) = 0;
  open_.push({rank_of(to, 0), to});
}

RasterCell FarGuide::cell_of(const Point& point) const noexcept {
  return {static_cast<std::int32_t>(std::floor((point.x - box_.x_min) / side_)),
          static_cast<std::int32_t>(std::floor((point.y - box_.y_min) / side_))};
}

std::uint64_t FarGuide::tile_of(const RasterCell& cell) noexcept {
  const auto x = static_cast<std::uint32_t>(cell.x / tile_side);
  const auto y = static_cast<std::uint32_t>(cell.y / tile_side);
  return (std::uint64_t{x} << 32) | y;
}

std::size_t FarGuide::place_in_tile(const RasterCell& cell) noexcept {
  return static_cast<std::size_t>(cell.y % tile_side * tile_side + cell.x % tile_side);
}

std::int32_t& FarGuide::cost_at(const RasterCell& cell) {
  const std::uint64_t key = tile_of(cell);
  if (last_tile_ == nullptr || key != last_key_) {
    std::unique_ptr<Tile>& tile = tiles_[key];
    if (!tile) {
      tile = std::make_unique<Tile>();
      tile->fill(unknown_cell);
      const RasterCell first{cell.x / tile_side * tile_side, cell.y / tile_side * tile_side};
      mark(*tile, first, site_->obstacles, near_);
      mark(*tile, first, site_->kerbs, side_ / 2);  // The rear axle cannot get nearer to a kerb.
    }
    last_key_ = key;
    last_tile_ = tile.get();
  }
  return (*last_tile_)[place_in_tile(cell)];
}

Point FarGuide::centre_of(const RasterCell& cell) const noexcept {
  return {box_.x_min + (cell.x + 0.5) * side_, box_.y_min + (cell.y + 0.5) * side_};
}

// Closes the cells whose centre is so near to a side that no point of them is free for the disc. At
// least the cells that the side crosses are closed.
void FarGuide::mark(Tile& tile, const RasterCell& first, const PolygonSquares& polygons,
                    double near) const {
  const Point low = centre_of(first);
  const Point high = centre_of({first.x + tile_side - 1, first.y + tile_side - 1});
  const Bounds around{low.x - near, high.x + near, low.y - near, high.y + near};
  polygons.visit_near(around, [&](const Polygon& polygon) {
    Point a = polygon.back();
    for (const Point& b : polygon) {
      mark(tile, first, a, b, near);
      a = b;
    }
  });
}

void FarGuide::mark(Tile& tile, const RasterCell& first, const Point& a, const Point& b,
                    double near) const {
  const Point origin = centre_of(first);
  // Computed in double, as the offset of an obstacle may exceed an integer.
  const auto begin = [&](double offset) {
    return static_cast<std::int32_t>(std::clamp(std::ceil(offset / side_), 0.0, tile_side + 0.0));
  };
  const auto end = [&](double offset) {
    return static_cast<std::int32_t>(
        std::clamp(std::floor(offset / side_) + 1, 0.0, tile_side + 0.0));
  };
  const std::int32_t x_begin = begin(std::min(a.x, b.x) - near - origin.x);
  const std::int32_t x_end = end(std::max(a.x, b.x) + near - origin.x);
  const std::int32_t y_end = end(std::max(a.y, b.y) + near - origin.y);
  for (std::int32_t y = begin(std::min(a.y, b.y) - near - origin.y); y < y_end; ++y) {
    for (std::int32_t x = x_begin; x < x_end; ++x) {
      const RasterCell cell{first.x + x, first.y + y};
      if (squared_distance(centre_of(cell), a, b) > near * near) continue;
      tile[place_in_tile(cell)] = closed_cell;
    }
  }
}

bool FarGuide::is_closed(const RasterCell& cell) const {
  const Point centre = centre_of(cell);
  return !contains(box_, centre) || (map_ != nullptr && map_->map_is_within(Local(centre), near_));
}

std::int64_t FarGuide::rank_of(const RasterCell& cell, std::int32_t cost) const noexcept {
  return whole * cost + greediness_ * cost_between(cell, root_);
}

void FarGuide::reach(const RasterCell& cell, std::int32_t cost) {
  if (cell.x < 0 || cell.y < 0) return;
  std::int32_t& known = cost_at(cell);
  if (known <= cost) return;  // Closed cells return here too.
  if (known == unknown_cell && !(cell == root_) && is_closed(cell)) {
    known = closed_cell;
    return;
  }
  known = cost;
  open_.push({rank_of(cell, cost), cell});
}

void FarGuide::settle(const RasterCell& cell, std::int32_t cost) {
  for (const std::int32_t dy : {-1, 0, 1}) {
    for (const std::int32_t dx : {-1, 0, 1}) {
      const bool is_straight = dx == 0 || dy == 0;
      reach({cell.x + dx, cell.y + dy}, cost + (is_straight ? straight_cost : diagonal_cost));
    }
  }
}

bool FarGuide::step() {
  for (int settled = 0; settled < settled_at_once; ++settled) {
    if (reached_ || open_.empty() || tiles_.size() > max_tiles) return false;
    const auto [rank, cell] = open_.top();
    open_.pop();
    const std::int32_t cost = cost_at(cell);
    if (rank != rank_of(cell, cost)) continue;  // A shorter way to the cell was found meanwhile.
    front_ = std::max(front_, rank);
    reached_ = cell == root_;
    settle(cell, cost);
  }
  return true;
}

std::int32_t FarGuide::known_cost(const RasterCell& cell) const noexcept {
  const auto tile = tiles_.find(tile_of(cell));
  return tile == tiles_.end() ? unknown_cell : (*tile->second)[place_in_tile(cell)];
}

// Descends the costs: each cell except the target's was reached from one that costs less.
std::vector<Point> FarGuide::way() const {
  std::vector<Point> points = {root_place_};
  RasterCell here = root_;
  for (std::int32_t cost = known_cost(here); cost > 0;) {
    RasterCell best = here;
    std::int32_t least = unknown_cell;
    for (const std::int32_t dy : {-1, 0, 1}) {
      for (const std::int32_t dx : {-1, 0, 1}) {
        const RasterCell next{here.x + dx, here.y + dy};
        if (next.x < 0 || next.y < 0) continue;
        const std::int32_t known = known_cost(next);
        if (known < 0 || known >= cost) continue;
        const std::int32_t through = known + (dx == 0 || dy == 0 ? straight_cost : diagonal_cost);
        if (through >= least) continue;
        least = through;
        best = next;
      }
    }
    here = best;
    cost = known_cost(here);
    points.push_back(cost > 0 ? centre_of(here) : target_);
  }
  if (points.size() == 1) points.push_back(target_);
  return points;
}

double FarGuide::at(double x, double y) const noexcept {
  const double euclid = std::hypot(x - target_.x, y - target_.y);
  if (!reached_ || !contains(box_, {x, y})) return euclid;
  const RasterCell cell = cell_of({x, y});
  const std::int32_t known = known_cost(cell);
  if (known == closed_cell) return euclid;
  const double least =
      known == unknown_cell
          ? static_cast<double>(front_ - greediness_ * cost_between(cell, root_)) / whole
          : known;
  return std::max(euclid, least * side_ / straight_cost);
}

}  // namespace vandplan::search
