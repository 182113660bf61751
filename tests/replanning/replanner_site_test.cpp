// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// A replanner with a table of its site.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "support/problems.h"
#include "support/replans.h"
#include "support/sites.h"
#include "vandplan/planner.h"
#include "vandplan/replanner.h"
#include "vandplan/site_table.h"

namespace vandplan {
namespace {

using namespace sites;

constexpr std::int64_t gate = 7;
const Pose other_dock = {-20, 20, 2};

/// Two rooms that two gates join, far from the start and the goal. The one at the top is longer.
Scenario rooms() {
  Scenario scenario{.bounds = {-30, 30, -30, 30}, .start = {-25.3, 0.2, 0}, .goal = {20, 3, 1.5}};
  scenario.obstacles = {box(-30, -30.5, 30, -30), box(-30, 30, 30, 30.5), box(-1, -19, 1, 22),
                        box(-1, -30, 1, -28), box(-1, 28, 1, 30)};
  return scenario;
}

std::shared_ptr<ChangingSiteTable> site_of(const Scenario& scenario) {
  const std::vector<Pose> docks = {scenario.goal, other_dock};
  return std::make_shared<ChangingSiteTable>(make_problem(scenario), docks, drivers_options(),
                                             coarse);
}

/// Options of plans that are too short to find the way without a table.
ReplanOptions hurried(std::shared_ptr<ChangingSiteTable> site) {
  ReplanOptions options{.site = std::move(site), .tick_iterations = 2};
  options.plan.budget.max_iterations = 2;
  return options;
}

Scenario with_closed_gate(Scenario scenario) {
  scenario.obstacles.push_back(box(-1, -28.5, 1, -18.5));
  return scenario;
}

WorldPatch closing() { return {.added = {{gate, box(-1, -28.5, 1, -18.5)}}}; }

TEST(ReplannerWithSite, PlansAlongTheTable) {
  const Scenario scenario = rooms();
  Replanner without(scenario, hurried(nullptr));
  EXPECT_FALSE(without.tick(0).reaches_goal);
  Replanner replanner(scenario, hurried(site_of(scenario)));
  const ReplanAnswer answer = replanner.tick(0);
  EXPECT_TRUE(answer.reaches_goal);
  EXPECT_EQ(answer.without_site, "");
  EXPECT_EQ(fault_of(answer, scenario, 0), "");
}

TEST(ReplannerWithSite, RepairsTheTableWhereThePatchIs) {
  const Scenario scenario = rooms();
  const auto site = site_of(scenario);
  const auto untouched = site_of(scenario);
  Replanner replanner(scenario, hurried(site));
  ASSERT_TRUE(replanner.tick(0).reaches_goal);
  replanner.patch(closing());
  const ReplanAnswer answer = replanner.tick(1);
  EXPECT_EQ(answer.outcome, TickOutcome::new_way);
  EXPECT_TRUE(answer.reaches_goal);
  EXPECT_EQ(fault_of(answer, with_closed_gate(scenario), 1), "");
  const double closed = site->table().cost(scenario.start, 0);
  EXPECT_GT(closed, untouched->table().cost(scenario.start, 0) + 5);
  EXPECT_EQ(closed, site_of(with_closed_gate(scenario))->table().cost(scenario.start, 0));
  replanner.patch({.removed = {gate}});
  (void)replanner.tick(2);
  EXPECT_EQ(site->table().cost(scenario.start, 0), untouched->table().cost(scenario.start, 0));
}

TEST(ReplannerWithSite, LeavesTheTableAsideForAGoalThatItLacks) {
  const Scenario scenario = rooms();
  Replanner replanner(scenario, hurried(site_of(scenario)));
  ASSERT_TRUE(replanner.tick(0).reaches_goal);
  replanner.set_goal(Pose{-20, 10, 0});
  EXPECT_EQ(replanner.tick(1).without_site, "the table of the site has no such goal");
  replanner.set_goal(other_dock);
  EXPECT_EQ(replanner.tick(2).without_site, "");
}

TEST(ReplannerWithSite, PlansToAGoalThatTheTableLacks) {
  Scenario scenario = rooms();
  const auto site = site_of(scenario);
  scenario.goal = {-10, 3, 0};
  Replanner with(scenario, {.site = site});
  Replanner without(scenario);
  const ReplanAnswer answer = with.tick(0);
  EXPECT_TRUE(answer.reaches_goal);
  EXPECT_EQ(answer.drive->path, without.tick(0).drive->path);
}

TEST(ReplannerWithSite, GoesOnWithARepairThatWasCutShort) {
  const Scenario scenario = rooms();
  Replanner replanner(scenario, hurried(site_of(scenario)));
  ASSERT_TRUE(replanner.tick(0).reaches_goal);
  replanner.patch(closing());
  std::stop_source stopped;
  stopped.request_stop();
  EXPECT_EQ(replanner.tick(0.5, {.stop = stopped.get_token()}).without_site,
            "the time was over before the table of the site was repaired");
  const ReplanAnswer answer = replanner.tick(1);
  EXPECT_EQ(answer.without_site, "");
  EXPECT_TRUE(answer.reaches_goal);
}

TEST(ReplannerWithSite, TakesATableThatWasMadeFromAnotherStartOrBeforeSomethingParked) {
  Scenario scenario = rooms();
  scenario.start = {-10.6, -7.3, 1};
  const auto site = site_of(scenario);
  scenario = with_closed_gate(rooms());
  Replanner replanner(scenario, hurried(site));
  const ReplanAnswer answer = replanner.tick(0);
  EXPECT_TRUE(answer.reaches_goal);
  EXPECT_EQ(fault_of(answer, scenario, 0), "");
}

TEST(ReplannerWithSite, TwoMayShareATableAndAnswerAsAlone) {
  const Scenario scenario = rooms();
  Scenario back = scenario;
  std::swap(back.start, back.goal);
  back.goal = other_dock;
  const auto shared = site_of(scenario);
  Replanner first(scenario, hurried(shared));
  Replanner second(back, hurried(shared));
  Replanner alone(scenario, hurried(site_of(scenario)));
  for (int i = 0; i < 6; ++i) {
    const WorldPatch patch = i % 2 == 1 ? closing() : WorldPatch{.removed = {gate}};
    for (Replanner* const each : {&first, &second, &alone}) each->patch(patch);
    const ReplanAnswer answer = first.tick(i);
    EXPECT_TRUE(second.tick(i).reaches_goal) << i;
    const ReplanAnswer expected = alone.tick(i);
    EXPECT_EQ(answer.outcome, expected.outcome) << i;
    EXPECT_EQ(answer.drive->path, expected.drive->path) << i;
  }
}

TEST(ReplannerWithSite, PassesVias) {
  Scenario scenario = rooms();
  const auto site = site_of(scenario);
  GoalRegion place = region_of_pose(other_dock);
  scenario.via = {{{place}, true}};
  Replanner replanner(scenario, {.site = site});
  const ReplanAnswer answer = replanner.tick(0);
  EXPECT_TRUE(answer.reaches_goal);
  EXPECT_EQ(answer.without_site, "");
}

TEST(ReplannerWithSite, RefusesATableOfAnotherVehicleOrPrices) {
  Scenario scenario = rooms();
  const auto site = site_of(scenario);
  const auto told = [&](const ReplanOptions& options) {
    return refusal([&] { (void)Replanner(scenario, options); });
  };
  ReplanOptions options{.site = site};
  options.plan.cost.reverse_weight = 3;
  EXPECT_EQ(told(options),
            "site: the table was made for other options: prices (style), gears or margin differ");
  options = {};
  options.plan.site = std::make_shared<const SiteTable>(site->table());
  EXPECT_EQ(told(options),
            "site: is a table that no patch changes, expected a ChangingSiteTable in "
            "ReplanOptions::site");
  scenario.vehicle.width += 0.1;
  EXPECT_EQ(told({.site = site}),
            "site: the table was made for another vehicle: its body or radius differs");
}

}  // namespace
}  // namespace vandplan
