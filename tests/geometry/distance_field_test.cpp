// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/distance_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/cases.h"
#include "support/grids.h"

namespace vandplan {
namespace {

/// The squared distance of a point, in cells of the frame, from the nearest blocked square.
double squared_distance(const geometry::BlockedCells& cells, double x, double y) {
  double least = std::numeric_limits<double>::infinity();
  for (std::int32_t row = 0; row < cells.rows(); ++row) {
    for (std::int32_t column = 0; column < cells.columns(); ++column) {
      if (!cells.is_blocked(column, row)) continue;
      const double dx = std::max({column - x, x - column - 1, 0.0});
      const double dy = std::max({row - y, y - row - 1, 0.0});
      least = std::min(least, dx * dx + dy * dy);
    }
  }
  return least;
}

OccupancyGrid any_grid(Rng& rng) {
  const auto side = [&] { return static_cast<std::int32_t>(uniform(1, 90, rng)); };
  OccupancyGrid grid = random_grid(side(), side(), std::pow(uniform01(rng), 4), rng);
  grid.unknown_is_free = uniform01(rng) < 0.7;
  return grid;
}

TEST(DistanceField, IsExactAtTheCornersOfCells) {
  for_each_case(1, 60, [](Rng& rng) {
    const geometry::BlockedCells cells(any_grid(rng));
    const geometry::DistanceField field(cells, 2);
    for (std::int32_t y = 0; y <= cells.rows(); ++y) {
      for (std::int32_t x = 0; x <= cells.columns(); ++x) {
        const double expected = std::min(65025.0, squared_distance(cells, x, y));
        ASSERT_EQ(field.square_at(x, y), expected) << x << " " << y;
      }
    }
  });
}

/// How far what a field says may be off [cells]: between both bounds, and below, inside and
/// outside.
struct Leeway {
  double between, below, outside_below;
};

void expect_bounds(const geometry::BlockedCells& cells, const geometry::DistanceField& field,
                   const Leeway& leeway, Rng& rng) {
  for (int i = 0; i < 500; ++i) {
    const double x = uniform(-20, cells.columns() + 20, rng);
    const double y = uniform(-20, cells.rows() + 20, rng);
    const double expected = std::sqrt(squared_distance(cells, x, y));
    const auto [least, most] = field.around({x, y});
    const double at_least = field.at_least({x, y});
    EXPECT_LE(least, expected + 1e-12);
    EXPECT_LE(at_least, expected + 1e-12);
    EXPECT_GE(most, expected - 1e-12);
    if (expected > geometry::DistanceField::furthest) continue;
    const bool is_inside = x >= 0 && y >= 0 && x <= cells.columns() && y <= cells.rows();
    EXPECT_LE(most - least, is_inside ? leeway.between : 60);
    EXPECT_GE(at_least, expected - (is_inside ? leeway.below : leeway.outside_below));
  }
}

TEST(DistanceField, BoundsDistancesEverywhere) {
  for_each_case(2, 60, [](Rng& rng) {
    const geometry::BlockedCells cells(any_grid(rng));
    expect_bounds(cells, geometry::DistanceField(cells, 2), {1.4143, 4 * 1.4143 + 0.1, 60}, rng);
  });
}

TEST(DistanceField, OfLargerSquaresBoundsDistancesEverywhere) {
  for_each_case(4, 60, [](Rng& rng) {
    const geometry::BlockedCells cells(any_grid(rng));
    const Leeway leeway{3 * 1.4143, 9 * 1.4143 + 0.1, 70};
    expect_bounds(cells, geometry::DistanceField(cells, 3, 1), leeway, rng);
  });
}

TEST(DistanceField, HasLargerSquaresForMoreThan100MillionCells) {
  EXPECT_EQ(geometry::field_shift(1), 0);
  EXPECT_EQ(geometry::field_shift(100'000'000), 0);
  EXPECT_EQ(geometry::field_shift(101'000'000), 1);
  EXPECT_EQ(geometry::field_shift(400'000'000), 1);
}

TEST(DistanceField, KnowsNoMoreThan255Cells) {
  std::vector<std::string> rows(3, std::string(400, '.'));
  rows[1][0] = '#';
  OccupancyGrid grid = grid_of(rows, 1);
  grid.unknown_is_free = true;
  const geometry::DistanceField field{geometry::BlockedCells(grid), 3};
  EXPECT_EQ(field.square_at(2 + 254, 2), 254U * 254U);
  EXPECT_EQ(field.square_at(2 + 255, 2), 65025U);
  EXPECT_EQ(field.square_at(2 + 300, 2), 65025U);
  EXPECT_EQ(field.around({2 + 254, 2}).most, 254);
  EXPECT_TRUE(std::isinf(field.around({2 + 300, 2}).most));
}

TEST(DistanceField, KnowsRoughlyHowFarItIsBeyond255Cells) {
  std::vector<std::string> rows(3, std::string(2500, '.'));
  rows[1][0] = '#';
  OccupancyGrid grid = grid_of(rows, 1);
  grid.unknown_is_free = true;
  const geometry::DistanceField field{geometry::BlockedCells(grid), 3};
  for (const double distance : {100.0, 254.0, 256.0, 300.0, 2000.0, 2400.0}) {
    const double least = field.at_least({2 + distance, 2});
    EXPECT_LE(least, distance);
    EXPECT_GE(least, std::min(distance, 255.0 * 8) - 16);
  }
}

CellRange any_range(const OccupancyGrid& grid, std::int32_t most, Rng& rng) {
  const auto part = [&](std::int32_t count, std::int32_t& first, std::int32_t& size) {
    size = static_cast<std::int32_t>(uniform(1, std::min(most, count) + 1, rng));
    first = static_cast<std::int32_t>(uniform(0, count - size + 1, rng));
  };
  CellRange range;
  part(grid.columns, range.column, range.columns);
  part(grid.rows, range.row, range.rows);
  return range;
}

/// Other cells in a range: of one kind, or of all kinds.
void write_any(OccupancyGrid& grid, const CellRange& range, Rng& rng) {
  auto cells = *grid.cells;
  const auto any_cell = [&] { return static_cast<Cell>(static_cast<int>(uniform(0, 3, rng))); };
  const bool is_mixed = uniform01(rng) < 0.3;
  const Cell one = any_cell();
  for (std::int32_t row = range.row; row < range.row + range.rows; ++row) {
    for (std::int32_t column = range.column; column < range.column + range.columns; ++column) {
      cells[static_cast<std::size_t>(row * grid.columns + column)] = is_mixed ? any_cell() : one;
    }
  }
  grid.cells = std::move(cells);
}

void expect_same(const geometry::BlockedCells& cells, const geometry::BlockedCells& expected) {
  for (std::int32_t y = 0; y < cells.rows(); ++y) {
    for (std::int32_t x = 0; x < cells.columns(); ++x) {
      ASSERT_EQ(cells.is_blocked(x, y), expected.is_blocked(x, y)) << x << " " << y;
      ASSERT_EQ(cells.edges().is_set(x, y), expected.edges().is_set(x, y)) << x << " " << y;
    }
  }
}

void expect_same(const geometry::DistanceField& field, const geometry::DistanceField& expected,
                 const OccupancyGrid& grid, int shift) {
  for (std::int32_t y = 0; y <= grid.rows + 2; ++y) {
    for (std::int32_t x = 0; x <= grid.columns + 2; ++x) {
      const std::int32_t i = x >> shift;
      const std::int32_t j = y >> shift;
      ASSERT_EQ(field.square_at(i, j), expected.square_at(i, j)) << x << " " << y;
      const Point corner{x - 0.5, y - 0.5};
      ASSERT_EQ(field.at_least(corner), expected.at_least(corner)) << x << " " << y;
    }
  }
}

TEST(DistanceField, IsAsMadeAnewWhenCellsBecomeOthers) {
  for_each_case(2, 60, [](Rng& rng) {
    // Some much larger than what the field knows, and almost empty.
    const bool is_large = uniform01(rng) < 0.3;
    const auto side = [&] {
      return static_cast<std::int32_t>(uniform(1, is_large ? 900 : 90, rng));
    };
    OccupancyGrid grid =
        random_grid(side(), side(), std::pow(uniform01(rng), is_large ? 60 : 6), rng);
    grid.unknown_is_free = uniform01(rng) < 0.7;
    const int coarseness = 1 + static_cast<int>(uniform(0, 4, rng));
    geometry::BlockedCells cells(grid);
    const int shift = uniform01(rng) < 0.3 ? 1 : 0;
    geometry::DistanceField field(cells, coarseness, shift);
    for (int i = 0; i < (is_large ? 3 : 8); ++i) {
      const CellRange range = any_range(grid, i % 2 == 0 ? 4 : 60, rng);
      write_any(grid, range, rng);
      cells.update(grid, geometry::in_frame(range));
      field.update(cells, geometry::in_frame(range));
      const geometry::BlockedCells anew(grid);
      expect_same(cells, anew);
      expect_same(field, geometry::DistanceField(anew, coarseness, shift), grid, shift);
    }
  });
}

TEST(DistanceField, OutsideItIsAtLeastAsFarAsTheFrameUnlessThatIsBlocked) {
  OccupancyGrid grid = grid_of({"#."}, 1);
  grid.unknown_is_free = true;
  const geometry::DistanceField free{geometry::BlockedCells(grid), 2};
  EXPECT_NEAR(free.at_least({1e9, 0.5}), 1e9 - 4, 0.5);
  EXPECT_NEAR(free.at_least({1, -1e9}), 1e9, 0.5);
  grid.unknown_is_free = false;
  const geometry::DistanceField blocked{geometry::BlockedCells(grid), 2};
  EXPECT_EQ(blocked.at_least({1e9, 0.5}), 0);
}

TEST(BlockedCells, EdgeCellsHaveANeighbourThatIsFree) {
  for_each_case(3, 100, [](Rng& rng) {
    const OccupancyGrid grid = any_grid(rng);
    const geometry::BlockedCells cells(grid);
    std::vector<std::vector<bool>> found(
        static_cast<std::size_t>(cells.rows()),
        std::vector<bool>(static_cast<std::size_t>(cells.columns())));
    const geometry::CellBox all{-5, cells.columns() + 5, -5, cells.rows() + 5};
    EXPECT_FALSE(
        cells.edges().any_run(all, [&](std::int32_t y, std::int32_t begin, std::int32_t end) {
          for (std::int32_t x = begin; x < end; ++x) {
            found[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = true;
          }
          return false;
        }));
    for (std::int32_t y = -1; y <= grid.rows; ++y) {
      for (std::int32_t x = -1; x <= grid.columns; ++x) {
        const bool is_edge =
            is_blocked(grid, x, y) && (!is_blocked(grid, x - 1, y) || !is_blocked(grid, x + 1, y) ||
                                       !is_blocked(grid, x, y - 1) || !is_blocked(grid, x, y + 1));
        EXPECT_EQ(found[static_cast<std::size_t>(y + 1)][static_cast<std::size_t>(x + 1)], is_edge)
            << x << " " << y;
      }
    }
  });
}

}  // namespace
}  // namespace vandplan
