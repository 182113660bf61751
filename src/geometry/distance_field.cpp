// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/distance_field.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace vandplan::geometry {
namespace {

constexpr std::uint8_t far = CornerSquares::furthest;  // distance of this much or more
constexpr std::uint16_t beyond = far * far;

/// [1] Column distances of the corners in a box: how far up or down the nearest corner of a set
/// cell is. Only corners in the box count.
std::vector<std::uint8_t> column_distances(const BitGrid& cells, const CellBox& corners) {
  const auto columns = static_cast<std::size_t>(corners.x_max - corners.x_min) + 1;
  const auto rows = static_cast<std::size_t>(corners.y_max - corners.y_min) + 1;
  std::vector<std::uint8_t> distances(columns * rows, far);
  for (std::size_t i = 0; i < rows; ++i) {
    std::uint8_t* const row = distances.data() + i * columns;
    const auto y = corners.y_min + static_cast<std::int32_t>(i);
    (void)cells.any_run({corners.x_min - 1, corners.x_max, y - 1, y},
                        [&](std::int32_t, std::int32_t begin, std::int32_t end) {
                          std::fill(row + (std::max(begin, corners.x_min) - corners.x_min),
                                    row + (std::min(end, corners.x_max) - corners.x_min) + 1,
                                    std::uint8_t{0});
                          return false;
                        });
  }
  const auto spread = [&](std::size_t from, std::size_t to) {
    const std::uint8_t* const near = distances.data() + from * columns;
    std::uint8_t* const row = distances.data() + to * columns;
    for (std::size_t x = 0; x < columns; ++x) {
      const auto further = static_cast<std::uint8_t>(near[x] == far ? far : near[x] + 1);
      row[x] = std::min(row[x], further);
    }
  };
  for (std::size_t y = 1; y < rows; ++y) spread(y - 1, y);
  for (std::size_t y = rows - 1; y-- > 0;) spread(y + 1, y);
  return distances;
}

/// The lower envelope of parabolas (x - centre)^2 + height, from left to right.
struct Envelope {
  struct Parabola {
    std::int64_t centre, height;
    std::int64_t begin;  // first x where it is the lowest
  };
  std::vector<Parabola> parts;

  void add(std::int64_t centre, std::int64_t height) {
    while (!parts.empty()) {
      const Parabola& last = parts.back();
      // The new parabola is below the last one for all whole x > above / twice.
      const std::int64_t above =
          (centre * centre - last.centre * last.centre) + height - last.height;
      const std::int64_t twice = 2 * (centre - last.centre);
      if (above >= last.begin * twice) {
        // Most centres are neighbours, and a division by a known 2 is a shift.
        parts.push_back({centre, height, (twice == 2 ? above / 2 : above / twice) + 1});
        return;
      }
      parts.pop_back();
    }
    parts.push_back({centre, height, 0});
  }
};

/// [2] Lowers `squares` to the lower envelope of the parabolas over a row of column distances. The
/// squares begin `shift` places after the distances, or before them if `shift` is negative.
void lower_row(std::span<const std::uint8_t> distances, std::int64_t shift, Envelope& envelope,
               std::span<std::uint16_t> squares) {
  // Places are counted from the leftmost place of both rows.
  const std::int64_t first_source = std::max<std::int64_t>(-shift, 0);
  const std::int64_t first = first_source + shift;
  const std::int64_t last = first + std::ssize(squares);
  envelope.parts.clear();
  for (std::size_t x = 0; x < distances.size(); ++x) {
    const std::int64_t distance = distances[x];
    if (distance == far) continue;
    envelope.add(first_source + static_cast<std::int64_t>(x), distance * distance);
  }
  for (std::size_t i = 0; i < envelope.parts.size(); ++i) {
    const auto& [centre, height, begin] = envelope.parts[i];
    const bool is_last = i + 1 == envelope.parts.size();
    const std::int64_t from = std::max({begin, first, centre - far});
    const std::int64_t to = std::min(is_last ? last : envelope.parts[i + 1].begin, last);
    const std::int64_t end = std::min<std::int64_t>(to, centre + far);
    if (from >= end) continue;
    const auto aside = static_cast<std::int32_t>(from - centre);
    const auto up = static_cast<std::int32_t>(height);
    std::uint16_t* const row = squares.data() + (from - first);
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(end - from); ++k) {
      const std::int32_t square = (aside + k) * (aside + k) + up;
      row[k] = static_cast<std::uint16_t>(std::min<std::int32_t>(square, row[k]));
    }
  }
}

/// The least square of the corners of each block of 2^shift times 2^shift cells, corners on its
/// sides included.
std::vector<std::uint16_t> least_in_blocks(const CornerSquares& squares, const CellBox& blocks,
                                           int shift) {
  const std::int32_t side = std::int32_t{1} << shift;
  const std::int32_t first = blocks.x_min * side;
  const std::int32_t last = std::min((blocks.x_max + 1) * side, squares.columns() - 1);
  std::vector<std::uint16_t> result;
  std::vector<std::uint16_t> row(static_cast<std::size_t>(last - first) + 1);
  for (std::int32_t y = blocks.y_min; y <= blocks.y_max; ++y) {
    std::fill(row.begin(), row.end(), std::numeric_limits<std::uint16_t>::max());
    for (std::int32_t i = y * side; i <= std::min((y + 1) * side, squares.rows() - 1); ++i) {
      const std::uint16_t* const other = squares.from(first, i);
      for (std::size_t x = 0; x < row.size(); ++x) row[x] = std::min(row[x], other[x]);
    }
    for (std::int32_t x = 0; x < last - first; x += side) {
      const auto begin = row.begin() + x;
      result.push_back(*std::min_element(begin, begin + std::min(side, last - first - x) + 1));
    }
  }
  return result;
}

/// Distance from the nearest point of a block to blocked cells [cells]. `near`: least square of its
/// corners' distances from blocked squares [sides of a square]. `far_away`: least square of their
/// distances from blocks with a blocked cell [sides of a block].
double distance_of(std::uint16_t near, double side, std::uint16_t far_away, double block_side) {
  const double distance = side * std::sqrt(static_cast<double>(near));
  if (distance < side * DistanceField::furthest) return distance;
  return std::max(distance, block_side * std::sqrt(static_cast<double>(far_away)));
}

std::uint16_t in_parts(double distance) {
  return static_cast<std::uint16_t>(std::min(distance * DistanceField::parts, 65535.0));
}

/// The least whole number whose square is at least `square`.
std::int32_t root_of(std::uint16_t square) {
  return static_cast<std::int32_t>(std::ceil(std::sqrt(static_cast<double>(square))));
}

}  // namespace

CornerSquares::CornerSquares(const BitGrid& cells)
    : columns_(cells.columns() + 1),
      rows_(cells.rows() + 1),
      squares_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), beyond) {
  std::vector<Stretch> all;
  all.reserve(static_cast<std::size_t>(rows_));
  for (std::int32_t y = 0; y < rows_; ++y) all.push_back({y, 0, columns_, 0, columns_ - 1});
  lower(cells, all);
}

/// Lowers the squares in stretches of neighbouring rows, by column distances.
void CornerSquares::lower(const BitGrid& cells, const std::vector<Stretch>& stretches) {
  CellBox box{columns_, -1, std::max(stretches.front().y - furthest, 0),
              std::min(stretches.back().y + furthest, rows_ - 1)};
  for (const Stretch& stretch : stretches) {
    box.x_min = std::min(box.x_min, stretch.first_source);
    box.x_max = std::max(box.x_max, stretch.last_source);
  }
  const std::vector<std::uint8_t> distances = column_distances(cells, box);
  const auto width = static_cast<std::size_t>(box.x_max - box.x_min) + 1;
  Envelope envelope;
  for (const auto& [y, begin, end, first, last] : stretches) {
    const std::size_t row = static_cast<std::size_t>(y - box.y_min) * width;
    lower_row(
        std::span(distances).subspan(row + static_cast<std::size_t>(first - box.x_min),
                                     static_cast<std::size_t>(last - first) + 1),
        begin - first, envelope,
        std::span(squares_).subspan(index_of(begin, y), static_cast<std::size_t>(end - begin)));
  }
}

// A corner that is nearer to another set cell than to every changed cell keeps its square. The
// corner beside the stretch is one that does. Corners of the stretch find no nearer cell beyond the
// nearest cell of that corner, so sources end there.
CornerSquares::Stretch CornerSquares::affected(std::int32_t y, const CellBox& changed) const {
  const auto beside = [](std::int32_t place, std::int32_t low, std::int32_t high) {
    return std::max({low - place, place - high, 0});
  };
  const std::int32_t dy = beside(y, changed.y_min, changed.y_max + 1);
  const std::uint16_t* const row = from(0, y);
  // Least number of corners that keep their squares, from corner x on to either side: from one
  // corner to the next, neither distance changes by more than 1.
  const auto staying = [&](std::int32_t x) {
    const std::int32_t dx = beside(x, changed.x_min, changed.x_max + 1);
    const std::int32_t square = dx * dx + dy * dy;
    if (square <= row[x] && square < furthest * furthest) return 0;
    const double gap =
        std::sqrt(static_cast<double>(square)) - std::sqrt(static_cast<double>(row[x]));
    return std::max(static_cast<std::int32_t>(gap / 2), 1);
  };
  std::int32_t begin = std::max(changed.x_min - furthest, 0);
  std::int32_t end = std::min(changed.x_max + 1 + furthest, columns_ - 1) + 1;
  while (begin < end) {
    const std::int32_t count = staying(begin);
    if (count == 0) break;
    begin = std::min(begin + count, end);
  }
  while (end > begin) {
    const std::int32_t count = staying(end - 1);
    if (count == 0) break;
    end = std::max(end - count, begin);
  }
  const std::int32_t left = begin == 0 ? 0 : begin - 1 - root_of(row[begin - 1]);
  const std::int32_t right = end == columns_ ? columns_ - 1 : end + root_of(row[end]);
  return {y, begin, end, std::max(left, 0), std::min(right, columns_ - 1)};
}

/// Whether a corner of the cells in `changed` belonged to a set cell before and does no more.
bool CornerSquares::is_less(const BitGrid& cells, const CellBox& changed) const {
  for (std::int32_t y = changed.y_min; y <= changed.y_max + 1; ++y) {
    for (std::int32_t x = changed.x_min; x <= changed.x_max + 1; ++x) {
      if (*from(x, y) != 0) continue;
      const CellBox around = shared({x - 1, x, y - 1, y}, {0, columns_ - 2, 0, rows_ - 2});
      if (!cells.any_run(around, [](std::int32_t, std::int32_t, std::int32_t) { return true; })) {
        return true;
      }
    }
  }
  return false;
}

CellBox CornerSquares::update(const BitGrid& cells, const CellBox& changed) {
  // If no corner has lost its set cell, squares only fall, and only changed cells lower them.
  const bool forgets = is_less(cells, changed);
  std::vector<Stretch> stretches;
  CellBox box{columns_, -1, rows_, -1};
  const std::int32_t last = std::min(changed.y_max + 1 + furthest, rows_ - 1);
  for (std::int32_t y = std::max(changed.y_min - furthest, 0); y <= last; ++y) {
    Stretch stretch = affected(y, changed);
    if (stretch.begin == stretch.end) continue;
    if (forgets) {
      std::uint16_t* const row = squares_.data() + index_of(0, y);
      std::fill(row + stretch.begin, row + stretch.end, beyond);
    } else {
      stretch.first_source = changed.x_min;
      stretch.last_source = changed.x_max + 1;
    }
    stretches.push_back(stretch);
    box = {std::min(box.x_min, stretch.begin), std::max(box.x_max, stretch.end - 1),
           std::min(box.y_min, y), y};
  }
  if (!stretches.empty()) lower(cells, stretches);
  return box;
}

int field_shift(std::int64_t cells) noexcept {
  constexpr std::int64_t most = 100'000'000;
  int shift = 0;
  while (cells >> (2 * shift) > most) ++shift;
  return shift;
}

DistanceField::DistanceField(const BlockedCells& cells, int coarseness, int shift)
    : last_x_(cells.columns() - 0.5),
      last_y_(cells.rows() - 0.5),
      outside_is_free_(cells.is_blocked(0, 0) ? 0.0 : 1.0),
      shift_(shift),
      side_(std::ldexp(1.0, shift)),
      per_side_(1 / side_),
      blocked_squares_(shift == 0 ? BitGrid(0, 0) : blocks_of(cells.blocked(), shift)),
      squares_(shift == 0 ? cells.blocked() : blocked_squares_),
      coarseness_(coarseness),
      per_block_(std::ldexp(1.0, -coarseness)),
      blocked_blocks_(blocks_of(cells.blocked(), coarseness)),
      between_blocks_(blocked_blocks_),
      block_columns_(static_cast<std::size_t>(blocked_blocks_.columns())),
      blocks_(block_columns_ * static_cast<std::size_t>(blocked_blocks_.rows())) {
  assert(coarseness >= shift);
  fill_blocks({0, blocked_blocks_.columns() - 1, 0, blocked_blocks_.rows() - 1});
}

// [3] The point of a block that is nearest to blocked squares is a corner of a square. Beyond the
// range of the field, the distance from the nearest block with a blocked cell counts.
void DistanceField::fill_blocks(const CellBox& blocks) {
  const double side = 1 / per_block_;
  const auto near = least_in_blocks(squares_, blocks, coarseness_ - shift_);
  const auto far_away = least_in_blocks(between_blocks_, blocks, 0);
  std::size_t i = 0;
  for (std::int32_t y = blocks.y_min; y <= blocks.y_max; ++y) {
    for (std::int32_t x = blocks.x_min; x <= blocks.x_max; ++x, ++i) {
      blocks_[static_cast<std::size_t>(y) * block_columns_ + static_cast<std::size_t>(x)] =
          in_parts(distance_of(near[i], side_, far_away[i], side));
    }
  }
}

void DistanceField::update(const BlockedCells& cells, const CellBox& changed) {
  const CellBox all{0, blocked_blocks_.columns() - 1, 0, blocked_blocks_.rows() - 1};
  const auto blocks_at = [&](const CellBox& box, int shift) {
    return shared({box.x_min >> shift, box.x_max >> shift, box.y_min >> shift, box.y_max >> shift},
                  all);
  };
  const auto left_of = [](const CellBox& corners) {
    return CellBox{corners.x_min - 1, corners.x_max, corners.y_min - 1, corners.y_max};
  };
  CellBox corners{0, -1, 0, -1};
  if (shift_ == 0) {
    corners = squares_.update(cells.blocked(), changed);
  } else if (update_blocks(cells.blocked(), shift_, changed, blocked_squares_)) {
    corners = squares_.update(blocked_squares_, {changed.x_min >> shift_, changed.x_max >> shift_,
                                                 changed.y_min >> shift_, changed.y_max >> shift_});
  }
  CellBox far_away{0, -1, 0, -1};
  if (update_blocks(cells.blocked(), coarseness_, changed, blocked_blocks_)) {
    far_away = between_blocks_.update(blocked_blocks_, blocks_at(changed, coarseness_));
  }
  if (!is_empty(corners)) fill_blocks(blocks_at(left_of(corners), coarseness_ - shift_));
  if (is_empty(far_away)) return;
  // Only blocks beyond the range of the field get their distance from blocks.
  const CellBox blocks = blocks_at(left_of(far_away), 0);
  const auto squares = least_in_blocks(between_blocks_, blocks, 0);
  std::size_t i = 0;
  for (std::int32_t y = blocks.y_min; y <= blocks.y_max; ++y) {
    for (std::int32_t x = blocks.x_min; x <= blocks.x_max; ++x, ++i) {
      std::uint16_t& block =
          blocks_[static_cast<std::size_t>(y) * block_columns_ + static_cast<std::size_t>(x)];
      if (block >= side_ * furthest * parts) {
        block = in_parts(distance_of(beyond, side_, squares[i], 1 / per_block_));
      }
    }
  }
}

DistanceField::Range DistanceField::around(const Point& point) const noexcept {
  const double x = std::clamp(point.x, 0.0, last_x_ + 0.5);
  const double y = std::clamp(point.y, 0.0, last_y_ + 0.5);
  const double i = std::floor(x * per_side_ + 0.5);
  const double j = std::floor(y * per_side_ + 0.5);
  const double squares =
      std::sqrt(square_at(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)));
  const double dx = x - i * side_;
  const double dy = y - j * side_;
  const double aside = std::sqrt(dx * dx + dy * dy);
  const double outside = std::abs(point.x - x) + std::abs(point.y - y);
  // The blocked cell of a square may lie in the corner that is furthest away.
  const double within = std::numbers::sqrt2 * (side_ - 1);
  const double most = squares < furthest ? side_ * squares + within + aside + outside
                                         : std::numeric_limits<double>::infinity();
  return {side_ * squares - aside, most};
}

}  // namespace vandplan::geometry
