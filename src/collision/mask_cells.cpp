// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/mask_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "collision/travel.h"

namespace vandplan::collision {
namespace {

/// Adds the places where the axle crosses one of the lines `first`, `first` + 1, ... to `last`.
/// `height`: its place across the lines; `turns`: between these it moves to one side only.
template <typename Height>
void add_lines(const std::vector<double>& turns, double first, double last, const Height& height,
               std::vector<double>& places) {
  double before = height(turns.front());
  for (std::size_t i = 1; i < turns.size(); ++i) {
    const double after = height(turns[i]);
    const auto [low, high] = std::minmax(before, after);
    for (double line = std::max(first, std::floor(low) + 1); line <= std::min(last, high); ++line) {
      const auto above = [&](double s) { return height(s) - line; };
      places.push_back(crossing(turns[i - 1], turns[i], before - line, after - line, above));
    }
    before = after;
  }
}

}  // namespace

MaskCells::MaskCells(const Mask& mask) : mask_(mask) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    values_[i] = mask.base + mask.multiplier * static_cast<double>(i);
  }
  box_ = speaking();
}

std::uint8_t MaskCells::percent(std::int32_t column, std::int32_t row) const {
  const std::size_t at =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(mask_.map.columns) +
      static_cast<std::size_t>(column);
  if (mask_.percents) return (*mask_.percents)[at];
  const Cell cell = (*mask_.map.cells)[at];
  return cell == Cell::unknown ? Mask::unknown : cell == Cell::occupied ? 100 : 0;
}

bool MaskCells::says_nothing(std::uint8_t percent) const {
  if (percent == Mask::unknown) return true;
  return mask_.use == MaskUse::cost ? values_[percent] == 1.0 : percent == 0;
}

MaskCells::Box MaskCells::speaking() const {
  Box box{mask_.map.columns, mask_.map.rows, 0, 0};
  for (std::int32_t row = 0; row < mask_.map.rows; ++row) {
    for (std::int32_t column = 0; column < mask_.map.columns; ++column) {
      if (says_nothing(percent(column, row))) continue;
      box = {std::min(box.column, column), std::min(box.row, row),
             std::max(box.end_column, column + 1), std::max(box.end_row, row + 1)};
    }
  }
  return box;
}

/// A pose in the frame of the map, in cells.
Pose MaskCells::in_cells(const Pose& pose) const {
  const Pose local = relative(mask_.map.origin, pose);
  return {local.x / mask_.map.resolution, local.y / mask_.map.resolution, local.heading};
}

void MaskCells::add_changes(const Pose& from, const Segment& segment,
                            std::vector<double>& places) const {
  const Pose begin = in_cells(from);
  const double reach = std::abs(segment.length) / mask_.map.resolution;
  if (begin.x + reach < box_.column || begin.x - reach > box_.end_column ||
      begin.y + reach < box_.row || begin.y - reach > box_.end_row) {
    return;
  }
  const auto axle_at = [&](double s) { return in_cells(advance(from, part_of(segment, 0.0, s))); };
  const Travel travel(begin, segment, segment.length < 0 ? -1 : 1);
  add_lines(
      travel.places_along(std::numbers::pi / 2), box_.column, box_.end_column,
      [&](double s) { return axle_at(s).x; }, places);
  add_lines(
      travel.places_along(0.0), box_.row, box_.end_row, [&](double s) { return axle_at(s).y; },
      places);
}

void MaskCells::tell(const Point& place, GroundPart& part) const {
  const Pose at = in_cells({place.x, place.y, 0.0});
  if (!(at.x >= box_.column && at.x < box_.end_column && at.y >= box_.row && at.y < box_.end_row)) {
    return;
  }
  const std::uint8_t here =
      percent(static_cast<std::int32_t>(at.x), static_cast<std::int32_t>(at.y));
  if (says_nothing(here)) return;
  if (mask_.use == MaskUse::cost) {
    part.cost *= values_[here];
  } else {
    part.max_speed = std::min(part.max_speed, values_[here]);
  }
}

}  // namespace vandplan::collision
