// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/box_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vandplan::geometry {
namespace {

/// Orders `items` so that every run of eight, of sixty-four and so on that begins at a multiple of
/// its size is compact. Halves the items across their longer extent, at such multiples.
void order(std::span<const Bounds> boxes, std::span<std::uint32_t> items) {
  constexpr std::size_t fan_out = box_fan_out;
  if (items.size() <= fan_out) return;
  const auto centre = [&](std::uint32_t i) {
    return Point{boxes[i].x_min + boxes[i].x_max, boxes[i].y_min + boxes[i].y_max};
  };
  std::vector<Point> centres;
  for (const std::uint32_t i : items) centres.push_back(centre(i));
  const Bounds extent = bounding_box(centres);
  const bool along_x = extent.x_max - extent.x_min > extent.y_max - extent.y_min;
  std::size_t unit = fan_out;
  while (unit * fan_out < items.size()) unit *= fan_out;
  const std::size_t half = std::max<std::size_t>(1, (items.size() + unit) / (2 * unit)) * unit;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double at_a = along_x ? centre(a).x : centre(a).y;
                     const double at_b = along_x ? centre(b).x : centre(b).y;
                     return at_a != at_b ? at_a < at_b : a < b;
                   });
  order(boxes, items.first(half));
  order(boxes, items.subspan(half));
}

}  // namespace

std::vector<std::uint32_t> spatial_order(std::span<const Bounds> boxes) {
  std::vector<std::uint32_t> items(boxes.size());
  std::iota(items.begin(), items.end(), 0U);
  order(boxes, items);
  return items;
}

BoxTree::BoxTree(std::span<const Bounds> boxes) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::vector<Box> level;
  for (const Bounds& box : boxes) level.push_back(outer(box));
  while (!level.empty()) {
    std::vector<Block> blocks((level.size() + fan_out - 1) / fan_out);
    std::vector<Box> above(blocks.size(), Box{infinity, -infinity, infinity, -infinity});
    for (std::size_t i = 0; i < blocks.size() * fan_out; ++i) {
      // Boxes that pad the last block overlap nothing.
      const Box box = i < level.size() ? level[i] : Box{infinity, -infinity, infinity, -infinity};
      Block& block = blocks[i / fan_out];
      Box& whole = above[i / fan_out];
      block.x_min[i % fan_out] = box.x_min;
      block.x_max[i % fan_out] = box.x_max;
      block.y_min[i % fan_out] = box.y_min;
      block.y_max[i % fan_out] = box.y_max;
      whole = {std::min(whole.x_min, box.x_min), std::max(whole.x_max, box.x_max),
               std::min(whole.y_min, box.y_min), std::max(whole.y_max, box.y_max)};
    }
    levels_.push_back(std::move(blocks));
    level = std::move(above);
    if (level.size() == 1) break;
  }
}

BoxTree::Box BoxTree::outer(const Bounds& box) {
  // Rounding to float moves a number by 2^-24 of its size at most.
  const auto slack = [](double value) { return std::abs(value) * 0x1p-23 + 1e-30; };
  return {static_cast<float>(box.x_min - slack(box.x_min)),
          static_cast<float>(box.x_max + slack(box.x_max)),
          static_cast<float>(box.y_min - slack(box.y_min)),
          static_cast<float>(box.y_max + slack(box.y_max))};
}

}  // namespace vandplan::geometry
