// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/grid_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vandplan::search {
namespace {

constexpr double max_cells = 40000.0;           // Cells of a grid over all of a box.
constexpr double max_cells_of_tiles = 1 << 30;  // Cells of a box, in tiles that may be made.
constexpr double max_columns = 1 << 18;         // Columns or rows of a box, in the same way.
constexpr std::size_t max_tiles = 8192;         // Tiles that are made, of 4 KB each.
constexpr std::int32_t blocked = -1;
constexpr std::int32_t unreached = std::numeric_limits<std::int32_t>::max();
constexpr double max_weight = 3.0;  // Largest weight of the price; a guide needs no more.
// Largest distance of the price [cells]; a guide needs no more.
constexpr double max_distance = 8.0;
constexpr std::int64_t units_of_greed = 4;  // A greediness is a multiple of 1 / 4.
constexpr int settled_of_step = 64;

double side_for(const Bounds& box, double side, double cells) {
  const double width = box.x_max - box.x_min;
  const double height = box.y_max - box.y_min;
  return std::max({side, std::sqrt(width * height / cells),
                   std::max(width, height) / std::min(cells, max_columns)});
}

/// Index of a world's polygons. It is kept with the world, as many plans share it.
std::shared_ptr<const SiteSquares> squares_of(const World& world) {
  return std::static_pointer_cast<const SiteSquares>(world.kept(typeid(SiteSquares), [&] {
    return std::make_shared<const SiteSquares>(
        SiteSquares{PolygonSquares(world.local().obstacles), PolygonSquares(world.local().kerbs)});
  }));
}

}  // namespace

double side_over_all(const Task& task, const Bounds& box, double side) {
  return side_for(box, side * task.vehicle.width, max_cells);
}

bool is_site(const Task& task, const Bounds& box) {
  return side_over_all(task, box, 1.0) > task.vehicle.width;
}

GridDistance::GridDistance(const Task& task, const Bounds& box, const Pose& target,
                           const Pose& root, const Options& options)
    : site_(squares_of(*task.world)),
      map_(task.world->local().map ? task.checker.get() : nullptr),
      box_(box),
      target_{target.x, target.y},
      root_place_{root.x, root.y},
      raster_{{box.x_min, box.y_min}, side_for(box, options.side, max_cells_of_tiles)},
      disc_(inner_radius(task.vehicle) + task.least_margin),
      // No point of a cell that is so near is free for the disc, or a side crosses it.
      near_(std::max(disc_ - raster_.side * std::sqrt(0.5), raster_.side / 2)),
      columns_(static_cast<std::int32_t>((box.x_max - box.x_min) / raster_.side) + 1),
      rows_(static_cast<std::int32_t>((box.y_max - box.y_min) / raster_.side) + 1),
      price_{std::min(options.price.weight, max_weight),
             std::min(options.price.distance, max_distance * raster_.side)},
      whole_(options.greediness == 1.0 ? 1 : units_of_greed),
      greediness_(std::llround(options.greediness * static_cast<double>(whole_))),
      detour_(options.detour),
      root_(cell_of(root_place_)),
      to_(cell_of(target_)),
      tile_columns_(columns_ / tile_side + 1),
      least_(whole_ * cost_between(to_, root_)),
      front_(rank_of(to_, 0)),
      greatest_(front_),
      last_(std::numeric_limits<std::int64_t>::max()) {
  tiles_.resize(static_cast<std::size_t>(tile_columns_) *
                static_cast<std::size_t>(rows_ / tile_side + 1));
  // The vehicle stands at both ends, so their cells are open.
  tile_of(root_).costs[place_of(root_)] = unreached;
  tile_of(to_).costs[place_of(to_)] = unreached;
  reach(to_, 0, 0);
}

RasterCell GridDistance::cell_of(const Point& point) const noexcept {
  const RasterCell cell = raster_.cell_of(point);
  return {std::clamp(cell.x, 0, columns_ - 1), std::clamp(cell.y, 0, rows_ - 1)};
}

std::size_t GridDistance::index_of_tile(const RasterCell& cell) const noexcept {
  return static_cast<std::size_t>(cell.y / tile_side) * static_cast<std::size_t>(tile_columns_) +
         static_cast<std::size_t>(cell.x / tile_side);
}

std::size_t GridDistance::place_of(const RasterCell& cell) noexcept {
  return static_cast<std::size_t>(cell.y % tile_side * tile_side + cell.x % tile_side);
}

GridDistance::Tile& GridDistance::tile_of(const RasterCell& cell) {
  std::unique_ptr<Tile>& tile = tiles_[index_of_tile(cell)];
  if (tile) return *tile;
  tile = std::make_unique<Tile>();
  ++made_tiles_;
  tile->costs.fill(unreached);
  if (is_priced()) {
    tile->squared_gaps.assign(tile->costs.size(), std::numeric_limits<float>::infinity());
  }
  const RasterCell first{cell.x / tile_side * tile_side, cell.y / tile_side * tile_side};
  mark(*tile, first, site_->obstacles, near_, is_priced() ? disc_ + price_.distance : 0.0);
  // The rear axle cannot get nearer to a kerb than this.
  mark(*tile, first, site_->kerbs, raster_.side / 2, 0.0);
  return *tile;
}

void GridDistance::mark(Tile& tile, const RasterCell& first, const PolygonSquares& polygons,
                        double near, double noted) {
  const double reach = std::max(near, noted);
  const RasterCell last{first.x + tile_side - 1, first.y + tile_side - 1};
  const Point low = raster_.centre_of(first);
  const Point high = raster_.centre_of(last);
  const auto note = [&](const RasterCell& cell, double squared) {
    const std::size_t place = place_of(cell);
    if (squared <= near * near) tile.costs[place] = blocked;
    if (noted == 0.0) return;
    float& gap = tile.squared_gaps[place];
    gap = std::min(gap, static_cast<float>(squared));
  };
  polygons.visit_near({low.x - reach, high.x + reach, low.y - reach, high.y + reach},
                      [&](const Polygon& polygon) {
                        Point a = polygon.back();
                        for (const Point& b : polygon) {
                          raster_.visit_near(a, b, reach, first, last, note);
                          a = b;
                        }
                      });
}

std::int32_t GridDistance::known_cost(const RasterCell& cell) const noexcept {
  const std::unique_ptr<Tile>& tile = tiles_[index_of_tile(cell)];
  return tile ? tile->costs[place_of(cell)] : unreached;
}

// A map is looked up when a cell is first reached, as most cells of a large map never are.
bool GridDistance::is_blocked_by_map(const RasterCell& cell) const {
  if (cell == root_ || cell == to_) return false;
  return map_->map_is_within(Local(raster_.centre_of(cell)), near_);
}

// Price of a metre at the cheapest place of a cell.
double GridDistance::price_at(const RasterCell& cell, float gap_of_sides) const {
  double gap = gap_of_sides;
  if (map_ != nullptr) gap = std::min(gap, map_->map_distance(Local(raster_.centre_of(cell))).most);
  const double clearance = std::max(0.0, gap + raster_.side / 2 - disc_);
  return 1.0 + price_.weight * std::max(0.0, 1.0 - clearance / price_.distance);
}

std::int64_t GridDistance::rank_of(const RasterCell& cell, std::int32_t cost) const noexcept {
  return whole_ * cost + greediness_ * cost_between(cell, root_);
}

void GridDistance::reach(const RasterCell& cell, std::int32_t cost, std::int32_t step) {
  if (cell.x < 0 || cell.y < 0 || cell.x >= columns_ || cell.y >= rows_) return;
  Tile& tile = tile_of(cell);
  const std::size_t place = place_of(cell);
  std::int32_t& known = tile.costs[place];
  cost += step;
  if (known <= cost) return;  // Blocked cells return here too.
  if (is_priced()) {
    cost += static_cast<std::int32_t>(step *
                                      (price_at(cell, std::sqrt(tile.squared_gaps[place])) - 1.0));
    if (known <= cost) return;
  }
  if (map_ != nullptr && known == unreached && is_blocked_by_map(cell)) {
    known = blocked;
    return;
  }
  known = cost;
  const std::int64_t rank = rank_of(cell, cost);
  const auto bucket = static_cast<std::size_t>(rank - least_);
  if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
  buckets_[bucket].push_back(cell);
  // A greedy search comes back to smaller ranks.
  greatest_ = std::max(greatest_, front_);
  front_ = std::min(front_, rank);
}

void GridDistance::settle(const RasterCell& cell) {
  const std::int32_t cost = tile_of(cell).costs[place_of(cell)];
  for (const std::int32_t dy : {-1, 0, 1}) {
    for (const std::int32_t dx : {-1, 0, 1}) {
      const bool is_straight = dx == 0 || dy == 0;
      reach({cell.x + dx, cell.y + dy}, cost, is_straight ? straight_cost : diagonal_cost);
    }
  }
}

// A* with a bucket for each rank.
bool GridDistance::step() {
  for (int settled = 0; settled < settled_of_step && front_ <= last_;) {
    if (made_tiles_ > max_tiles) return false;
    const auto front = static_cast<std::size_t>(front_ - least_);
    if (front >= buckets_.size()) {
      if (reached_) front_ = last_ + 1;
      return false;
    }
    std::vector<RasterCell>& bucket = buckets_[front];
    if (bucket.empty()) {
      ++front_;
      continue;
    }
    const RasterCell cell = bucket.back();
    bucket.pop_back();
    if (rank_of(cell, known_cost(cell)) != front_) continue;  // A shorter way was found meanwhile.
    ++settled;
    if (cell == root_ && !reached_) {
      reached_ = true;
      last_ = static_cast<std::int64_t>(detour_ * static_cast<double>(front_));
    }
    settle(cell);
  }
  return front_ <= last_;
}

double GridDistance::at(double x, double y) const noexcept {
  const double euclid = std::hypot(x - target_.x, y - target_.y);
  if (!contains(box_, {x, y})) return euclid;
  const RasterCell cell = cell_of({x, y});
  const std::int32_t cost = known_cost(cell);
  if (cost == blocked || (cost == unreached && !reached_)) return euclid;
  const double least = cost == unreached
                           ? static_cast<double>(std::max(front_, greatest_) -
                                                 greediness_ * cost_between(cell, root_)) /
                                 static_cast<double>(whole_)
                           : cost;
  return std::max(euclid, least * raster_.side / straight_cost);
}

// Descends the costs: each cell except the target's was reached from one that costs less.
std::vector<Point> GridDistance::way() const {
  std::vector<Point> points = {root_place_};
  RasterCell here = root_;
  for (std::int32_t cost = known_cost(here); cost > 0;) {
    RasterCell best = here;
    std::int32_t least = unreached;
    for (const std::int32_t dy : {-1, 0, 1}) {
      for (const std::int32_t dx : {-1, 0, 1}) {
        const RasterCell next{here.x + dx, here.y + dy};
        if (next.x < 0 || next.y < 0 || next.x >= columns_ || next.y >= rows_) continue;
        const std::int32_t known = known_cost(next);
        if (known == blocked || known >= cost) continue;
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

}  // namespace vandplan::search
