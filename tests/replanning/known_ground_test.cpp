// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/known_ground.h"

#include <gtest/gtest.h>

#include "support/cases.h"
#include "support/grids.h"
#include "support/place_of_error.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"

namespace vandplan {
namespace {

using replanning::KnownGround;

/// A map of 40 x 24 m with the lane in its middle free, and a block of two metres beside it.
Scenario mapped_lane(Rng& rng) {
  Scenario scenario;
  scenario.bounds = {0, 40, 0, 24};
  scenario.start = {5, 12, 0};
  scenario.goal = {35, 12, 0};
  scenario.obstacles = {{{20, 15}, {22, 15}, {22, 17}, {20, 17}}};
  OccupancyGrid map = random_grid(200, 120, 0.0003, rng);
  map.resolution = 0.2;
  map.unknown_is_free = uniform01(rng) < 0.5;
  scenario.map = map;
  return scenario;
}

/// Cells of one kind, somewhere: sometimes beyond the middle of the map, sometimes at its border.
CellPatch any_patch(const OccupancyGrid& map, Rng& rng) {
  const auto any = [&](double low, double high) {
    return static_cast<std::int32_t>(uniform(low, high, rng));
  };
  CellPatch patch{.columns = any(1, 30), .rows = any(1, 30)};
  patch.column = any(0, map.columns - patch.columns + 1);
  patch.row = any(0, map.rows - patch.rows + 1);
  const std::size_t count =
      static_cast<std::size_t>(patch.columns) * static_cast<std::size_t>(patch.rows);
  const double kind = uniform01(rng);
  patch.cells.assign(count, kind < 0.6 ? Cell::free : kind < 0.8 ? Cell::occupied : Cell::unknown);
  return patch;
}

void write(Scenario& scenario, const CellPatch& patch) {
  OccupancyGrid& map = *scenario.map;
  auto cells = *map.cells;
  for (std::int32_t y = 0; y < patch.rows; ++y) {
    for (std::int32_t x = 0; x < patch.columns; ++x) {
      cells[static_cast<std::size_t>((patch.row + y) * map.columns + patch.column + x)] =
          patch.cells[static_cast<std::size_t>(y * patch.columns + x)];
    }
  }
  map.cells = std::move(cells);
}

void expect_same_ground(const World& world, const World& anew, const Vehicle& vehicle, Rng& rng) {
  const auto checker = world.checker(vehicle);
  const auto other = anew.checker(vehicle);
  for (int i = 0; i < 300; ++i) {
    const Pose pose{uniform(-2, 42, rng), uniform(-2, 26, rng), uniform(-3.1, 3.1, rng)};
    const Segment segment{uniform(-0.1, 0.1, rng), uniform(-8, 8, rng)};
    ASSERT_EQ(checker->is_free(Local(pose), segment), other->is_free(Local(pose), segment));
    ASSERT_EQ(checker->clearance(Local(pose), 5), other->clearance(Local(pose), 5));
    ASSERT_EQ(checker->map_distance(Local(Point{pose.x, pose.y})).least,
              other->map_distance(Local(Point{pose.x, pose.y})).least);
  }
}

/// What the planner and the judge make of a problem there.
std::pair<PlanResult, PathCheck> planned(std::shared_ptr<const World> world,
                                         const Scenario& scenario) {
  const Problem problem =
      make_problem(std::move(world), scenario.vehicle, scenario.start, scenario.goal);
  PlanOptions options;
  options.budget.max_iterations = 200;
  PlanResult result = plan(problem, options);
  const Path straight{scenario.start, {{0, 30}}};
  PathCheck check = check_path(problem, result.path ? *result.path : straight);
  return {std::move(result), std::move(check)};
}

/// Cells, and at times an obstacle, in the patch and in the scenario.
WorldPatch any_news(Scenario& scenario, Rng& rng) {
  WorldPatch patch;
  for (int k = 0; k < 3; ++k) {
    patch.cells.push_back(any_patch(*scenario.map, rng));
    write(scenario, patch.cells.back());
  }
  if (uniform01(rng) < 0.5) return patch;
  const double x = uniform(8, 32, rng);
  const Polygon block = {{x, 5}, {x + 1, 5}, {x + 1, 8}};
  patch.added = {{7, block}};
  scenario.obstacles.resize(1);
  scenario.obstacles.push_back(block);
  return patch;
}

TEST(KnownGround, IsAsMadeAnewAfterPatches) {
  int found = 0;
  for_each_case(1, 20, [&](Rng& rng) {
    Scenario scenario = mapped_lane(rng);
    KnownGround ground{World(surroundings(scenario), {})};
    for (int i = 0; i < 6; ++i) {
      (void)planned(ground.world(), scenario);  // so that all is kept with the world
      ground.patch(any_news(scenario, rng));
      const auto anew = std::make_shared<const World>(surroundings(scenario), Point{});
      expect_same_ground(*ground.world(), *anew, scenario.vehicle, rng);
      const auto [result, check] = planned(ground.world(), scenario);
      const auto [expected, judged] = planned(anew, scenario);
      ASSERT_EQ(result.path, expected.path);
      ASSERT_EQ(result.status, expected.status);
      ASSERT_EQ(check.valid, judged.valid);
      ASSERT_EQ(check.clearance, judged.clearance);
      found += result.path ? 1 : 0;
    }
  });
  if (!is_sanitized) {
    EXPECT_GT(found, 20);
  }
}

/// A lane with a mask of prices: percentages in a box, silence around.
Scenario priced_lane(Rng& rng) {
  Scenario scenario = mapped_lane(rng);
  const std::size_t columns = 200;
  std::vector<std::uint8_t> percents(columns * 120, 0);
  for (std::size_t row = 40; row < 70; ++row) {
    for (std::size_t column = 60; column < 110; ++column) {
      percents[row * columns + column] = static_cast<std::uint8_t>(uniform(0, 101, rng));
    }
  }
  Mask mask = cost_mask(*scenario.map, 3.0);
  mask.percents = std::make_shared<const std::vector<std::uint8_t>>(std::move(percents));
  scenario.masks = {cost_mask(*scenario.map, 0.0), mask};
  return scenario;
}

/// Percentages somewhere, written into the second mask of a scenario: at times only silence.
MaskPatch any_percents(Scenario& scenario, Rng& rng) {
  const CellPatch where = any_patch(*scenario.map, rng);
  MaskPatch patch{1, {where.column, where.row, where.columns, where.rows}, {}};
  const double most = uniform01(rng) < 0.3 ? 0.0 : 100.0;
  std::vector<std::uint8_t> all = *scenario.masks[1].percents;
  for (std::int32_t y = 0; y < where.rows; ++y) {
    for (std::int32_t x = 0; x < where.columns; ++x) {
      const auto percent = static_cast<std::uint8_t>(uniform(0, most, rng));
      patch.percents.push_back(percent);
      all[static_cast<std::size_t>((where.row + y) * 200 + where.column + x)] = percent;
    }
  }
  scenario.masks[1].percents = std::make_shared<const std::vector<std::uint8_t>>(std::move(all));
  return patch;
}

TEST(KnownGround, HasThePricesOfPatchedMasks) {
  for_each_case(3, 20, [&](Rng& rng) {
    Scenario scenario = priced_lane(rng);
    KnownGround ground{World(surroundings(scenario), {})};
    for (int i = 0; i < 5; ++i) {
      (void)planned(ground.world(), scenario);
      const MaskPatch patch = any_percents(scenario, rng);
      ground.patch({.masks = {patch}});
      const auto anew = std::make_shared<const World>(surroundings(scenario), Point{});
      const auto checker = ground.world()->checker(scenario.vehicle);
      const auto other = anew->checker(scenario.vehicle);
      for (int k = 0; k < 100; ++k) {
        const State from{{uniform(-2, 42, rng), uniform(-2, 26, rng), uniform(-3, 3, rng)}};
        const Segment segment{uniform(-0.1, 0.1, rng), uniform(-8, 8, rng)};
        const auto parts = checker->ground_along(Local(from), segment);
        const auto expected = other->ground_along(Local(from), segment);
        ASSERT_EQ(parts.size(), expected.size());
        for (std::size_t j = 0; j < parts.size(); ++j) {
          ASSERT_EQ(parts[j].end, expected[j].end);
          ASSERT_EQ(parts[j].cost, expected[j].cost);
        }
      }
      const PlanResult result = planned(ground.world(), scenario).first;
      const PlanResult expected = planned(anew, scenario).first;
      ASSERT_EQ(result.path, expected.path);
      ASSERT_EQ(result.cost, expected.cost);
      const std::int64_t version = ground.version();
      ground.patch({.masks = {patch}});
      EXPECT_EQ(ground.version(), version) << "nothing new";
    }
  });
}

TEST(KnownGround, RefusesWhatAMaskCannotHave) {
  Rng rng(1);
  const Scenario scenario = priced_lane(rng);
  KnownGround ground{World(surroundings(scenario), {})};
  const auto place = [&](const MaskPatch& patch) {
    return place_of_error([&] { ground.patch({.masks = {patch}}); });
  };
  EXPECT_EQ(place({2, {0, 0, 1, 1}, {50}}), "masks[0]") << "there are two";
  EXPECT_EQ(place({0, {0, 0, 1, 1}, {50}}), "masks[0]") << "without percentages";
  EXPECT_EQ(place({1, {199, 0, 2, 1}, {50, 50}}), "masks[0]") << "beyond its edge";
  EXPECT_EQ(place({1, {0, 0, 2, 1}, {50}}), "masks[0].percents");
  EXPECT_EQ(place({1, {0, 0, 2, 1}, {50, 101}}), "masks[0]");
  EXPECT_EQ(ground.version(), 0);
  ground.patch({.masks = {{1, {0, 0, 2, 1}, {50, 255}}}});
  EXPECT_EQ(ground.version(), 1);
  EXPECT_EQ((*scenario.masks[1].percents)[0], 0) << "a copy has changed";
}

TEST(KnownGround, LeavesTheWorldThatItBeganWithAsItIs) {
  Rng rng(1);
  const Scenario scenario = mapped_lane(rng);
  const World world(surroundings(scenario), {});
  const std::vector<Cell> before = *world.local().map->cells;
  KnownGround ground(world);
  ground.patch({.cells = {{0, 0, 30, 30, std::vector<Cell>(900, Cell::occupied)}}, .removed = {0}});
  EXPECT_EQ(ground.version(), 1);
  EXPECT_TRUE(ground.world()->local().obstacles.empty());
  EXPECT_NE(*ground.world()->local().map->cells, before);
  EXPECT_EQ(*world.local().map->cells, before);
  EXPECT_EQ(world.local().obstacles.size(), 1U);
}

TEST(KnownGround, StaysAsItIsWhereAPatchIsWrong) {
  Rng rng(1);
  const Scenario scenario = mapped_lane(rng);
  KnownGround ground{World(surroundings(scenario), {})};
  const std::vector<Cell> before = *ground.world()->local().map->cells;
  const CellPatch good{0, 0, 30, 30, std::vector<Cell>(900, Cell::occupied)};
  const CellPatch off_map{180, 0, 30, 30, std::vector<Cell>(900, Cell::occupied)};
  EXPECT_THROW(ground.patch({.cells = {good, off_map}}), InputError);
  EXPECT_THROW(ground.patch({.cells = {good}, .added = {{1, {{0, 0}, {1, 1}}}}}), InputError);
  EXPECT_EQ(*ground.world()->local().map->cells, before);
  EXPECT_EQ(ground.version(), 0);
}

/// The same, a hundred kilometres away.
Scenario moved_away(Scenario scenario) {
  constexpr double x = 1e5, y = -1e5;
  scenario.bounds = {x, x + 40, y, y + 24};
  for (Pose* const pose : {&scenario.start, &scenario.goal, &scenario.map->origin}) {
    pose->x += x;
    pose->y += y;
  }
  for (Polygon& polygon : scenario.obstacles) {
    for (Point& corner : polygon) corner = {corner.x + x, corner.y + y};
  }
  return scenario;
}

TEST(ChangingWorld, IsTheWorldOfTheChangedSurroundings) {
  for_each_case(2, 20, [&](Rng& rng) {
    Scenario scenario = moved_away(mapped_lane(rng));
    const Point near{scenario.start.x, scenario.start.y};
    ChangingWorld ground(surroundings(scenario), near);
    const auto world = ground.world();
    for (int i = 0; i < 4; ++i) {
      (void)planned(ground.world(), scenario);
      WorldPatch patch;
      patch.cells.push_back(any_patch(*scenario.map, rng));
      write(scenario, patch.cells.back());
      if (i == 2) {
        scenario.obstacles.push_back(
            {{1e5 + 9, -1e5 + 5}, {1e5 + 9, -1e5 + 8}, {1e5 + 8, -1e5 + 5}});
        patch.added = {{1, scenario.obstacles.back()}};
      }
      ground.patch(patch);
      ASSERT_EQ(ground.world(), world) << "in place";
      const auto anew = std::make_shared<const World>(surroundings(scenario), near);
      ASSERT_EQ(ground.world()->origin(), anew->origin());
      expect_same_ground(*ground.world(), *anew, scenario.vehicle, rng);
      const auto [result, check] = planned(ground.world(), scenario);
      const auto [expected, judged] = planned(anew, scenario);
      ASSERT_EQ(result.path, expected.path);
      ASSERT_EQ(check.clearance, judged.clearance);
    }
  });
}

TEST(ChangingWorld, LeavesTheCellsThatItWasGiven) {
  Rng rng(1);
  const Scenario scenario = mapped_lane(rng);
  const std::vector<Cell> before = *scenario.map->cells;
  ChangingWorld ground(surroundings(scenario), {});
  ground.patch({.cells = {{0, 0, 30, 30, std::vector<Cell>(900, Cell::occupied)}}});
  EXPECT_EQ(*scenario.map->cells, before);
  ChangingWorld other = std::move(ground);
  EXPECT_NE(*other.world()->local().map->cells, before);
  EXPECT_THROW(other.patch({.cells = {{0, 0, 1, 1, {}}}}), InputError);
}

TEST(ChangingWorld, WrongSurroundingsAreRefused) {
  Rng rng(1);
  Scenario scenario = mapped_lane(rng);
  scenario.map->cells = {};
  EXPECT_THROW(ChangingWorld(surroundings(scenario), {}), InputError);
  scenario.map.reset();
  ChangingWorld without_map(surroundings(scenario), {});
  EXPECT_THROW(without_map.patch({.cells = {{0, 0, 1, 1, {Cell::free}}}}), InputError);
  without_map.patch({.removed = {0}});
  EXPECT_TRUE(without_map.world()->local().obstacles.empty());
}

}  // namespace
}  // namespace vandplan
