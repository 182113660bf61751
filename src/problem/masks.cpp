// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/masks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "base/text.h"
#include "problem/checks.h"
#include "vandplan/input_error.h"

namespace vandplan::problem {
namespace {

constexpr double most_factor = 1000.0;
constexpr double finest_cells = 0.01;  // least side of cells that limit speeds or have prices [m]

/// Cells [first, last) of a row, and the rows [low, high) that all have them.
struct Block {
  std::int32_t first, last, low, high;
};

/// Runs of occupied cells in a row, as blocks of one row.
std::vector<Block> runs_of(const OccupancyGrid& map, std::int32_t row) {
  std::vector<Block> runs;
  const auto begin = static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns);
  for (std::int32_t column = 0; column < map.columns; ++column) {
    if ((*map.cells)[begin + static_cast<std::size_t>(column)] != Cell::occupied) continue;
    if (runs.empty() || runs.back().last != column) {
      runs.push_back({column, column, row, row + 1});
    }
    runs.back().last = column + 1;
  }
  return runs;
}

Polygon rectangle_of(const OccupancyGrid& map, const Block& block) {
  Polygon corners;
  const auto add = [&](std::int32_t column, std::int32_t row) {
    const Pose corner = compose(map.origin, {column * map.resolution, row * map.resolution, 0.0});
    corners.push_back({corner.x, corner.y});
  };
  add(block.first, block.low);
  add(block.last, block.low);
  add(block.last, block.high);
  add(block.first, block.high);
  return corners;
}

/// Checks the values of the occupancies that a mask has.
void check_values(const Mask& mask, const std::string& where) {
  const auto count =
      static_cast<std::size_t>(mask.map.columns) * static_cast<std::size_t>(mask.map.rows);
  if (mask.percents && mask.percents->size() != count) {
    throw InputError(where, "has " + std::to_string(mask.percents->size()) +
                                " percentages, expected one for each cell of the map");
  }
  if (mask.use == MaskUse::obstacles) return;
  if (mask.map.resolution < finest_cells) {
    throw InputError(where + ".map.resolution", "is " + base::shortest_text(mask.map.resolution) +
                                                    ", expected 0.01 m or more for " +
                                                    std::string(name_of(mask.use)));
  }
  if (mask.percents) {
    check_percents(mask, *mask.percents, where);
    return;
  }
  const std::vector<Cell>& cells = *mask.map.cells;
  const auto has = [&](Cell kind) {
    return std::find(cells.begin(), cells.end(), kind) != cells.end();
  };
  const std::uint8_t of_free = 0, of_occupied = 100;
  if (has(Cell::free)) check_percents(mask, {&of_free, 1}, where);
  if (has(Cell::occupied)) check_percents(mask, {&of_occupied, 1}, where);
}

}  // namespace

void check_percents(const Mask& mask, std::span<const std::uint8_t> percents,
                    const std::string& where) {
  std::array<bool, 256> has{};
  for (const std::uint8_t percent : percents) has[percent] = true;
  for (std::size_t percent = 0; percent < Mask::unknown; ++percent) {
    if (!has[percent]) continue;
    const std::string cell = "has a cell of " + std::to_string(percent) + " %";
    if (percent > 100) throw InputError(where, cell + ", expected 0 to 100");
    const double value = mask.base + mask.multiplier * static_cast<double>(percent);
    if (mask.use == MaskUse::cost && !(value >= 1.0 && value <= most_factor)) {
      throw InputError(where, cell + ", where a metre costs " + base::shortest_text(value) +
                                  " times as much, expected 1 to 1000");
    }
    if (mask.use == MaskUse::max_speed && percent > 0 && !(value > 0.0 && std::isfinite(value))) {
      throw InputError(where, cell + ", where the largest speed is " + base::shortest_text(value) +
                                  ", expected more than 0 m/s");
    }
  }
}

std::vector<Mask> local_masks(const std::vector<Mask>& masks, const Point& origin) {
  std::vector<Mask> local = masks;
  for (std::size_t i = 0; i < local.size(); ++i) {
    try {
      local[i].map = local_map(local[i].map, origin);
    } catch (const InputError& error) {  // names "map.resolution" or another key of a map
      throw InputError("masks[" + std::to_string(i) + "]." + error.where(), error.problem());
    }
    check_values(local[i], "masks[" + std::to_string(i) + "]");
  }
  return local;
}

// A run that an equal run of the row below continues makes the block there higher.
std::vector<Polygon> rectangles_over(const OccupancyGrid& map) {
  std::vector<Polygon> rectangles;
  std::vector<Block> open;
  for (std::int32_t row = 0; row <= map.rows; ++row) {
    std::vector<Block> runs = row < map.rows ? runs_of(map, row) : std::vector<Block>{};
    auto run = runs.begin();
    for (const Block& block : open) {
      while (run != runs.end() && run->first < block.first) ++run;
      if (run != runs.end() && run->first == block.first && run->last == block.last) {
        run->low = block.low;
      } else {
        rectangles.push_back(rectangle_of(map, block));
      }
    }
    open = std::move(runs);
  }
  return rectangles;
}

}  // namespace vandplan::problem

namespace vandplan {

std::string_view name_of(MaskUse use) noexcept {
  switch (use) {
    case MaskUse::obstacles:
      return "obstacles";
    case MaskUse::max_speed:
      return "max_speed";
    case MaskUse::cost:
      break;
  }
  return "cost";
}

Mask speed_mask(OccupancyGrid map, double speed) {
  return {
      .map = std::move(map), .use = MaskUse::max_speed, .base = speed, .multiplier = -speed / 100};
}

Mask cost_mask(OccupancyGrid map, double most) {
  return {.map = std::move(map), .use = MaskUse::cost, .base = 1.0, .multiplier = most / 100};
}

}  // namespace vandplan
