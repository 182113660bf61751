// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Rough costs of driving to everywhere, and the room that they ask for.
#include "search/drive_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "base/trigonometry.h"
#include "search/grid_distance.h"
#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using search::Connector, search::CostRule, search::DriveField, search::Driven;
using search::FieldOptions, search::GridDistance, search::ClearanceRaster;

constexpr Bounds area{-40, 40, -40, 40};
constexpr CostRule driver{
    .reverse_weight = 2, .gear_change_cost = 5, .curvature_change_cost = 5, .clearance_weight = 2};

std::vector<Polygon> some_boxes(Rng& rng) {
  std::vector<Polygon> boxes;
  for (int i = 0; i < 6; ++i) {
    const double x = uniform(-35, 30, rng);
    const double y = uniform(-35, 30, rng);
    boxes.push_back(box(x, y, x + uniform(1, 8, rng), y + uniform(1, 8, rng)));
  }
  return boxes;
}

Pose free_pose(const CollisionChecker& checker, Rng& rng) {
  while (true) {
    const Pose pose = uniform_pose({-30, 30, -30, 30}, rng);
    if (checker.is_free(Local(pose))) return pose;
  }
}

Problem some_problem(Rng& rng, const Vehicle& vehicle = {}) {
  while (true) {
    const std::vector<Polygon> boxes = some_boxes(rng);
    const Problem problem = problem_of(uniform_pose({-30, 30, -30, 30}, rng),
                                       uniform_pose({-30, 30, -30, 30}, rng), boxes, area, vehicle);
    const CollisionChecker& checker = *problem.task().checker;
    if (checker.is_free(problem.task().start) && checker.is_free(problem.task().goal))
      return problem;
  }
}

template <typename Work>
void finish(Work& work) {
  while (work.step()) {
  }
}

ClearanceRaster finished(ClearanceRaster room) {
  finish(room);
  return room;
}

double room_at(ClearanceRaster& raster, const Pose& pose) {
  const base::SinCos heading = base::sin_cos(pose.heading);
  return raster.clearance(static_cast<float>(pose.x), static_cast<float>(pose.y),
                          static_cast<float>(heading.cos), static_cast<float>(heading.sin));
}

// ---- room ----

TEST(ClearanceRaster, IsAboutTheClearance) {
  for_each_case(1, 40, [](Rng& rng) {
    const Problem problem = some_problem(rng);
    ClearanceRaster room = finished(ClearanceRaster(problem.task(), area, 3.0));
    for (int i = 0; i < 50; ++i) {
      const Pose pose = free_pose(*problem.task().checker, rng);
      const double clearance = problem.task().checker->clearance(Local(pose), 3.0);
      EXPECT_NEAR(std::min(room_at(room, pose), 3.0), clearance,
                  3 * static_cast<double>(room.fineness()));
    }
  });
}

TEST(ClearanceRaster, IsAboutTheClearanceFromTheCellsOfAMap) {
  constexpr std::int32_t columns = 120, rows = 100;
  std::vector<Cell> cells(columns * rows, Cell::free);
  for (std::size_t i = 40; i < 60; ++i) cells[50 * columns + i] = Cell::occupied;
  const OccupancyGrid map{.origin = {-30, -25, 0},
                          .resolution = 0.5,
                          .columns = columns,
                          .rows = rows,
                          .cells = std::move(cells)};
  const Problem problem = problem_in({.bounds = area, .map = map}, {-20, 10, 0}, {20, 10, 0});
  ClearanceRaster room = finished(ClearanceRaster(problem.task(), area, 3.0));
  for_each_case(2, 200, [&](Rng& rng) {
    const Pose pose = free_pose(*problem.task().checker, rng);
    const double clearance = problem.task().checker->clearance(Local(pose), 3.0);
    EXPECT_NEAR(std::min(room_at(room, pose), 3.0), clearance,
                3 * static_cast<double>(room.fineness()));
  });
}

TEST(ClearanceRaster, IsCountedFromTheMargin) {
  const Surroundings wall{.bounds = area, .obstacles = {box(-40, 10, 40, 11)}};
  const Pose pose{0, 0, 0};
  const Problem problem = problem_in(wall, pose, {20, 0, 0});
  Task task = problem.task();
  ClearanceRaster room = finished(ClearanceRaster(task, area, 9.0));
  task.least_margin = 1.5;
  ClearanceRaster with_margin = finished(ClearanceRaster(task, area, 9.0));
  EXPECT_NEAR(room_at(room, pose), 10 - task.vehicle.width / 2, 0.3);
  EXPECT_NEAR(room_at(room, pose) - room_at(with_margin, pose), 1.5, 1e-4);
}

TEST(ClearanceRaster, IsNoGroundForTrustBesideKerbsOrWithAnOutline) {
  const Problem open = problem_of({}, {20, 0, 0}, {});
  const Problem beside_kerb =
      problem_in({.bounds = area, .kerbs = {box(-5, 5, 5, 6)}}, {}, {20, 0, 0});
  Vehicle drop;
  drop.outline = {{-1, -1}, {4, -1}, {5, 0}, {4, 1}, {-1, 1}};
  const Problem with_outline = problem_of({}, {20, 0, 0}, {}, area, drop);
  EXPECT_TRUE(ClearanceRaster(open.task(), area, 1.0).is_trusted());
  EXPECT_FALSE(ClearanceRaster(beside_kerb.task(), area, 1.0).is_trusted());
  EXPECT_FALSE(ClearanceRaster(with_outline.task(), area, 1.0).is_trusted());
}

TEST(ClearanceRaster, TellsWhetherZonesForbidAnything) {
  const auto has_rules = [](const Zone& zone) {
    const Problem problem = problem_in({.bounds = area, .zones = {zone}}, {}, {20, 0, 0});
    const ClearanceRaster raster(problem.task(), area, 1.0);
    EXPECT_TRUE(raster.is_trusted());
    return raster.has_rules();
  };
  const Polygon square = box(-5, 5, 5, 15);
  EXPECT_FALSE(has_rules({.area = square, .cost = 3.0, .max_speed = 2.0}));
  EXPECT_TRUE(has_rules({.area = square, .closed = true}));
  EXPECT_TRUE(has_rules({.area = square, .gears = AllowedGears::forward}));
  EXPECT_TRUE(has_rules({.area = square, .direction = HeadingRange{-1, 1}}));
}

// ---- field ----

struct Fields {
  explicit Fields(const Problem& problem, const CostRule& rule, const FieldOptions& options = {},
                  double most = 400.0)
      : task(problem.task()),
        forth(task, rule),
        back(task, reversed(rule, 0)),
        guide(task, area, task.start, task.goal, {.side = 0.5 * task.vehicle.width}),
        room(finished(ClearanceRaster(task, area, 3.0))),
        from_goal(back, room, area, options, task.goal, 0, most),
        from_start(forth, room, area, options, task.start, 0, most) {
    finish(guide);
    from_goal.look_towards(guide);
  }

  Task task;
  Connector forth, back;
  GridDistance guide;
  ClearanceRaster room;
  DriveField from_goal, from_start;
};

/// The nodes that were closed.
std::vector<std::int32_t> spread(DriveField& field, int most = 20'000) {
  std::vector<std::int32_t> closed;
  for (int i = 0; i < most && !field.is_exhausted(); ++i) {
    const std::int32_t id = field.step();
    if (id != DriveField::none) closed.push_back(id);
  }
  return closed;
}

TEST(DriveField, AWayToANodeIsDrivenAsItIsCounted) {
  for_each_case(3, 20, [](Rng& rng) {
    const Problem problem = some_problem(rng);
    const bool minds_gears_alone = rng() % 2 == 0;
    const CostRule rule =
        minds_gears_alone ? CostRule{.reverse_weight = 2, .gear_change_cost = 5} : driver;
    Fields fields(problem, rule);
    const std::vector<std::int32_t> closed = spread(fields.from_goal);
    ASSERT_GT(closed.size(), 100U);
    for (std::size_t n = 0; n < closed.size(); n += 97) {
      std::vector<Segment> steps;
      std::int32_t id = closed[n];
      const DriveField::Node& last = fields.from_goal.node(id);
      for (; fields.from_goal.node(id).parent != DriveField::none;
           id = fields.from_goal.node(id).parent) {
        steps.insert(steps.begin(), fields.from_goal.step_to(fields.from_goal.node(id)));
      }
      const Pose end = end_pose({problem.goal(), steps});
      const Pose pose = fields.from_goal.pose(last);
      EXPECT_NEAR(std::hypot(end.x - pose.x, end.y - pose.y), 0.0, 2e-3);
      EXPECT_NEAR(wrap_angle(end.heading - pose.heading), 0.0, 1e-9);
      Driven driven = 0;
      const double driving = drive_cost(fields.back.rule(), steps, driven);
      const double near = fields.back.clearance_cost(problem.task().goal, steps);
      const double counted = static_cast<double>(last.cost);
      EXPECT_NEAR(counted, driving + near, 0.5 * near + 0.02 * driving + 0.5);
      if (minds_gears_alone) {
        EXPECT_NEAR(counted, driving, 1e-4 * driving + 1e-4);
      }
      EXPECT_GE(counted * (1 + 1e-5) + 1e-3,
                fields.back.least_cost(problem.task().goal, Local(end), {Driven(0), driven.gear}));
    }
  });
}

TEST(DriveField, WaitsForNothingWhereTheOtherFieldKnowsNoWay) {
  for_each_case(5, 5, [](Rng& rng) {
    const Problem problem = some_problem(rng);
    Fields fields(problem, driver, {}, std::numeric_limits<double>::infinity());
    fields.from_start.look_towards(fields.from_goal);  // which has not begun
    EXPECT_TRUE(fields.from_start.is_exhausted());
  });
}

TEST(DriveField, HardlyAnyStepIsBlocked) {
  for_each_case(4, 20, [](Rng& rng) {
    const Problem problem = some_problem(rng);
    Fields fields(problem, driver);
    int blocked = 0;
    const std::vector<std::int32_t> closed = spread(fields.from_goal);
    for (const std::int32_t id : closed) {
      const DriveField::Node& node = fields.from_goal.node(id);
      if (node.parent == DriveField::none) continue;
      const Pose from = fields.from_goal.pose(fields.from_goal.node(node.parent));
      blocked += fields.back.is_free(Local(from), fields.from_goal.step_to(node)) ? 0 : 1;
    }
    EXPECT_LT(blocked, 0.02 * static_cast<double>(closed.size()));
  });
}

TEST(DriveField, NoStepBreaksARule) {
  const std::vector<Zone> zones = {
      {.area = box(-20, -10, -5, 10), .closed = true},
      {.area = box(0, -20, 15, 0), .gears = AllowedGears::forward},
      {.area = box(-10, 12, 20, 25), .direction = HeadingRange{-1, 1}},
  };
  const Problem problem = problem_in({.bounds = area, .zones = zones}, {-30, 0, 0}, {30, 0, 0});
  Fields fields(problem, driver);
  for (const auto& [field, connector] :
       {std::pair{&fields.from_goal, &fields.back}, std::pair{&fields.from_start, &fields.forth}}) {
    if (field == &fields.from_start) field->look_towards(fields.from_goal);
    const std::vector<std::int32_t> closed = spread(*field);
    EXPECT_GT(closed.size(), 1000U);
    for (const std::int32_t id : closed) {
      const DriveField::Node& node = field->node(id);
      if (node.parent == DriveField::none) continue;
      const Pose from = field->pose(field->node(node.parent));
      ASSERT_TRUE(connector->obeys_zones(Local(from), field->step_to(node)));
    }
  }
}

TEST(DriveField, KnowsAboutWhatOpenGroundCosts) {
  for_each_case(5, 20, [](Rng& rng) {
    const Problem problem = problem_of(uniform_pose({-20, 20, -20, 20}, rng),
                                       uniform_pose({-20, 20, -20, 20}, rng), {}, area);
    Fields fields(problem, {}, {.headings = 36, .cell = 0.2});
    (void)spread(fields.from_goal, 400'000);
    fields.from_start.look_towards(fields.from_goal);
    ASSERT_FALSE(fields.from_start.is_exhausted());
    const double shortest =
        reeds_shepp_length(problem.start(), problem.goal(), problem.vehicle().min_turning_radius);
    // A cell is 1.7 m, and a way on the lattice some percent too long.
    EXPECT_GE(fields.from_start.least_cost(), shortest - 5.0);
    EXPECT_LE(fields.from_start.least_cost(), 1.15 * shortest + 5.0);
  });
}

TEST(DriveField, GoesOnWhereTheOtherOneHasBeen) {
  for_each_case(6, 20, [](Rng& rng) {
    const Problem problem = some_problem(rng);
    Fields fields(problem, driver);
    const std::vector<std::int32_t> closed = spread(fields.from_goal);
    for (std::size_t n = 1; n < closed.size(); n += 53) {
      // The way back to a node, driven forth, ends in the gear of its last step turned around.
      DriveField::Node node = fields.from_goal.node(closed[n]);
      node.gear = static_cast<std::int8_t>(-node.gear);
      const auto rolling_on = fields.from_goal.onward(fields.from_goal, node);
      EXPECT_LE(rolling_on.cost, fields.from_goal.node(closed[n]).cost);
      if (rolling_on.cost == fields.from_goal.node(closed[n]).cost) {
        EXPECT_EQ(rolling_on.node, closed[n]);
      }
      node.gear = static_cast<std::int8_t>(-node.gear);
      const auto changing = fields.from_goal.onward(fields.from_goal, node);
      EXPECT_LE(changing.cost, rolling_on.cost + 5.0F);
      EXPECT_GE(changing.cost, rolling_on.cost - 5.0F - 1e-3F);
    }
    DriveField::Node outside{};
    outside.x = 1000;
    EXPECT_EQ(fields.from_goal.onward(fields.from_start, outside).node, DriveField::none);
  });
}

TEST(DriveField, NoWayCostsMoreThanTheCutoff) {
  const Problem problem = problem_of({20, 0, 0}, {0, 0, 0}, {}, area);
  Fields fields(problem, driver, {}, 30.0);
  for (const std::int32_t id : spread(fields.from_goal, 400'000)) {
    EXPECT_LE(fields.from_goal.node(id).cost, 30.0F);
  }
  EXPECT_TRUE(fields.from_goal.is_exhausted());

  Fields lower(problem, driver, {}, 60.0);
  lower.from_goal.set_cutoff(25.0);
  lower.from_goal.set_cutoff(50.0);  // does not raise it
  for (const std::int32_t id : spread(lower.from_goal, 400'000)) {
    EXPECT_LE(lower.from_goal.node(id).cost, 25.0F);
  }
}

}  // namespace
}  // namespace vandplan
