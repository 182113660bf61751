// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/masks.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "problem/checks.h"
#include "vandplan/input_error.h"

namespace vandplan::problem {
namespace {

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

}  // namespace

std::vector<Mask> local_masks(const std::vector<Mask>& masks, const Point& origin) {
  std::vector<Mask> local = masks;
  for (std::size_t i = 0; i < local.size(); ++i) {
    try {
      local[i].map = local_map(local[i].map, origin);
    } catch (const InputError& error) {  // names "map.resolution" or another key of a map
      throw InputError("masks[" + std::to_string(i) + "]." + error.where(), error.problem());
    }
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
