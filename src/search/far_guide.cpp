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
      raster_{{box.x_min, box.y_min}, options.side * task.vehicle.width},
      near_(blocked_within(task, raster_.side)),
      greediness_(std::llround(options.greediness * whole)),
      root_(raster_.cell_of({root.x, root.y})) {
  // The vehicle stands at the root, so its cell is open.
  cost_at(root_) = unknown_cell;
  const RasterCell to = raster_.cell_of(target_);
  cost_at(to) = 0;
  open_.push({rank_of(to, 0), to});
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
      mark(*tile, first, site_->kerbs,
           raster_.side / 2);  // The rear axle cannot get nearer to a kerb.
    }
    last_key_ = key;
    last_tile_ = tile.get();
  }
  return (*last_tile_)[place_in_tile(cell)];
}

void FarGuide::mark(Tile& tile, const RasterCell& first, const PolygonSquares& polygons,
                    double near) const {
  const RasterCell last{first.x + tile_side - 1, first.y + tile_side - 1};
  const Point low = raster_.centre_of(first);
  const Point high = raster_.centre_of(last);
  const Bounds around{low.x - near, high.x + near, low.y - near, high.y + near};
  const auto close = [&](const RasterCell& cell, double squared) {
    if (squared <= near * near) tile[place_in_tile(cell)] = closed_cell;
  };
  polygons.visit_near(around, [&](const Polygon& polygon) {
    Point a = polygon.back();
    for (const Point& b : polygon) {
      raster_.visit_near(a, b, near, first, last, close);
      a = b;
    }
  });
}

bool FarGuide::is_closed(const RasterCell& cell) const {
  const Point centre = raster_.centre_of(cell);
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
    points.push_back(cost > 0 ? raster_.centre_of(here) : target_);
  }
  if (points.size() == 1) points.push_back(target_);
  return points;
}

double FarGuide::at(double x, double y) const noexcept {
  const double euclid = std::hypot(x - target_.x, y - target_.y);
  if (!reached_ || !contains(box_, {x, y})) return euclid;
  const RasterCell cell = raster_.cell_of({x, y});
  const std::int32_t known = known_cost(cell);
  if (known == closed_cell) return euclid;
  const double least =
      known == unknown_cell
          ? static_cast<double>(front_ - greediness_ * cost_between(cell, root_)) / whole
          : known;
  return std::max(euclid, least * raster_.side / straight_cost);
}

}  // namespace vandplan::search
