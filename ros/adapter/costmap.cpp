// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/costmap.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <string>

#include "vandplan/input_error.h"
#include "vandplan/problem.h"

namespace vandplan::ros {
namespace {

constexpr std::int32_t tile = 64;  // side of a tile, in cells

std::size_t size(std::int32_t count) { return static_cast<std::size_t>(count); }

std::int32_t tiles(std::int32_t cells) { return (cells + tile - 1) / tile; }

bool same_shape(const Costmap& a, const Costmap& b) {
  return a.columns == b.columns && a.rows == b.rows && a.resolution == b.resolution &&
         a.origin == b.origin;
}

void check(const Costmap& costmap) {
  OccupancyGrid map{.origin = costmap.origin,
                    .resolution = costmap.resolution,
                    .columns = costmap.columns,
                    .rows = costmap.rows};
  const bool has_size = costmap.columns >= 1 && costmap.rows >= 1;
  const std::size_t expected = has_size ? size(costmap.columns) * size(costmap.rows) : 0;
  if (!has_size || costmap.costs.size() != expected) {
    throw InputError("costmap", "has " + std::to_string(costmap.columns) + " x " +
                                    std::to_string(costmap.rows) + " cells and " +
                                    std::to_string(costmap.costs.size()) +
                                    " costs, expected a cost for each of at least one cell");
  }
  // One cell stands for all: they are right whatever they hold.
  map.columns = map.rows = 1;
  map.cells = std::vector<Cell>{Cell::free};
  check_map(map);
}

/// What `meaning` makes of the costs in a range, row by row.
template <typename Meaning>
auto translated(const Costmap& costmap, const CellRange& range, const Meaning& meaning) {
  using Value = decltype(meaning(std::uint8_t{}));
  std::array<Value, 256> all;
  for (std::size_t cost = 0; cost < all.size(); ++cost) {
    all[cost] = meaning(static_cast<std::uint8_t>(cost));
  }
  std::vector<Value> values(size(range.columns) * size(range.rows));
  auto to = values.begin();
  for (std::int32_t row = range.row; row < range.row + range.rows; ++row) {
    const auto from = costmap.costs.subspan(size(row) * size(costmap.columns) + size(range.column),
                                            size(range.columns));
    to = std::transform(from.begin(), from.end(), to, [&](std::uint8_t cost) { return all[cost]; });
  }
  return values;
}

}  // namespace

Cell cell_of(std::uint8_t cost, const CostRule& rule) noexcept {
  if (cost == unknown_cost) return rule.allow_unknown ? Cell::free : Cell::unknown;
  return cost >= rule.lethal_cost ? Cell::occupied : Cell::free;
}

std::vector<Cell> cells_of(const Costmap& costmap, const CostRule& rule, const CellRange& range) {
  return translated(costmap, range, [&](std::uint8_t cost) { return cell_of(cost, rule); });
}

std::vector<std::uint8_t> percents_of(const Costmap& costmap, const CostRule& rule,
                                      const CellRange& range) {
  const int highest = std::clamp(rule.lethal_cost - 1, 1, nav2_highest_cost);
  return translated(costmap, range, [&](std::uint8_t cost) -> std::uint8_t {
    if (cost == unknown_cost) return Mask::unknown;
    return static_cast<std::uint8_t>((200 * std::min<int>(cost, highest) + highest) /
                                     (2 * highest));
  });
}

Surroundings ground_of(const Costmap& costmap, const CostRule& rule) {
  const CellRange all{0, 0, costmap.columns, costmap.rows};
  const OccupancyGrid map{.origin = costmap.origin,
                          .resolution = costmap.resolution,
                          .columns = costmap.columns,
                          .rows = costmap.rows,
                          .cells = cells_of(costmap, rule, all)};
  Surroundings ground{.bounds = bounding_box(outline(map)), .map = map};
  if (rule.cost_penalty > 0.0) {
    Mask& mask = ground.masks.emplace_back(cost_mask(map, rule.cost_penalty));
    mask.percents =
        std::make_shared<const std::vector<std::uint8_t>>(percents_of(costmap, rule, all));
  }
  return ground;
}

void KnownCostmap::start_anew(const Costmap& costmap) {
  costs_.assign(costmap.costs.begin(), costmap.costs.end());
  shape_ = costmap;
  shape_.costs = {};
  tile_columns_ = tiles(costmap.columns);
  is_dirty_.assign(size(tile_columns_) * size(tiles(costmap.rows)), false);
  is_new_ = true;
}

void KnownCostmap::take(const Costmap& costmap) {
  check(costmap);
  if (costs_.empty() || !same_shape(costmap, shape_)) {
    start_anew(costmap);
    return;
  }
  const std::size_t columns = size(costmap.columns);
  for (std::size_t row = 0; row < size(costmap.rows); ++row) {
    const std::uint8_t* const from = costmap.costs.data() + row * columns;
    std::uint8_t* const to = costs_.data() + row * columns;
    if (std::memcmp(from, to, columns) == 0) continue;
    for (std::size_t column = 0; column < columns; column += tile) {
      const std::size_t count = std::min<std::size_t>(tile, columns - column);
      if (std::memcmp(from + column, to + column, count) == 0) continue;
      std::memcpy(to + column, from + column, count);
      is_dirty_[row / tile * size(tile_columns_) + column / tile] = true;
    }
  }
}

Costmap KnownCostmap::now() const noexcept {
  Costmap costmap = shape_;
  costmap.costs = costs_;
  return costmap;
}

std::optional<std::vector<CellRange>> KnownCostmap::changes() {
  if (is_new_) {
    is_new_ = false;
    is_dirty_.assign(is_dirty_.size(), false);
    return std::nullopt;
  }
  std::vector<CellRange> ranges;
  for (std::int32_t row = 0; row < shape_.rows; row += tile) {
    for (std::int32_t left = 0; left < tile_columns_; ++left) {
      const std::size_t first = size(row / tile) * size(tile_columns_);
      std::int32_t right = left;
      while (right < tile_columns_ && is_dirty_[first + size(right)]) {
        is_dirty_[first + size(right++)] = false;
      }
      if (right == left) continue;
      const std::int32_t end = std::min(right * tile, shape_.columns);
      const CellRange range{left * tile, row, end - left * tile, std::min(tile, shape_.rows - row)};
      left = right;  // the tile there has not changed
      // A range that goes on below one of the same columns makes that one longer.
      const auto above = std::find_if(ranges.begin(), ranges.end(), [&](const CellRange& other) {
        return other.column == range.column && other.columns == range.columns &&
               other.row + other.rows == range.row;
      });
      if (above == ranges.end()) {
        ranges.push_back(range);
      } else {
        above->rows += range.rows;
      }
    }
  }
  return ranges;
}

}  // namespace vandplan::ros
