// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Tables that are repaired where a site changes, against tables that are made anew.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/cases.h"
#include "support/problems.h"
#include "support/sites.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

using namespace sites;

constexpr Bounds court{-25, 25, -25, 25};
const std::vector<Pose> docks = {{0, 0, 0}, {12, -10, 2}};

/// A court with some crates. Specks in its corners make the table as large as the court.
Scenario court_of_crates(Rng& rng) {
  Scenario scenario{.bounds = court, .start = {-20, 0, 0}, .goal = docks[0]};
  scenario.obstacles = {box(24, 24, 25, 25), box(-25, -25, -24, -24)};
  for (int i = 0; i < 3; ++i) {
    const double x = uniform(-22, 20, rng);
    const double y = uniform(-22, 20, rng);
    if (std::abs(x) < 10 && std::abs(y) < 6) continue;
    scenario.obstacles.push_back(box(x, y, x + uniform(0.5, 3, rng), y + uniform(0.5, 3, rng)));
  }
  return scenario;
}

/// The outline of a parked vehicle, anywhere in the court.
Polygon parked(Rng& rng) {
  const auto outline = corners({3, uniform(1, 5, rng), 1.2}, uniform_pose(court, rng));
  return {outline.begin(), outline.end()};
}

Problem in_world(const std::shared_ptr<const World>& world) {
  return make_problem(world, Vehicle{}, {-20, 0, 0}, docks[0]);
}

/// Options under which a repair is tried, by number.
PlanOptions options_of(int number) {
  PlanOptions options = number % 2 == 0 ? drivers_options() : length_options();
  if (number == 2) options.cost.gears = AllowedGears::forward;
  if (number == 4) options.clearance = {.margin = 0.4, .margin_ramp = 5.0};
  if (number == 3) options.cost.clearance_weight = 2.0;
  return options;
}

/// How many goals of a world are free.
std::size_t free_docks(const Problem& problem, const PlanOptions& options) {
  std::size_t count = 0;
  for (const Pose& dock : docks) {
    const Task task = task_of(with_poses(problem, dock, dock), options.clearance);
    count += task.checker->is_free(task.goal) ? 1U : 0U;
  }
  return count;
}

/// Expects what a table made anew says. Returns whether all goals are free.
bool expect_as_anew(const ChangingSiteTable& changing, const Problem& problem,
                    const PlanOptions& options) {
  if (free_docks(problem, options) < docks.size()) return false;
  const SiteTable anew = make_site_table(problem, docks, options, coarse).value();
  EXPECT_EQ(site_table_to_bytes(changing.table()), site_table_to_bytes(anew));
  return true;
}

/// Vehicles park in a court and leave. Returns how many tables were compared with new ones.
int compared_while_parking(Rng& rng) {
  const PlanOptions options = options_of(static_cast<int>(rng() % 5));
  ChangingWorld ground(surroundings(court_of_crates(rng)), {-20, 0});
  if (free_docks(in_world(ground.world()), options) < docks.size()) return 0;
  ChangingSiteTable changing(in_world(ground.world()), docks, options, coarse);
  int compared = 0;
  for (int i = 0; i < 12; ++i) {
    WorldPatch patch;
    for (std::size_t k = rng() % 3 + 1; k > 0; --k) {
      const auto name = static_cast<std::int64_t>(100 + rng() % 5);
      if (uniform01(rng) < 0.5) {
        patch.removed.push_back(name);
      } else {
        patch.added.push_back({name, parked(rng)});
      }
    }
    ground.patch(patch);
    const Problem problem = in_world(ground.world());
    changing.repair(problem);
    compared += expect_as_anew(changing, problem, options) ? 1 : 0;
  }
  return compared;
}

TEST(ChangingSiteTable, IsAsMadeAnewWhenObstaclesComeAndGo) {
  int compared = 0;
  for_each_case(1, 12, [&](Rng& rng) { compared += compared_while_parking(rng); });
  EXPECT_GT(compared, cases(12) * 5);
}

TEST(ChangingSiteTable, AsksAgainForWhatALabelKeptFromTheOtherGear) {
  for_each_case(34, 5, [](Rng& rng) { (void)compared_while_parking(rng); });
}

TEST(ChangingSiteTable, SeesThatABodyWouldTurnIntoWhatCame) {
  for_each_case(32, 5, [](Rng& rng) { (void)compared_while_parking(rng); });
}

TEST(ChangingSiteTable, IsAsMadeAnewHoweverOftenARepairIsCutShort) {
  int cuts = 0;
  for_each_case(31, 12, [&](Rng& rng) {
    const PlanOptions options = options_of(static_cast<int>(rng() % 5));
    ChangingWorld ground(surroundings(court_of_crates(rng)), {-20, 0});
    if (free_docks(in_world(ground.world()), options) < docks.size()) return;
    ChangingSiteTable changing(in_world(ground.world()), docks, options, coarse);
    const std::vector<std::size_t> goals = {0, 1};
    for (int i = 0; i < 6; ++i) {
      for (int k = 0; k < 3; ++k) {
        const auto name = static_cast<std::int64_t>(100 + rng() % 4);
        WorldPatch patch{.added = {{name, parked(rng)}}};
        if (uniform01(rng) < 0.4) patch = {.removed = {name}};
        ground.patch(patch);
        auto left = static_cast<int>(rng() % 60);
        const std::vector<std::size_t> some(goals.begin(),
                                            goals.begin() + (rng() % 2 == 0 ? 1 : 2));
        const auto is_over = [&left] { return --left < 0; };
        cuts += changing.repair(in_world(ground.world()), some, is_over) ? 0 : 1;
      }
      const Problem problem = in_world(ground.world());
      EXPECT_TRUE(changing.repair(problem, goals, [] { return false; }));
      (void)expect_as_anew(changing, problem, options);
    }
  });
  EXPECT_GT(cuts, cases(12) * 2);
}

TEST(ChangingSiteTable, KnowsNoWayToAGoalThatWasLeftOut) {
  Rng rng(4);
  ChangingWorld ground(surroundings(court_of_crates(rng)), {-20, 0});
  ChangingSiteTable changing(in_world(ground.world()), docks, drivers_options(), coarse);
  const Pose pose{-15, 5, 0};
  const std::size_t second[] = {1};
  ground.patch({.added = {{7, box(-12, -9, -9, -7)}}});
  const auto never = [] { return false; };
  ASSERT_TRUE(changing.repair(in_world(ground.world()), second, never));
  EXPECT_TRUE(std::isinf(changing.table().cost(pose, 0)));
  EXPECT_FALSE(std::isinf(changing.table().cost(pose, 1)));
  const std::size_t first[] = {0};
  ASSERT_TRUE(changing.repair(in_world(ground.world()), first, never));
  EXPECT_TRUE(expect_as_anew(changing, in_world(ground.world()), drivers_options()));
  const std::size_t none[] = {2};
  EXPECT_EQ(refusal([&] { (void)changing.repair(in_world(ground.world()), none, never); }),
            "goals: expected numbers of goals of the table");
}

TEST(ChangingSiteTable, StaysWhileItsRepairIsCutShort) {
  Rng rng(4);
  ChangingWorld ground(surroundings(court_of_crates(rng)), {-20, 0});
  ChangingSiteTable changing(in_world(ground.world()), docks, drivers_options(), coarse);
  const std::string before(site_table_to_bytes(changing.table()));
  ground.patch({.added = {{7, box(-12, -9, -9, -7)}}});
  const std::size_t goals[] = {0, 1};
  EXPECT_FALSE(changing.repair(in_world(ground.world()), goals, [] { return true; }));
  EXPECT_EQ(site_table_to_bytes(changing.table()), before);
}

TEST(ChangingSiteTable, IsRepairedForAScenarioWhereverItsStartIs) {
  Rng rng(4);
  Scenario scenario = court_of_crates(rng);
  ChangingSiteTable changing(make_problem(scenario), docks, drivers_options(), coarse);
  EXPECT_EQ(changing.origin(), (Point{-20, 0}));
  const Scenario before = scenario;
  scenario.obstacles.push_back(box(-12, -9, -9, -7));
  const Problem problem = make_problem(scenario);
  scenario.start = {10, 15, 1};
  changing.repair(scenario);
  EXPECT_EQ(changing.origin(), (Point{-20, 0}));
  EXPECT_TRUE(expect_as_anew(changing, problem, drivers_options()));
}

TEST(ChangingSiteTable, IsAsMadeAnewWhenCellsOfAMapChange) {
  for_each_case(2, 6, [&](Rng& rng) {
    Scenario scenario = court_of_crates(rng);
    scenario.map = OccupancyGrid{.origin = {-30, -30, 0.1 * uniform01(rng)},
                                 .resolution = 0.5,
                                 .columns = 130,
                                 .rows = 130,
                                 .cells = std::vector<Cell>(130 * 130, Cell::free),
                                 .unknown_is_free = true};
    const PlanOptions options = options_of(static_cast<int>(rng() % 5));
    ChangingWorld ground(surroundings(scenario), {-20, 0});
    if (free_docks(in_world(ground.world()), options) < docks.size()) return;
    ChangingSiteTable changing(in_world(ground.world()), docks, options, coarse);
    for (int i = 0; i < 8; ++i) {
      CellPatch cells{.column = static_cast<std::int32_t>(rng() % 120),
                      .row = static_cast<std::int32_t>(rng() % 120),
                      .columns = static_cast<std::int32_t>(1 + rng() % 8),
                      .rows = static_cast<std::int32_t>(1 + rng() % 8)};
      for (std::int32_t k = cells.columns * cells.rows; k > 0; --k) {
        cells.cells.push_back(uniform01(rng) < 0.1 ? Cell::occupied : Cell::free);
      }
      ground.patch({.cells = {cells}});
      const Problem problem = in_world(ground.world());
      changing.repair(problem);
      (void)expect_as_anew(changing, problem, options);
    }
  });
}

TEST(ChangingSiteTable, IsAsMadeAnewWhenZonesChange) {
  for_each_case(3, 2, [&](Rng& rng) {
    Scenario scenario = court_of_crates(rng);
    const PlanOptions options = options_of(static_cast<int>(rng() % 5));
    const auto problem_now = [&] { return make_problem(scenario); };
    if (free_docks(problem_now(), options) < docks.size()) return;
    ChangingSiteTable changing(problem_now(), docks, options, coarse);
    for (int i = 0; i < 8; ++i) {
      Zone zone{.area = parked(rng)};
      const double kind = uniform01(rng);
      if (kind < 0.3) {
        zone.closed = true;
      } else if (kind < 0.5) {
        zone.gears = AllowedGears::forward;
      } else {
        zone.cost = 3.0;
      }
      zone.body = uniform01(rng) < 0.3;
      if (scenario.zones.size() > rng() % 4) {
        scenario.zones.erase(scenario.zones.begin());
      } else {
        scenario.zones.push_back(zone);
      }
      const Problem problem = problem_now();
      changing.repair(problem);
      (void)expect_as_anew(changing, problem, options);
    }
  });
}

TEST(ChangingSiteTable, KnowsNoWayToAGoalThatIsTaken) {
  Rng rng(4);
  ChangingWorld ground(surroundings(court_of_crates(rng)), {-20, 0});
  const PlanOptions options = drivers_options();
  ChangingSiteTable changing(in_world(ground.world()), docks, options, coarse);
  const SiteTable before = changing.table();
  ground.patch({.added = {{7, box(-1, -1, 4, 1)}}});
  changing.repair(in_world(ground.world()));
  EXPECT_TRUE(std::isinf(changing.table().cost({-15, 5, 0}, 0)));
  EXPECT_FALSE(std::isinf(changing.table().cost({-15, 5, 0}, 1)));
  EXPECT_FALSE(std::isinf(before.cost({-15, 5, 0}, 0)));  // a copy stays as it is
  ground.patch({.removed = {7}});
  changing.repair(in_world(ground.world()));
  EXPECT_EQ(site_table_to_bytes(changing.table()), site_table_to_bytes(before));
}

TEST(ChangingSiteTable, KeepsReachingItsStarts) {
  Rng rng(4);
  Scenario scenario = court_of_crates(rng);
  scenario.bounds = {-90, 90, -90, 90};
  const SiteTableOptions far{.headings = 24, .cell = 0.25, .starts = {{60, 0, 0}}};
  ChangingSiteTable changing(make_problem(scenario), docks, drivers_options(), far);
  for (int i = 0; i < 2; ++i) {  // repaired, then made anew
    scenario.obstacles.push_back(box(-12, -9, -9, -7 + i));
    scenario.bounds.x_max -= i;
    const Problem problem = make_problem(scenario);
    changing.repair(problem);
    const SiteTable anew = make_site_table(problem, docks, drivers_options(), far).value();
    EXPECT_EQ(site_table_to_bytes(changing.table()), site_table_to_bytes(anew));
    EXPECT_FALSE(std::isinf(anew.cost({60, 0, 0}, 0)));
  }
}

TEST(ChangingSiteTable, IsMadeAnewInOtherBounds) {
  Rng rng(4);
  Scenario scenario = court_of_crates(rng);
  const PlanOptions options = drivers_options();
  ChangingSiteTable changing(make_problem(scenario), docks, options, coarse);
  scenario.bounds.x_max = 20;
  changing.repair(make_problem(scenario));
  EXPECT_TRUE(expect_as_anew(changing, make_problem(scenario), options));
}

TEST(ChangingSiteTable, RefusesAnotherVehicleAndWhatMoves) {
  Rng rng(4);
  const Scenario scenario = court_of_crates(rng);
  ChangingSiteTable changing(make_problem(scenario), docks, drivers_options(), coarse);
  Scenario wider = scenario;
  wider.vehicle.width += 0.1;
  EXPECT_EQ(refusal([&] { changing.repair(make_problem(wider)); }).substr(0, 8), "problem:");
  Scenario faster = scenario;
  faster.vehicle.limits.max_speed.forward = 7;
  EXPECT_EQ(refusal([&] { changing.repair(make_problem(faster)); }), "no refusal");
  Scenario busy = scenario;
  busy.moving = {{box(-1, -1, 1, 1), {{0, {-20, 20, 0}}, {5, {-15, 20, 0}}}}};
  EXPECT_EQ(refusal([&] { changing.repair(busy); }).substr(0, 8), "problem:");
}

}  // namespace
}  // namespace vandplan
