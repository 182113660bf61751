// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Among the cells of a map, too, the checker never accepts an edge that the judge, looking every
// millimetre, rejects, and rejects none that stays more than its tolerance away from everything.
// A third of the maps lies so that an edge just touches or just misses a cell.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "support/cases.h"
#include "support/collision_oracle.h"
#include "support/grids.h"
#include "support/map_cases.h"
#include "support/numbers.h"
#include "support/problems.h"
#include "vandplan/collision.h"
#include "vandplan/judge.h"

namespace vandplan {
namespace {

constexpr Bounds wide{-1e4, 1e4, -1e4, 1e4};

struct Counts {
  int accepted = 0;
  int barely_accepted = 0;  // within 4 mm of a cell
  int rejected = 0;
  int barely_rejected = 0;  // without touching, found in every 16th
};

void expect_law(const Vehicle& vehicle, const OccupancyGrid& grid, const Path& path,
                Counts& counts) {
  const OracleBody body(vehicle);
  const Problem problem = problem_of_path({.bounds = wide, .map = grid}, path, vehicle);
  const auto described = [&] {
    return as_code(path) + " on cells of " + as_code(grid.resolution) + " m at " +
           as_code(grid.origin) + ", " + std::to_string(grid.columns) + " x " +
           std::to_string(grid.rows) + ": " + as_code(squares_of(grid));
  };
  if (problem.task().checker->is_free(Local(path.start), path.segments)) {
    const PathCheck check = check_path(problem, path, {});
    EXPECT_TRUE(check.valid) << check.reason << "; " << described();
    ++counts.accepted;
    counts.barely_accepted += check.clearance < 4e-3;
  } else {
    const std::vector<Polygon> squares = squares_of(grid);
    EXPECT_TRUE(comes_within(CollisionChecker::tolerance, body, squares, path)) << described();
    counts.barely_rejected += counts.rejected % 16 == 0 && !comes_within(0, body, squares, path);
    ++counts.rejected;
  }
}

TEST(MapLaw, WhatIsAcceptedIsValidAndWhatIsClearIsAccepted) {
  constexpr int count = 8000;
  Counts counts;
  for_each_case(1, count, [&](Rng& rng) {
    const Vehicle vehicle = any_body(rng);
    const Path grazing = any_edge(rng);
    OccupancyGrid grid = any_grid(rng);
    graze(grid, vehicle, grazing, rng);
    expect_law(vehicle, grid, grazing, counts);
    for (int i = 0; i < 2; ++i) expect_law(vehicle, grid, any_edge(rng), counts);
  });
  EXPECT_GT(counts.accepted, cases(count));
  EXPECT_GT(counts.rejected, cases(count) / 8);
  EXPECT_GT(counts.barely_accepted, cases(count) / 8);
  // Every 16th is looked for: too few to count where there are few cases.
  EXPECT_GT(counts.barely_rejected * 16, is_sanitized ? -1 : cases(count) / 16);
}

TEST(MapLaw, CrowdedAndEnclosedMapsKeepItToo) {
  constexpr int count = 300;
  Counts counts;
  for_each_case(2, count, [&](Rng& rng) {
    const auto side = [&] { return static_cast<std::int32_t>(uniform(5, 40, rng)); };
    OccupancyGrid grid = random_grid(side(), side(), any_size(1e-3, 0.3, rng), rng);
    grid.unknown_is_free = chance(0.3, rng);
    grid.resolution = any_size(0.2, 2, rng);
    grid.origin = {uniform(-20, 0, rng), uniform(-20, 0, rng), uniform(-0.5, 0.5, rng)};
    const Vehicle vehicle = any_body(rng);
    for (int i = 0; i < 10; ++i) expect_law(vehicle, grid, any_edge(rng), counts);
  });
  EXPECT_GT(counts.accepted, cases(count) / 2);
  EXPECT_GT(counts.rejected, cases(count) / 2);
}

TEST(MapLaw, TheClearanceIsTheDistanceOfTheOracle) {
  constexpr int count = 4000;
  int apart = 0;
  for_each_case(5, count, [&](Rng& rng) {
    const Vehicle vehicle = any_body(rng);
    const OccupancyGrid grid = any_grid(rng);
    const CollisionChecker checker(vehicle, Surroundings{.bounds = wide, .map = grid});
    const double most = any_size(0.01, 100, rng);
    const Pose pose = any_edge(rng).start;
    const double gap = gap_at(vehicle, squares_of(grid), pose).distance;
    EXPECT_NEAR(checker.clearance(Local(pose), most), std::min(gap, most), 1e-9)
        << most << " at " << as_code(pose) << " on cells of " << as_code(grid.resolution);
    if (gap < infinity) {
      EXPECT_NEAR(checker.clearance(Local(pose), infinity), gap, 1e-9) << as_code(pose);
    }
    const double enough = uniform(0, 1.5, rng) * most;
    const double roughly = checker.clearance(Local(pose), most, enough);
    EXPECT_LE(roughly, std::min(gap, most) + 1e-9);
    EXPECT_GE(roughly, std::min({gap, most, enough}) - 1e-9);
    apart += gap > 0 && gap < most;
  });
  EXPECT_GT(apart, cases(count) / 8);
}

// With many cells about as near as the nearest one.
TEST(MapLaw, TheClearanceIsTheDistanceOfTheOracleInACrowd) {
  constexpr int count = 200;
  constexpr std::int32_t side = 60;
  int crowded = 0;
  for_each_case(6, count, [&](Rng& rng) {
    const Vehicle vehicle = any_body(rng);
    const OracleBody body(vehicle);
    OccupancyGrid grid = random_grid(side, side, 0.5, rng);
    grid.resolution = 0.25;
    grid.origin.heading = uniform(-3, 3, rng);
    const Pose pose = compose(grid.origin, {side * 0.125, side * 0.125, uniform(-3, 3, rng)});
    const double room = any_size(0.1, 2, rng);
    std::vector<Cell> cells = *grid.cells;
    std::vector<double> gaps;
    for (std::int32_t i = 0; i < side * side; ++i) {
      const Polygon square = square_of(grid, i % side, i / side);
      const double gap = gap_at(body, {&square, 1}, pose).distance;
      Cell& cell = cells[static_cast<std::size_t>(i)];
      if (gap < room) cell = Cell::free;
      if (cell == Cell::occupied) gaps.push_back(gap);
    }
    grid.cells = std::move(cells);
    const CollisionChecker checker(vehicle, Surroundings{.bounds = wide, .map = grid});
    const double gap = gap_at(body, squares_of(grid), pose).distance;
    EXPECT_NEAR(checker.clearance(Local(pose), 100), gap, 1e-9) << as_code(pose);
    crowded += std::ranges::count_if(gaps, [&](double g) { return g < gap + 0.2; }) > 40;
  });
  EXPECT_GT(crowded, is_sanitized ? -1 : cases(count) / 10);
}

/// The grid in the lower left corner of so much free ground.
OccupancyGrid in_free_ground(const OccupancyGrid& grid, std::int32_t columns, std::int32_t rows) {
  std::vector<Cell> cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (std::int32_t row = 0; row < grid.rows; ++row) {
    std::copy_n(grid.cells->begin() + row * grid.columns, grid.columns,
                cells.begin() + std::ptrdiff_t{row} * columns);
  }
  OccupancyGrid result = grid;
  result.columns = columns;
  result.rows = rows;
  result.cells = std::move(cells);
  return result;
}

// Its distance field is that of squares of 2 x 2 cells.
TEST(MapLaw, MoreThan100MillionCellsGiveTheSameAnswers) {
  Rng rng(6);
  OccupancyGrid grid = random_grid(301, 299, 1e-3, rng);
  grid.unknown_is_free = true;
  grid.resolution = 0.1;
  grid.origin = {-12, -15, 0.1};
  const Surroundings small{.bounds = wide, .map = grid};
  const Surroundings large{.bounds = wide, .map = in_free_ground(grid, 10'001, 10'000)};
  int free = 0;
  constexpr int edges = 1000;
  const CollisionChecker expected(Vehicle{}, small);
  const CollisionChecker found(Vehicle{}, large);
  for (int i = 0; i < edges; ++i) {
    const Path path = any_edge(rng);
    const bool is_free = expected.is_free(Local(path.start), path.segments);
    EXPECT_EQ(found.is_free(Local(path.start), path.segments), is_free) << as_code(path);
    EXPECT_NEAR(found.clearance(Local(path.start), 10), expected.clearance(Local(path.start), 10),
                1e-9)
        << as_code(path);
    free += is_free;
  }
  EXPECT_GT(free, edges / 20);
  EXPECT_LT(free, edges * 19 / 20);
}

TEST(MapLaw, AMarginIsKeptAndNoMoreThanThat) {
  constexpr int count = 4000;
  int accepted = 0;
  int rejected = 0;
  for_each_case(4, count, [&](Rng& rng) {
    const Vehicle vehicle = any_body(rng);
    const OracleBody body(vehicle);
    const Path grazing = any_edge(rng);
    const double margin = any_size(1e-3, 5, rng);
    OccupancyGrid grid = any_grid(rng);
    graze(grid, body, grazing, rng, margin);
    const std::vector<Polygon> squares = squares_of(grid);
    const CollisionChecker checker(vehicle, Surroundings{.bounds = wide, .map = grid},
                                   {.wanted = margin});
    for (int i = 0; i < 3; ++i) {
      const Path path = i == 0 ? grazing : any_edge(rng);
      const bool is_free = checker.is_free(Local(path.start), path.segments);
      ++(is_free ? accepted : rejected);
      const double distance = margin + (is_free ? 0.0 : CollisionChecker::tolerance);
      EXPECT_NE(comes_within(distance, body, squares, path), is_free)
          << margin << "; " << as_code(path) << " on cells of " << as_code(grid.resolution)
          << " m at " << as_code(grid.origin) << ": " << as_code(squares);
    }
  });
  EXPECT_GT(accepted, cases(count) / 5);
  EXPECT_GT(rejected, cases(count) / 5);
}

TEST(MapLaw, TheJudgeSeesCellsAsItSeesSquares) {
  constexpr int count = 3000;
  int valid = 0;
  int invalid = 0;
  for_each_case(3, count, [&](Rng& rng) {
    const Vehicle vehicle = any_body(rng);
    const Path path = any_edge(rng);
    const OccupancyGrid grid = any_grid(rng);
    const auto judged = [&](const Surroundings& surroundings) {
      return check_path(problem_of_path(surroundings, path, vehicle), path, {});
    };
    const PathCheck cells = judged({.bounds = wide, .map = grid});
    const PathCheck squares = judged({.bounds = wide, .obstacles = squares_of(grid)});
    EXPECT_EQ(cells.valid, squares.valid);
    if (cells.valid && std::isfinite(*squares.clearance)) {
      EXPECT_NEAR(*cells.clearance, *squares.clearance, 1.1e-3);
    }
    ++(cells.valid ? valid : invalid);
  });
  EXPECT_GT(valid, cases(count) / 4);
  EXPECT_GT(invalid, cases(count) / 40);
}

}  // namespace
}  // namespace vandplan
