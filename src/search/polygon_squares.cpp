// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/polygon_squares.h"

#include <algorithm>
#include <cmath>

#include "geometry/boxes.h"

namespace vandplan::search {
namespace {

// Mean number of polygons in a square, if they lay evenly.
constexpr double polygons_of_square = 2.0;
constexpr double max_squares = 1e6;
constexpr std::int32_t max_columns = 1 << 15;
constexpr std::int64_t squares_of_large = 64;

}  // namespace

PolygonSquares::PolygonSquares(std::span<const Polygon> polygons) : polygons_(polygons) {
  if (polygons.empty()) return;
  std::vector<Bounds> boxes;
  boxes.reserve(polygons.size());
  for (const Polygon& polygon : polygons) boxes.push_back(bounding_box(polygon));
  extent_ = boxes.front();
  for (const Bounds& box : boxes) extent_ = geometry::united(extent_, box);
  const double width = std::max(extent_.x_max - extent_.x_min, 1e-3);
  const double height = std::max(extent_.y_max - extent_.y_min, 1e-3);
  const double squares =
      std::clamp(static_cast<double>(polygons.size()) / polygons_of_square, 1.0, max_squares);
  side_ = std::max(std::sqrt(width * height / squares), std::max(width, height) / max_columns);
  columns_ = static_cast<std::int32_t>(width / side_) + 1;
  rows_ = static_cast<std::int32_t>(height / side_) + 1;
  begins_.assign(index_of(0, rows_) + 1, 0);
  // Polygons are counted, then placed from the back, so that their order is kept.
  const auto for_squares = [&](const Bounds& box, auto visit) {
    for (std::int32_t y = row(box.y_min); y <= row(box.y_max); ++y) {
      for (std::int32_t x = column(box.x_min); x <= column(box.x_max); ++x) visit(index_of(x, y));
    }
  };
  const auto is_large = [&](const Bounds& box) {
    return std::int64_t{column(box.x_max) - column(box.x_min) + 1} *
               (row(box.y_max) - row(box.y_min) + 1) >
           squares_of_large;
  };
  for (const Bounds& box : boxes) {
    if (!is_large(box)) for_squares(box, [&](std::size_t square) { ++begins_[square]; });
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : begins_) begin = sum += begin;
  members_.resize(sum);
  for (std::size_t i = boxes.size(); i-- > 0;) {
    const auto polygon = static_cast<std::uint32_t>(i);
    if (is_large(boxes[i])) {
      large_.push_back(polygon);
    } else {
      for_squares(boxes[i], [&](std::size_t square) { members_[--begins_[square]] = polygon; });
    }
  }
}

std::int32_t PolygonSquares::column(double x) const noexcept {
  return static_cast<std::int32_t>(std::clamp((x - extent_.x_min) / side_, 0.0, columns_ - 1.0));
}

std::int32_t PolygonSquares::row(double y) const noexcept {
  return static_cast<std::int32_t>(std::clamp((y - extent_.y_min) / side_, 0.0, rows_ - 1.0));
}

}  // namespace vandplan::search
