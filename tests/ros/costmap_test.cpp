// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/costmap.h"

#include <gtest/gtest.h>

#include <limits>

#include "ros/yard.h"
#include "support/cases.h"
#include "support/place_of_error.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/problem.h"

namespace vandplan::ros {
namespace {

TEST(RosCostmap, OnlyLethalCostsAreObstacles) {
  const CostRule usual;
  for (const int cost : {0, 1, 128, 252, 253}) {
    EXPECT_EQ(cell_of(static_cast<std::uint8_t>(cost), usual), Cell::free) << cost;
  }
  EXPECT_EQ(cell_of(254, usual), Cell::occupied);
  EXPECT_EQ(cell_of(255, usual), Cell::free);
  EXPECT_EQ(cell_of(255, {.allow_unknown = false}), Cell::unknown);
  EXPECT_EQ(cell_of(253, {.lethal_cost = 253}), Cell::occupied);
  EXPECT_EQ(cell_of(252, {.lethal_cost = 253}), Cell::free);
  EXPECT_EQ(cell_of(255, {.lethal_cost = 1}), Cell::free) << "unknown, not lethal";
  EXPECT_EQ(cell_of(0, {.lethal_cost = 1}), Cell::free);
  EXPECT_EQ(cell_of(static_cast<std::uint8_t>(std::int8_t{-1}), {.allow_unknown = false}),
            Cell::unknown)
      << "of an OccupancyGrid";
}

TEST(RosCostmap, AMapHasTheShapeOfItsCostmap) {
  OwnedCostmap costmap(3, 2, 0.5, {1, 2, 0.1});
  costmap.at(2, 1) = 254;
  costmap.at(0, 0) = 255;
  const Surroundings ground = ground_of(costmap.view(), {.allow_unknown = false});
  EXPECT_EQ(ground.bounds, bounding_box(outline(*ground.map)));
  const OccupancyGrid& map = *ground.map;
  EXPECT_EQ(map.origin, (Pose{1, 2, 0.1}));
  EXPECT_EQ(map.resolution, 0.5);
  EXPECT_EQ(map.columns, 3);
  EXPECT_EQ(map.rows, 2);
  using enum Cell;
  EXPECT_EQ(*map.cells, (std::vector{unknown, free, free, free, free, occupied}));
  EXPECT_FALSE(map.unknown_is_free) << "what is outside the map is never free";
  EXPECT_EQ(cells_of(costmap.view(), {}, {1, 1, 2, 1}), (std::vector{free, occupied}));
}

TEST(RosCostmap, GradedCostsAreAMask) {
  OwnedCostmap costmap(8, 1, 0.5);
  costmap.costs() = {0, 1, 2, 126, 252, 253, 254, 255};
  const auto percents = [&](const CostRule& rule) {
    return percents_of(costmap.view(), rule, {0, 0, 8, 1});
  };
  using Percents = std::vector<std::uint8_t>;
  EXPECT_EQ(percents({}), (Percents{0, 0, 1, 50, 100, 100, 100, 255}));
  EXPECT_EQ(percents({.lethal_cost = 253}), percents({})) << "252 is the highest in Nav2";
  EXPECT_EQ(percents({.lethal_cost = 5}), (Percents{0, 25, 50, 100, 100, 100, 100, 255}));
  EXPECT_EQ(percents({.lethal_cost = 1}), (Percents{0, 100, 100, 100, 100, 100, 100, 255}));
  EXPECT_EQ(percents_of(costmap.view(), {}, {2, 0, 2, 1}), (Percents{1, 50}));
  const Surroundings ground = ground_of(costmap.view(), {.cost_penalty = 3.0});
  ASSERT_EQ(ground.masks.size(), 1U);
  const Mask& mask = ground.masks.front();
  EXPECT_EQ(mask.use, MaskUse::cost);
  EXPECT_EQ(mask.base, 1.0);
  EXPECT_EQ(mask.multiplier, 0.03);
  EXPECT_EQ(*mask.percents, percents({}));
  EXPECT_TRUE(ground_of(costmap.view(), {.cost_penalty = 0.0}).masks.empty());
}

TEST(RosCostmap, AWrongCostmapIsRefusedAndTheLastOneStays) {
  KnownCostmap known;
  EXPECT_TRUE(known.now().costs.empty());
  OwnedCostmap good(4, 3, 0.1);
  good.at(1, 1) = 7;
  known.take(good.view());
  Costmap wrong = good.view();
  wrong.columns = 5;
  EXPECT_EQ(place_of_error([&] { known.take(wrong); }), "costmap");
  wrong = good.view();
  wrong.columns = 0;
  EXPECT_EQ(place_of_error([&] { known.take(wrong); }), "costmap");
  wrong = {.columns = -4, .rows = -3, .resolution = 0.1};
  EXPECT_EQ(place_of_error([&] { known.take(wrong); }), "costmap");
  wrong = good.view();
  wrong.resolution = 0.0;
  EXPECT_EQ(place_of_error([&] { known.take(wrong); }), "map.resolution");
  wrong = good.view();
  wrong.origin.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(place_of_error([&] { known.take(wrong); }), "map.origin");
  EXPECT_EQ(known.now().columns, 4);
  EXPECT_EQ(known.now().costs[5], 7);
}

TEST(RosCostmap, AnotherShapeIsNew) {
  KnownCostmap known;
  known.take(OwnedCostmap(4, 3, 0.1).view());
  EXPECT_FALSE(known.changes());
  known.take(OwnedCostmap(4, 3, 0.1).view());
  ASSERT_TRUE(known.changes());
  const OwnedCostmap others[] = {{3, 4, 0.1}, {4, 3, 0.2}, {4, 3, 0.1, {1, 0, 0}}, {4, 3, 0.1}};
  for (const OwnedCostmap& other : others) {
    known.take(other.view());
    EXPECT_FALSE(known.changes());
    EXPECT_TRUE(known.changes()->empty());
  }
}

TEST(RosCostmap, ChangesAreTilesThatTouch) {
  KnownCostmap known;
  OwnedCostmap costmap(200, 130, 0.1);
  known.take(costmap.view());
  EXPECT_FALSE(known.changes());
  costmap.fill({60, 60, 10, 10}, 9);  // four tiles
  costmap.at(199, 129) = 1;           // the last one, which is cut off
  known.take(costmap.view());
  const auto changes = known.changes();
  ASSERT_TRUE(changes);
  ASSERT_EQ(changes->size(), 2U);
  const auto [first, last] = std::pair((*changes)[0], (*changes)[1]);
  EXPECT_EQ(std::tuple(first.column, first.row, first.columns, first.rows),
            std::tuple(0, 0, 128, 128));
  EXPECT_EQ(std::tuple(last.column, last.row, last.columns, last.rows), std::tuple(192, 128, 8, 2));
}

TEST(RosCostmap, ChangesAddUpUntilTheyAreAskedFor) {
  for_each_case(7, 2000, [](Rng& rng) {
    const auto columns = static_cast<std::int32_t>(uniform(1, 300, rng));
    const auto rows = static_cast<std::int32_t>(uniform(1, 200, rng));
    OwnedCostmap costmap(columns, rows, 0.1);
    KnownCostmap known;
    known.take(costmap.view());
    (void)known.changes();
    const std::vector<std::uint8_t> before = costmap.costs();
    for (int i = 0; i < 3; ++i) {
      costmap.fill(any_range(columns, rows, rng), static_cast<std::uint8_t>(uniform(0, 256, rng)));
      known.take(costmap.view());
    }
    ASSERT_TRUE(std::equal(costmap.costs().begin(), costmap.costs().end(),
                           known.now().costs.begin(), known.now().costs.end()));
    std::vector<int> seen(before.size(), 0);
    const auto changes = known.changes();
    ASSERT_TRUE(changes);
    for (const CellRange& range : *changes) {
      for (std::int32_t row = range.row; row < range.row + range.rows; ++row) {
        for (std::int32_t column = range.column; column < range.column + range.columns; ++column) {
          ++seen.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column));
        }
      }
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
      ASSERT_LE(seen[i], 1);
      ASSERT_GE(seen[i], before[i] != costmap.costs()[i] ? 1 : 0);
    }
    ASSERT_TRUE(known.changes()->empty());
  });
}

/// Costs as layers write them: obstacles, unknown ground, something graded around.
std::uint8_t any_cost(Rng& rng) {
  const double kind = uniform01(rng);
  if (kind < 0.4) return 0;
  if (kind < 0.6) return nav2_lethal_cost;
  if (kind < 0.7) return unknown_cost;
  return static_cast<std::uint8_t>(uniform(1, 254, rng));
}

/// Whether the checker finds the same in both worlds, at any place.
void expect_same_world(const World& patched, const World& anew, Rng& rng) {
  ASSERT_EQ(*patched.local().map->cells, *anew.local().map->cells);
  ASSERT_EQ(patched.origin(), anew.origin());
  ASSERT_EQ(patched.local().masks.size(), anew.local().masks.size());
  if (!anew.local().masks.empty()) {
    ASSERT_EQ(*patched.local().masks[0].percents, *anew.local().masks[0].percents);
  }
  const Vehicle vehicle = vehicle_of(small_robot(), {});
  const auto checker = patched.checker(vehicle);
  const auto other = anew.checker(vehicle);
  const Bounds& bounds = anew.local().bounds;
  for (int i = 0; i < 20; ++i) {
    const Pose pose{uniform(bounds.x_min - 1, bounds.x_max + 1, rng),
                    uniform(bounds.y_min - 1, bounds.y_max + 1, rng), uniform(-3.1, 3.1, rng)};
    const Segment segment{uniform(-2, 2, rng), uniform(-3, 3, rng)};
    ASSERT_EQ(checker->is_free(Local(pose), segment), other->is_free(Local(pose), segment));
    ASSERT_EQ(checker->clearance(Local(pose), 5), other->clearance(Local(pose), 5));
    const auto parts = checker->ground_along(Local(State(pose)), segment);
    const auto others = other->ground_along(Local(State(pose)), segment);
    ASSERT_EQ(parts.size(), others.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      ASSERT_EQ(parts[k].end, others[k].end);
      ASSERT_EQ(parts[k].cost, others[k].cost);
    }
    ASSERT_EQ(checker->map_distance(Local(Point{pose.x, pose.y})).least,
              other->map_distance(Local(Point{pose.x, pose.y})).least);
  }
}

// 2000 costmaps with five changes each: 10^4 patched worlds.
TEST(RosCostmap, APatchedWorldIsTheOneBuiltAnew) {
  for_each_case(11, 2000, [](Rng& rng) {
    const auto columns = static_cast<std::int32_t>(uniform(1, 150, rng));
    const auto rows = static_cast<std::int32_t>(uniform(1, 100, rng));
    const Pose origin{uniform(-50, 50, rng), uniform(-50, 50, rng),
                      uniform01(rng) < 0.5 ? 0.0 : uniform(-3, 3, rng)};
    OwnedCostmap costmap(columns, rows, uniform(0.02, 0.5, rng), origin);
    const Vehicle vehicle = vehicle_of(small_robot(), {});
    CostRule rule{.allow_unknown = uniform01(rng) < 0.5,
                  .cost_penalty = uniform01(rng) < 0.3 ? 0.0 : uniform(0, 5, rng)};
    Planner planner;
    for (int i = 0; i < 6; ++i) {
      costmap.fill(any_range(columns, rows, rng), any_cost(rng));
      if (uniform01(rng) < 0.1) rule.allow_unknown = !rule.allow_unknown;
      planner.take(costmap.view());
      ASSERT_FALSE(planner.is_blocked({}, vehicle, rule));
      const World anew(ground_of(costmap.view(), rule), {origin.x, origin.y});
      expect_same_world(*planner.world(), anew, rng);
    }
  });
}

}  // namespace
}  // namespace vandplan::ros
