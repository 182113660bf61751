// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which cells of a grid, and around it, are blocked?
#include "geometry/blocked_cells.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace vandplan::geometry {
namespace {

class BlockedCellsTest : public testing::TestWithParam<bool> {};

TEST_P(BlockedCellsTest, UnknownGroundIsAsTheGridSaysInAndAroundIt) {
  OccupancyGrid grid;
  grid.columns = 3;
  grid.rows = 1;
  grid.cells = std::vector<Cell>{Cell::free, Cell::unknown, Cell::occupied};
  grid.unknown_is_free = GetParam();
  const BlockedCells blocked(grid);
  ASSERT_EQ(blocked.columns(), 5);
  ASSERT_EQ(blocked.rows(), 3);
  for (std::int32_t x = 0; x < 5; ++x) {
    EXPECT_EQ(blocked.is_blocked(x, 0), !GetParam()) << x;
    EXPECT_EQ(blocked.is_blocked(x, 2), !GetParam()) << x;
  }
  EXPECT_EQ(blocked.is_blocked(0, 1), !GetParam());
  EXPECT_FALSE(blocked.is_blocked(1, 1));
  EXPECT_EQ(blocked.is_blocked(2, 1), !GetParam());
  EXPECT_TRUE(blocked.is_blocked(3, 1));
  EXPECT_EQ(blocked.is_blocked(4, 1), !GetParam());
}

INSTANTIATE_TEST_SUITE_P(UnknownIsFree, BlockedCellsTest, testing::Bool());

TEST(SharedCells, TakesAVectorASpanOrASharedPointer) {
  std::vector<Cell> cells(6, Cell::occupied);
  const Cell* const data = cells.data();
  OccupancyGrid grid{.columns = 3, .rows = 2, .cells = cells};
  EXPECT_NE(grid.cells->data(), data);
  grid.cells = std::move(cells);
  EXPECT_EQ(grid.cells->data(), data);
  const OccupancyGrid copy = grid;
  EXPECT_EQ(copy.cells->data(), data);

  const std::array elsewhere{Cell::free, Cell::unknown};
  grid.cells = std::span<const Cell>(elsewhere);
  EXPECT_EQ(*grid.cells, (std::vector{Cell::free, Cell::unknown}));

  const auto shared = std::make_shared<std::vector<Cell>>(4, Cell::free);
  grid.cells = shared;
  EXPECT_EQ(grid.cells.get(), shared.get());
  grid.cells = nullptr;
  EXPECT_FALSE(grid.cells);
  EXPECT_FALSE(OccupancyGrid{}.cells);
}

}  // namespace
}  // namespace vandplan::geometry
