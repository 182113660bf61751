// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/mask_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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
    is_silent_[i] = i == Mask::unknown || (mask.use == MaskUse::cost ? values_[i] == 1.0 : i == 0);
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

// Looks from outside, since a checker has to be made again after each change of the mask: cells in
// the box need not be looked at.
MaskCells::Box MaskCells::speaking() const {
  const std::int32_t columns = mask_.map.columns, rows = mask_.map.rows;
  const auto is_silent = [&](std::int32_t column, std::int32_t row) {
    return is_silent_[percent(column, row)];
  };
  const auto is_silent_row = [&](std::int32_t row) {
    std::int32_t column = 0;
    while (column < columns && is_silent(column, row)) ++column;
    return column == columns;
  };
  Box box{columns, 0, 0, rows};
  while (box.row < rows && is_silent_row(box.row)) ++box.row;
  if (box.row == rows) return {columns, rows, 0, 0};
  while (is_silent_row(box.end_row - 1)) --box.end_row;
  for (std::int32_t row = box.row; row < box.end_row; ++row) {
    std::int32_t column = 0;
    while (column < box.column && is_silent(column, row)) ++column;
    box.column = column;
    column = columns;
    while (column > box.end_column && is_silent(column - 1, row)) --column;
    box.end_column = column;
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
  if (!is_silent_[here]) apply(values_[here], part);
}

void MaskCells::tell_least(const Point& place, double reach, GroundPart& part) const {
  const Pose at = in_cells({place.x, place.y, 0.0});
  const double off = reach / mask_.map.resolution;
  if (!(at.x - off >= box_.column && at.x + off < box_.end_column && at.y - off >= box_.row &&
        at.y + off < box_.end_row)) {
    return;
  }
  const auto cell = [](double value) { return static_cast<std::int32_t>(value); };
  const bool is_cost = mask_.use == MaskUse::cost;
  double least = is_cost ? std::numeric_limits<double>::infinity() : 0.0;
  for (std::int32_t row = cell(at.y - off); row <= cell(at.y + off); ++row) {
    for (std::int32_t column = cell(at.x - off); column <= cell(at.x + off); ++column) {
      const std::uint8_t here = percent(column, row);
      if (is_silent_[here]) return;
      least = is_cost ? std::min(least, values_[here]) : std::max(least, values_[here]);
    }
  }
  apply(least, part);
}

void MaskCells::apply(double value, GroundPart& part) const {
  if (mask_.use == MaskUse::cost) {
    part.cost *= value;
  } else {
    part.max_speed = std::min(part.max_speed, value);
  }
}

}  // namespace vandplan::collision
