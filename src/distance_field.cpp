// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "distance_field.h"

#include <span>

namespace vandplan {
namespace {

constexpr std::uint8_t far = 255;  // this far up and down, or further

/// [1] How far up or down the nearest corner of a blocked cell is, for every corner.
std::vector<std::uint8_t> column_distances(const BlockedCells& cells, std::size_t columns,
                                           std::size_t rows) {
  std::vector<std::uint8_t> distances(columns * rows, far);
  for (std::size_t y = 0; y < rows; ++y) {
    std::uint8_t* const row = distances.data() + y * columns;
    const auto mark = [&](std::int32_t cell_row) {
      const CellBox box{0, cells.columns() - 1, cell_row, cell_row};
      (void)cells.blocked().any_run(box, [&](std::int32_t, std::int32_t begin, std::int32_t end) {
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

}  // namespace

DistanceField::DistanceField(const BlockedCells& cells, int coarseness) {
  const std::size_t columns = static_cast<std::size_t>(cells.columns()) + 1;
  const std::size_t rows = static_cast<std::size_t>(cells.rows()) + 1;
  fine_ = {1.0, static_cast<double>(columns - 1), static_cast<double>(rows - 1), columns,
           std::vector<std::uint16_t>(columns * rows)};
  const std::vector<std::uint8_t> distances = column_distances(cells, columns, rows);
  Envelope envelope;
  for (std::size_t y = 0; y < rows; ++y) {
    fill_row(std::span(distances).subspan(y * columns, columns), envelope,
             std::span(fine_.squares).subspan(y * columns, columns));
  }
  // The last coarse corner may lie beyond the frame: it takes the distance of the last fine one,
  // from which it is less than a step away; so points near it look no nearer than they are.
  const std::size_t step = std::size_t{1} << coarseness;
  coarse_ = {static_cast<double>(step), fine_.last_x, fine_.last_y, (columns - 1) / step + 2, {}};
  for (std::size_t y = 0; y < rows + step; y += step) {
    for (std::size_t i = 0; i < coarse_.columns; ++i) {
      const std::size_t at = std::min(y, rows - 1) * columns + std::min(i * step, columns - 1);
      coarse_.squares.push_back(fine_.squares[at]);
    }
  }
}

}  // namespace vandplan
