// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/distance_field.h"

#include <cmath>
#include <limits>
#include <span>

namespace vandplan::geometry {
namespace {

constexpr std::uint8_t far = 255;  // this far up and down, or further

/// [1] How far up or down the nearest corner of a blocked cell is, for every corner.
std::vector<std::uint8_t> column_distances(const BitGrid& blocked, std::size_t columns,
                                           std::size_t rows) {
  std::vector<std::uint8_t> distances(columns * rows, far);
  for (std::size_t y = 0; y < rows; ++y) {
    std::uint8_t* const row = distances.data() + y * columns;
    const auto mark = [&](std::int32_t cell_row) {
      const CellBox box{0, blocked.columns() - 1, cell_row, cell_row};
      (void)blocked.any_run(box, [&](std::int32_t, std::int32_t begin, std::int32_t end) {
        std::fill(row + begin, row + end + 1, std::uint8_t{0});
        return false;
      });
    };
    mark(static_cast<std::int32_t>(y) - 1);
    mark(static_cast<std::int32_t>(y));
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

/// The parabolas (x - centre)^2 + height that are the least somewhere, from left to right.
struct Envelope {
  struct Parabola {
    std::int64_t centre, height;
    std::int64_t begin;  // of where it is the least
  };
  std::vector<Parabola> parts;

  void add(std::int64_t centre, std::int64_t height) {
    while (!parts.empty()) {
      const Parabola& last = parts.back();
      // Where the new one gets below the last one: the first whole number from here on.
      const std::int64_t above =
          (centre * centre - last.centre * last.centre) + height - last.height;
      const std::int64_t begin = above < 0 ? 0 : above / (2 * (centre - last.centre)) + 1;
      if (begin > last.begin) {
        parts.push_back({centre, height, begin});
        return;
      }
      parts.pop_back();
    }
    parts.push_back({centre, height, 0});
  }
};

/// [2] The least of all parabolas over a row of column distances.
void fill_row(std::span<const std::uint8_t> distances, Envelope& envelope,
              std::span<std::uint16_t> squares) {
  constexpr std::int64_t most = std::int64_t{far} * far;
  envelope.parts.clear();
  for (std::size_t x = 0; x < distances.size(); ++x) {
    const std::int64_t distance = distances[x];
    if (distance < far) envelope.add(static_cast<std::int64_t>(x), distance * distance);
  }
  std::fill(squares.begin(), squares.end(), static_cast<std::uint16_t>(most));
  for (std::size_t i = 0; i < envelope.parts.size(); ++i) {
    const auto& [centre, height, begin] = envelope.parts[i];
    const auto size = static_cast<std::int64_t>(squares.size());
    const std::int64_t end = i + 1 < envelope.parts.size() ? envelope.parts[i + 1].begin : size;
    for (std::int64_t x = begin; x < std::min(end, size); ++x) {
      const std::int64_t square = (x - centre) * (x - centre) + height;
      squares[static_cast<std::size_t>(x)] = static_cast<std::uint16_t>(std::min(square, most));
    }
  }
}

/// The squared distances of all corners from the nearest blocked cell, row by row.
std::vector<std::uint16_t> corner_squares(const BitGrid& blocked) {
  const std::size_t columns = static_cast<std::size_t>(blocked.columns()) + 1;
  const std::size_t rows = static_cast<std::size_t>(blocked.rows()) + 1;
  std::vector<std::uint16_t> squares(columns * rows);
  const std::vector<std::uint8_t> distances = column_distances(blocked, columns, rows);
  Envelope envelope;
  for (std::size_t y = 0; y < rows; ++y) {
    fill_row(std::span(distances).subspan(y * columns, columns), envelope,
             std::span(squares).subspan(y * columns, columns));
  }
  return squares;
}

/// The least of the corners of every block of 2^shift times 2^shift cells, those on its sides, too.
std::vector<std::uint16_t> least_in_blocks(const std::vector<std::uint16_t>& corners,
                                           std::size_t columns, int shift) {
  const std::size_t rows = corners.size() / columns;
  const std::size_t side = std::size_t{1} << shift;
  std::vector<std::uint16_t> result;
  std::vector<std::uint16_t> row(columns);
  for (std::size_t y = 0; y + 1 < rows; y += side) {
    std::fill(row.begin(), row.end(), std::numeric_limits<std::uint16_t>::max());
    for (std::size_t i = y; i < std::min(y + side + 1, rows); ++i) {
      const std::uint16_t* const other = corners.data() + i * columns;
      for (std::size_t x = 0; x < columns; ++x) row[x] = std::min(row[x], other[x]);
    }
    for (std::size_t x = 0; x + 1 < columns; x += side) {
      const auto begin = row.begin() + static_cast<std::ptrdiff_t>(x);
      const std::size_t count = std::min(side + 1, columns - x);
      result.push_back(*std::min_element(begin, begin + static_cast<std::ptrdiff_t>(count)));
    }
  }
  return result;
}

}  // namespace

DistanceField::DistanceField(const BlockedCells& cells, int coarseness)
    : last_x_(cells.columns() - 0.5),
      last_y_(cells.rows() - 0.5),
      outside_is_free_(cells.is_blocked(0, 0) ? 0.0 : 1.0),
      columns_(static_cast<std::size_t>(cells.columns()) + 1),
      squares_(corner_squares(cells.blocked())) {
  build_blocks(cells, coarseness);
}

// [3] The nearest point of a block is a corner of a cell. Beyond what the field knows it is as far
// as the nearest block with a blocked cell.
void DistanceField::build_blocks(const BlockedCells& cells, int coarseness) {
  const BitGrid grid = blocks_of(cells.blocked(), coarseness);
  block_columns_ = static_cast<std::size_t>(grid.columns());
  const double side = std::ldexp(1.0, coarseness);
  per_block_ = 1 / side;
  const auto near = least_in_blocks(squares_, columns_, coarseness);
  const auto far_away = least_in_blocks(corner_squares(grid), block_columns_ + 1, 0);
  blocks_.reserve(near.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    double distance = std::sqrt(static_cast<double>(near[i]));
    if (distance >= furthest) {
      distance = std::max(distance, side * std::sqrt(static_cast<double>(far_away[i])));
    }
    blocks_.push_back(static_cast<std::uint16_t>(std::min(distance * parts, 65535.0)));
  }
}

DistanceField::Range DistanceField::around(const Point& point) const noexcept {
  const double x = std::clamp(point.x, 0.0, last_x_ + 0.5);
  const double y = std::clamp(point.y, 0.0, last_y_ + 0.5);
  const double i = std::floor(x + 0.5);
  const double j = std::floor(y + 0.5);
  const double distance =
      std::sqrt(square_at(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)));
  const double aside = std::sqrt((x - i) * (x - i) + (y - j) * (y - j));
  const double outside = std::abs(point.x - x) + std::abs(point.y - y);
  const double most =
      distance < furthest ? distance + aside + outside : std::numeric_limits<double>::infinity();
  return {distance - aside, most};
}

}  // namespace vandplan::geometry
