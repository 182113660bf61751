// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// What do vehicles and problems share that meet in one world?

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "support/grids.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"

namespace {

std::size_t allocated = 0;  // bytes, since the program began

}  // namespace

// What is built anew takes memory: these count it. Inlined alone, they look to g++ as if they did
// not belong together.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocated += size;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  allocated += size;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace vandplan {
namespace {

const Vehicle truck{};
const Vehicle car{.wheelbase = 2.7,
                  .front_overhang = 0.9,
                  .rear_overhang = 1,
                  .width = 1.8,
                  .min_turning_radius = 5};

/// A free yard of 100 m in 1000 x 1000 cells, with a wall of single cells and a gate in it.
std::shared_ptr<const World> mapped_world() {
  constexpr std::int32_t side = 1000;
  std::vector<Cell> cells(std::size_t{side} * side, Cell::free);
  for (std::int32_t row = 0; row < side; ++row) {
    if (row >= 488 && row < 512) continue;  // a gate, 2.4 m wide
    for (std::int32_t column = 490; column < 510; ++column) {
      if ((row + column) % 2 == 0)
        cells[static_cast<std::size_t>(row * side + column)] = Cell::occupied;
    }
  }
  return world_of(
      {.bounds = {0, 100, 0, 100},
       .map = OccupancyGrid{
           .resolution = 0.1, .columns = side, .rows = side, .cells = std::move(cells)}});
}

/// A map of 40 x 20 cells of 0.5 m at [0, 20] x [0, 10]: occupied at [10, 10.5] x [5, 5.5], unknown
/// where x is at least 16 m.
Surroundings small_map() {
  std::vector<Cell> cells(40 * 20, Cell::free);
  cells[10 * 40 + 20] = Cell::occupied;
  for (std::size_t row = 0; row < 20; ++row) {
    std::fill_n(cells.begin() + static_cast<std::ptrdiff_t>(row * 40 + 32), 8, Cell::unknown);
  }
  return {.bounds = {-50, 50, -50, 50},
          .map = OccupancyGrid{
              .resolution = 0.5, .columns = 40, .rows = 20, .cells = std::move(cells)}};
}

TEST(World, AReasonSaysWhichCellIsHitAndWhere) {
  const auto world = std::make_shared<const World>(small_map(), Point{5, 5});
  const auto reason_from = [&](const Pose& start) {
    return plan(make_problem(world, car, start, {6, 5, 0})).reason;
  };
  EXPECT_EQ(reason_from({9, 5.2, 0}),
            "the footprint hits the map: occupied at x = 10.25, y = 5.25");
  EXPECT_EQ(reason_from({15, 5.2, 0}).substr(0, 46),
            "the footprint hits the map: unknown at x = 16.");
  EXPECT_EQ(reason_from({5, 0.2, 0}).substr(0, 53),
            "the footprint hits the map: beyond the edge of the ma");
  EXPECT_EQ(reason_from({-20, 5, 0}).substr(0, 53),
            "the footprint hits the map: beyond the edge of the ma");
}

TEST(World, HasNoVehicleSoSeveralMayDriveInIt) {
  const auto world = mapped_world();
  const Pose before{40, 50, 0};
  const Pose behind{60, 50, 0};
  const Problem wide = make_problem(world, truck, before, behind);
  const Problem narrow = make_problem(world, car, before, behind);
  EXPECT_EQ(wide.world(), narrow.world());
  const Path through{before, {{0, 20}}};
  EXPECT_EQ(check_path(wide, through).reason, "the footprint hits the map");
  EXPECT_TRUE(check_path(narrow, through).valid);
  EXPECT_FALSE(wide.task().checker->is_free(Local(before), through.segments));
  EXPECT_TRUE(narrow.task().checker->is_free(Local(before), through.segments));
}

TEST(World, HasOneCheckerForEachVehicle) {
  const auto world = mapped_world();
  EXPECT_EQ(world->checker(truck), world->checker(truck));
  EXPECT_NE(world->checker(truck), world->checker(car));
  Vehicle longer = truck;
  longer.front_overhang += 1;
  EXPECT_NE(world->checker(truck), world->checker(longer));
  const Problem first = make_problem(world, truck, {10, 10, 0}, {20, 20, 0});
  const Problem second = make_problem(world, truck, {30, 10, 0}, {20, 20, 0});
  EXPECT_EQ(first.task().checker, second.task().checker);
}

TEST(World, WhatIsMadeOfAMapIsMadeOnceForAllVehicles) {
  const std::size_t before = allocated;
  const auto world = mapped_world();
  const std::size_t made = allocated;
  EXPECT_GT(made - before, 1'000'000U);
  const auto first = world->checker(truck);
  const auto second = world->checker(car);
  const auto third = world->checker({.width = 2.0});
  EXPECT_LT(allocated - made, 100'000U);
}

TEST(World, WhatTheJudgeNeedsOfAMapIsMadeOnceForAllVehicles) {
  const auto world = mapped_world();
  const Path forward{{10, 10, 0}, {{0, 5}}};
  const auto judge = [&](const Vehicle& vehicle) {
    const std::size_t before = allocated;
    EXPECT_TRUE(
        check_path(make_problem(world, vehicle, forward.start, {15, 10, 0}), forward).valid);
    return allocated - before;
  };
  const std::size_t first = judge(truck);
  const std::size_t second = judge(car);
  EXPECT_LT(2 * second, first);
}

TEST(World, LivesAsLongAsAnyOfItsProblems) {
  std::unique_ptr<Problem> problem;
  std::weak_ptr<const World> world;
  {
    const auto made = mapped_world();
    world = made;
    problem = std::make_unique<Problem>(make_problem(made, car, {40, 50, 0}, {60, 50, 0}));
  }
  EXPECT_FALSE(world.expired());
  EXPECT_TRUE(problem->task().checker->is_free(problem->task().start));
  problem.reset();
  EXPECT_TRUE(world.expired());
}

}  // namespace
}  // namespace vandplan
