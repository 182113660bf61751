// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Rules of zones in the eyes of planners and of the judge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "problem/masks.h"
#include "search/zone_bound.h"
#include "support/cases.h"
#include "support/draws.h"
#include "support/grids.h"
#include "support/place_of_error.h"
#include "support/problems.h"
#include "support/zoned.h"
#include "vandplan/judge.h"
#include "vandplan/motion.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using std::numbers::pi;

/// Whether a point of the path is in the area, more than a millimetre from its edge, in that gear.
bool drives_through(const Path& path, const Bounds& area, Gear gear) {
  for (const PathPoint& point : sampled(path, 0.01)) {
    const auto& [x, y, heading] = point.pose;
    const bool is_in = x > area.x_min + 1e-3 && x < area.x_max - 1e-3 && y > area.y_min + 1e-3 &&
                       y < area.y_max - 1e-3;
    if (is_in && point.gear == gear) return true;
  }
  return false;
}

TEST(Zones, PathsGoAroundClosedOnes) {
  const Zone closed{.name = "lawn", .area = box(15, -5, 25, 8), .closed = true};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {closed}));
  const PlanResult result = plan(problem, of_iterations(3000));
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_GT(result.path->segments.size(), 1U);
  EXPECT_FALSE(drives_through(*result.path, {15, 25, -5, 8}, Gear::forward));
  EXPECT_LT(result.cost, 46);
}

TEST(Zones, PathsKeepToTheGearsOfOnes) {
  // The shortest way to a goal that points back is in reverse.
  for (const AllowedGears gears : {AllowedGears::forward, AllowedGears::reverse}) {
    const bool is_forward = gears == AllowedGears::forward;
    const Zone ramp{.area = box(5, -30, 15, 30), .gears = gears};
    const double heading = is_forward ? pi : 0;
    const Problem problem = make_problem(with_zones({0, 0, heading}, {25, 0, heading}, {ramp}));
    const PlanResult result = plan(problem, of_iterations(4000));
    if (is_sanitized && !result.path) return;
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_FALSE(
        drives_through(*result.path, {5, 15, -30, 30}, is_forward ? Gear::reverse : Gear::forward));
    EXPECT_TRUE(
        drives_through(*result.path, {5, 15, -30, 30}, is_forward ? Gear::forward : Gear::reverse));
  }
}

TEST(Zones, OneWayStreetsAreLeftByTheOtherWay) {
  // Two lanes through a wall; one leads to the east, the other one to the west.
  Scenario scenario =
      with_zones({0, 0, 0}, {40, 0, 0},
                 {{.area = box(16, -9, 24, 0), .direction = HeadingRange{pi - 0.6, pi + 0.6}},
                  {.area = box(16, 0, 24, 9), .direction = HeadingRange{-0.6, 0.6}}});
  scenario.obstacles = {box(16, 9, 24, 40), box(16, -40, 24, -9)};
  for (const bool is_back : {false, true}) {
    if (is_back) {
      std::swap(scenario.start, scenario.goal);
      scenario.start.heading = scenario.goal.heading = pi;
    }
    const PlanResult result = plan(make_problem(scenario), of_iterations(4000));
    if (is_sanitized && !result.path) return;
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    for (const PathPoint& point : sampled(*result.path, 0.05)) {
      if (point.pose.x < 16 || point.pose.x > 24) continue;
      EXPECT_TRUE(is_back ? point.pose.y < 1e-3 : point.pose.y > -1e-3) << point.pose.y;
    }
  }
}

TEST(Zones, TheJudgeRefusesWhatBreaksARuleByAMillimetre) {
  const auto check = [](const Zone& zone, const Path& path) {
    return check_path(make_problem(with_zones(path.start, end_pose(path), {zone})), path);
  };
  const Zone closed{.name = "lawn", .area = box(10, -5, 20, 5), .closed = true};
  EXPECT_TRUE(check(closed, {{0, 0, 0}, {{0, 9.9999}}}).valid);
  const PathCheck in = check(closed, {{0, 0, 0}, {{0, 10.001}}});
  EXPECT_EQ(in.reason, "the rear axle is in zones[0] (lawn), which is closed");
  EXPECT_EQ(in.hit, (Hit{HitKind::zone, 0}));
  // A corner of a millimetre is cut.
  EXPECT_FALSE(
      check({.area = {{10, -1e-3}, {11, -3}, {9, -3}}, .closed = true}, {{0, -2e-3, 0}, {{0, 20}}})
          .valid);
  const Zone one_gear{.area = box(10, -5, 20, 5), .gears = AllowedGears::forward};
  EXPECT_TRUE(check(one_gear, {{0, 0, 0}, {{0, 30}}}).valid);
  EXPECT_TRUE(check(one_gear, {{0, 0, pi}, {{0, -9.9999}, {0, 5}}}).valid);
  EXPECT_EQ(check(one_gear, {{0, 0, pi}, {{0, -10.001}, {0, 5}}}).reason,
            "the rear axle is in zones[0], where the gears are: forward");
  const Zone street{.area = box(10, -5, 20, 5), .direction = HeadingRange{-0.5, 0.5}};
  EXPECT_TRUE(check(street, {{0, 0, 0}, {{0, 30}}}).valid);
  EXPECT_TRUE(check(street, {{30, 0, pi}, {{0, -30}}}).valid);
  EXPECT_EQ(check(street, {{30, 0, pi}, {{0, 30}}}).reason,
            "the rear axle is in zones[0], where the direction of travel is -0.5 to 0.5 rad");
  EXPECT_TRUE(check(street, {{10, 0, 0}, {{0.1, 5}}}).valid);
  EXPECT_FALSE(check(street, {{10, 0, 0}, {{0.1, 5.001}}}).valid);
  // The wheels turn on the way.
  EXPECT_TRUE(check(street, {{10, 0, 0}, {{0, std::sqrt(50), 0.02}}}).valid);
  EXPECT_FALSE(check(street, {{10, 0, 0}, {{0, 7.073, 0.02}}}).valid);
}

TEST(Zones, OfTheBodyHoldForTheTrailerToo) {
  Scenario scenario = with_zones({0, 0, 0}, {10, 0, 0},
                                 {{.area = box(-9, -1, -8, 1), .closed = true, .body = true}});
  scenario.vehicle = semitrailer();
  const PathCheck check = check_path(make_problem(scenario), {{0, 0, 0}, {{0, 10}}});
  EXPECT_EQ(check.reason, "the trailer is in zones[0], which is closed");
  scenario.zones[0].body = false;
  EXPECT_TRUE(check_path(make_problem(scenario), {{0, 0, 0}, {{0, 10}}}).valid);
}

TEST(Zones, AStartInAClosedOneIsInCollision) {
  const Zone closed{.name = "lawn", .area = box(-1, -1, 1, 1), .closed = true};
  const PlanResult result =
      plan(make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {closed})), of_iterations(10));
  EXPECT_EQ(result.status, PlanStatus::start_in_collision);
  EXPECT_EQ(result.reason, "the rear axle is in zones[0] (lawn), which is closed");
  EXPECT_EQ(result.hit, (Hit{HitKind::zone, 0}));
  const PlanResult back =
      plan(make_problem(with_zones({40, 0, 0}, {0, 0, 0}, {closed})), of_iterations(10));
  EXPECT_EQ(back.status, PlanStatus::goal_in_collision);
}

/// A one-way street that leads to the east, around the origin.
Zone street_east() { return {.area = box(-5, -5, 5, 5), .direction = HeadingRange{-0.5, 0.5}}; }

TEST(Zones, AStartThatNoGearMayLeaveIsRefusedAtOnce) {
  const auto status_from = [](const Pose& start, AllowedGears gears) {
    PlanOptions options = of_iterations(1000);
    options.cost.gears = gears;
    return plan(make_problem(with_zones(start, {40, 0, 0}, {street_east()})), options).status;
  };
  EXPECT_EQ(status_from({0, 0, 0.4}, AllowedGears::both), PlanStatus::solved);
  EXPECT_EQ(status_from({0, 0, 0.6}, AllowedGears::both), PlanStatus::start_in_collision);
  EXPECT_EQ(status_from({0, 0, 3.1}, AllowedGears::both), PlanStatus::solved);  // backs out
  EXPECT_EQ(status_from({0, 0, 3.1}, AllowedGears::forward), PlanStatus::start_in_collision);
  EXPECT_EQ(status_from({0, 5.01, 0.6}, AllowedGears::both), PlanStatus::solved);
}

TEST(Zones, AGoalToWhichNoGearMayComeIsRefusedAtOnce) {
  Zone only_back = street_east();
  only_back.direction.reset();
  only_back.gears = AllowedGears::reverse;
  for (const Zone& zone : {street_east(), only_back}) {
    PlanOptions options = of_iterations(1000);
    options.cost.gears = AllowedGears::forward;
    const PlanResult result =
        plan(make_problem(with_zones({-30, 0, 0}, {0, 0, 1.5}, {zone})), options);
    EXPECT_EQ(result.status, PlanStatus::goal_in_collision);
    EXPECT_EQ(result.reason, "zones let the vehicle come to the goal in no gear");
    EXPECT_EQ(result.iterations, 0);
  }
  const PlanResult there =
      plan(make_problem(with_zones({0, 0, 1.5}, {0, 0, 1.5}, {street_east()})), of_iterations(10));
  EXPECT_EQ(there.status, PlanStatus::solved);
}

TEST(Zones, OfASetTheGoalsAreTakenToWhichAGearMayCome) {
  Scenario scenario = with_zones({-30, 0, 0}, {0, 0, 1.5}, {street_east()});
  scenario.goal_set = {region_of_pose({0, 0, 1.5}), region_of_pose({0, 0, 0.2})};
  const PlanResult result = plan(make_problem(scenario), of_iterations(1000));
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_EQ(result.goal->index, 1U);
  scenario.goal_set.pop_back();
  scenario.goal_set[0].heading = {1.5, 1.6};
  const PlanResult none = plan(make_problem(scenario), of_iterations(1000));
  EXPECT_EQ(none.status, PlanStatus::goal_in_collision);
  EXPECT_NE(none.reason.find("is free, and zones let the vehicle come there"), std::string::npos)
      << none.reason;
}

TEST(Zones, AreChecked) {
  const auto fault = [](Zone zone) {
    return place_of_error([&] {
      check_scenario(
          with_zones({}, {9, 0, 0}, {{.area = box(0, 0, 1, 1), .closed = true}, std::move(zone)}));
    });
  };
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .closed = true}), "nothing");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1)}), "zones[1]");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .cost = 0.5}), "zones[1].cost");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .cost = 1001}), "zones[1].cost");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .max_speed = 0}), "zones[1].max_speed");
  EXPECT_EQ(fault({.area = {{0, 0}, {1, 1}}, .closed = true}), "zones[1].area");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .direction = HeadingRange{0, 7}}),
            "zones[1].direction");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .direction = HeadingRange{0, std::nan("")}}),
            "zones[1].direction");
  // Rounding decides whether it is one direction or all.
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .direction = HeadingRange{-1.4, -1.4 - 2 * pi}}),
            "zones[1].direction");
  EXPECT_EQ(fault({.area = box(0, 0, 1, 1), .direction = HeadingRange{2 * pi, 1.0}}), "nothing");
}

TEST(Zones, AreRefusedByPlannersThatDoNotKnowTheGear) {
  const auto place = [](const Zone& zone) {
    const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {zone}));
    return place_of_error([&] { (void)plan(problem, planner_named("prm"), of_iterations(100)); });
  };
  EXPECT_EQ(place({.area = box(15, -5, 25, 5), .gears = AllowedGears::forward}), "zones");
  EXPECT_EQ(place({.area = box(15, -5, 25, 5), .direction = HeadingRange{-1, 1}}), "zones");
  EXPECT_EQ(place({.area = box(15, -5, 25, 5), .closed = true}), "nothing");
}

TEST(Zones, OfAllKindsAreHonouredByEveryPlanner) {
  const std::vector<Zone> zones = {{.area = box(10, -4, 14, 4), .direction = HeadingRange{-1, 1}},
                                   {.area = box(16, -4, 20, 4), .gears = AllowedGears::forward},
                                   {.area = box(22, -20, 24, -1), .closed = true, .body = true},
                                   {.area = box(26, -4, 30, 4), .cost = 2}};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, zones));
  for (const Planner& planner : planners()) {
    if (!planner.can(Capability::gears)) continue;
    const PlanResult result = plan(problem, planner, of_iterations(300));
    EXPECT_NE(result.status, PlanStatus::rejected) << planner.name << ": " << result.reason;
    EXPECT_NE(result.status, PlanStatus::no_path) << planner.name;
  }
}

TEST(PricesOfZones, AreIntegrals) {
  const std::vector<Zone> zones = {{.area = box(10, -5, 20, 5), .cost = 3},
                                   {.area = box(15, -1, 40, 5), .cost = 10}};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {30, 0, 0}, zones));
  EXPECT_NEAR(cost_of(problem, {{0, 0, 0}, {{0, 30}}}), 10 + 5 * 3 + 5 * 30 + 10 * 10, 1e-9);
  const CostOptions twice{.reverse_weight = 2};
  EXPECT_NEAR(cost_of(problem, {{0, 0, 0}, {{0, 12}, {0, -12}}}, twice), 3 * (10 + 2 * 3), 1e-9);
  // A quarter of a circle of 10 m around (10, 10), half of it in the zone.
  const Zone half{.area = box(10 + 10 * std::sqrt(0.5), -50, 60, 50), .cost = 101};
  const Problem arc = make_problem(with_zones({10, 0, 0}, {20, 10, pi / 2}, {half}));
  EXPECT_NEAR(cost_of(arc, {{10, 0, 0}, {{0.1, 5 * pi}}}), 5 * pi * (1 + 100.0 / 2), 1e-7);
}

// Where time has no price, planners ask for prices alone: edges of speeds would cut segments in
// vain.
TEST(PricesOfZones, AreToldWithoutSpeeds) {
  const Zone dear{.area = box(10, -5, 20, 5), .cost = 2.0};
  const Zone slow{.area = box(15, -5, 30, 5), .max_speed = 1.0};
  const Zone both{.area = box(30, -5, 35, 5), .cost = 3.0, .max_speed = 2.0};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {slow, both, dear}));
  const auto ends_of = [&](GroundRules which) {
    std::vector<double> ends;
    for (const GroundPart& part :
         problem.task().checker->ground_along(start_state(problem.task()), {0.0, 40.0}, which)) {
      ends.push_back(part.end);
      EXPECT_TRUE(which == GroundRules::all || std::isinf(part.max_speed));
    }
    return ends;
  };
  const auto near = [](const std::vector<double>& a, const std::vector<double>& b) {
    return std::ranges::equal(a, b, [](double x, double y) { return std::abs(x - y) < 1e-9; });
  };
  EXPECT_TRUE(near(ends_of(GroundRules::all), {10, 15, 20, 30, 35, 40}));
  EXPECT_TRUE(near(ends_of(GroundRules::prices), {10, 20, 30, 35, 40}));
}

TEST(PricesOfZones, MultiplyThatOfCloseness) {
  Scenario scenario = with_zones({0, 0, 0}, {30, 0, 0}, {{.area = box(10, -5, 20, 5), .cost = 3}});
  scenario.obstacles = {box(-30, 1.775, 70, 3)};  // half a metre beside the body
  const CostOptions careful{.clearance_weight = 2, .clearance_distance = 1};
  EXPECT_NEAR(cost_of(make_problem(scenario), {{0, 0, 0}, {{0, 30}}}, careful), 2 * (20 + 10 * 3),
              0.05);
}

TEST(PricesOfZones, OfTheBodyCountWhileAnyPartIsThere) {
  Scenario scenario =
      with_zones({0, 0, 0}, {60, 0, 0}, {{.area = box(30, -5, 32, 5), .cost = 11, .body = true}});
  const Footprint body = footprint(Vehicle{});
  const Path path{{0, 0, 0}, {{0, 60}}};
  EXPECT_NEAR(cost_of(make_problem(scenario), path), 60 + 10 * (2 + body.front + body.rear), 0.02);
  scenario.vehicle = semitrailer();
  EXPECT_GT(cost_of(make_problem(scenario), path), 60 + 10 * (2 + 13));
}

TEST(PricesOfZones, AreJudged) {
  for_each_case(3, 300, [](Rng& rng) {
    std::vector<Zone> zones;
    for (int i = 0; i < 3; ++i) {
      const Point at{uniform(-5, 30, rng), uniform(-10, 10, rng)};
      const double size = uniform(0.5, 10, rng);
      zones.push_back({.area = {{at.x, at.y}, {at.x + size, at.y}, {at.x, at.y + size}},
                       .cost = uniform(1, 20, rng),
                       .body = i == 2});
    }
    Path path{{0, 0, 0}, {}};
    for (int i = 0; i < 3; ++i) {
      path.segments.push_back({uniform(-0.14, 0.14, rng), uniform(-12, 12, rng)});
    }
    const Problem problem = make_problem(with_zones(path.start, end_pose(path), zones));
    const double cost = cost_of(problem, path);
    PathClaims claims{.cost = StatedCost{.cost = cost, .rule = shortest_style}};
    const PathCheck check = check_path(problem, path, claims);
    EXPECT_TRUE(check.valid) << check.reason;
    claims.cost->cost = 1.05 * cost + 0.2;
    EXPECT_FALSE(check_path(problem, path, claims).valid);
  });
}

TEST(PricesOfZones, LeadAround) {
  const Zone mud{.name = "mud", .area = box(10, -8, 30, 3), .cost = 20};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {mud}));
  const PlanResult result = plan(problem, of_iterations(4000));
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.cost, is_sanitized ? 100 : 60);  // in so few iterations
  ASSERT_TRUE(result.lower_bound);
  EXPECT_LE(*result.lower_bound, result.cost);
}

TEST(SpeedsOfZones, HoldFromEdgeToEdge) {
  const Problem problem = make_problem(with_zones({0, 0, 0}, {60, 0, 0},
                                                  {{.area = box(20, -5, 40, 5), .max_speed = 0.5},
                                                   {.area = box(30, -5, 60, 5), .max_speed = 1}}));
  const Path path{{0, 0, 0}, {{0, 60}}};
  const SpeedOptions options = speed_options(problem, path);
  const SpeedProfile speeds = speed_profile(path, problem.vehicle(), options);
  for (const Motion& motion : sampled(path, problem.vehicle(), speeds, 0.01)) {
    const double most = motion.pose.x < 20 ? 100 : motion.pose.x < 40 ? 0.5 : 1;
    EXPECT_LE(motion.v, most + 1e-3) << motion.pose.x;
  }
  EXPECT_GT(speeds.duration, 40 + 20);
  EXPECT_LT(speeds.duration, 40 + 20 + 15);
  EXPECT_TRUE(check_drive(problem, {path, speeds}).valid);
  const DriveCheck fast = check_drive(problem, {path, speed_profile(path, problem.vehicle())});
  EXPECT_EQ(fast.reason.substr(0, 22), "the speed in a zone is");
}

TEST(SpeedsOfZones, CountInTheCostThatIsTheTime) {
  const Zone slow{.area = box(10, -8, 30, 3), .max_speed = 0.2};
  const Problem problem = make_problem(with_zones({0, 0, 0}, {40, 0, 0}, {slow}));
  PlanOptions options = of_iterations(3000);
  options.cost.measure = CostMeasure::time;
  const PlanResult result = plan(problem, options);
  if (is_sanitized && !result.path) return;
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_LT(result.cost, 60);  // straight on it takes 100 s and more
}

// ---- Proofs ----

/// A wall with a gate from y = -9 to y = 9 at x = 16 to 24.
Scenario with_gate(std::vector<Zone> zones) {
  Scenario scenario = with_zones({0, 0, 0}, {40, 0, 0}, std::move(zones));
  scenario.obstacles = {box(16, 9, 24, 40), box(16, -40, 24, -9)};
  return scenario;
}

/// The answer of a search that ends with a proof, or with the first path that is good enough.
PlanResult proof_or_path(const Scenario& scenario, AllowedGears gears = AllowedGears::both) {
  PlanOptions options;
  options.budget.max_iterations = 100'000;
  options.budget.target_gap = 1000;
  options.cost.gears = gears;
  return plan(make_problem(scenario), options);
}

PlanStatus status_of(const Scenario& scenario, AllowedGears gears = AllowedGears::both) {
  return proof_or_path(scenario, gears).status;
}

TEST(ProofsOfZones, NoPathLeadsThroughAClosedGate) {
  const Zone closed{.area = box(19, -9, 21, 9), .closed = true};
  EXPECT_EQ(status_of(with_gate({closed})), PlanStatus::no_path);
  Zone body = closed;
  body.body = true;
  EXPECT_EQ(status_of(with_gate({body})), PlanStatus::no_path);
  const Zone open{.area = box(19, -9, 21, 5), .closed = true};
  EXPECT_NE(status_of(with_gate({open})), PlanStatus::no_path);
}

TEST(ProofsOfZones, NoPathLeadsAgainstAOneWayStreet) {
  const Zone street{.area = box(18, -9, 22, 9), .direction = HeadingRange{pi - 1, pi + 1}};
  const PlanResult against = proof_or_path(with_gate({street}));
  EXPECT_EQ(against.status, PlanStatus::no_path);
  EXPECT_EQ(against.reason,
            "proven: nothing that keeps to the zones gets from the start to the goal");
  Scenario along = with_gate({street});
  std::swap(along.start, along.goal);
  EXPECT_NE(status_of(along), PlanStatus::no_path);
  // In reverse it is no better; a street that may be driven both ways is.
  const Zone both{.area = street.area, .direction = HeadingRange{0, 2 * pi}};
  EXPECT_NE(status_of(with_gate({both})), PlanStatus::no_path);
}

// Backwards through the gate the direction of travel is the same.
TEST(ProofsOfZones, NoPathBacksAgainstAOneWayStreet) {
  const Zone street{.area = box(18, -9, 22, 9), .direction = HeadingRange{pi - 1, pi + 1}};
  for (const AllowedGears gears :
       {AllowedGears::both, AllowedGears::forward, AllowedGears::reverse}) {
    Scenario scenario = with_gate({street});
    if (gears == AllowedGears::reverse) scenario.start.heading = scenario.goal.heading = pi;
    EXPECT_EQ(status_of(scenario, gears), PlanStatus::no_path);
    scenario.zones.front().direction = HeadingRange{-1, 1};
    EXPECT_NE(status_of(scenario, gears), PlanStatus::no_path);
  }
}

// Beside the street there is room for the axle, but not for the body.
TEST(ProofsOfZones, AOneWayStreetIsWiderForTheBody) {
  Zone street{.area = box(18, -7, 22, 7), .direction = HeadingRange{pi - 1, pi + 1}};
  EXPECT_NE(status_of(with_gate({street})), PlanStatus::no_path);
  street.body = true;
  EXPECT_EQ(status_of(with_gate({street})), PlanStatus::no_path);
}

// Between street and wall there are 15 mm for the axle, wherever lines of lattices lie.
TEST(ProofsOfZones, AGapBesideAOneWayStreetIsOpen) {
  const double room = 0.0075;
  const double side = 9 - Vehicle{}.width / 2 - room;
  for (int i = 0; i < 40; ++i) {
    const double up = 0.037 * i;
    Scenario scenario = with_zones({0, side + up, 0}, {40, side + up, 0}, {});
    scenario.obstacles = {box(16, 9 + up, 24, 40)};
    scenario.zones = {
        {.area = box(18, -60, 22, side - room + up), .direction = HeadingRange{pi - 1, pi + 1}}};
    const Problem problem = make_problem(scenario);
    ASSERT_TRUE(check_path(problem, {problem.start(), {{0, 40}}}).valid);
    search::ZoneBound zones(problem.task(), 0);
    while (zones.step()) {
    }
    EXPECT_FALSE(zones.is_proven()) << up;
  }
}

TEST(ProofsOfZones, NoPathLeadsThroughAGateOfTheOtherGear) {
  const Zone gate{.area = box(18, -9, 22, 9), .gears = AllowedGears::reverse};
  EXPECT_EQ(status_of(with_gate({gate}), AllowedGears::forward), PlanStatus::no_path);
  EXPECT_NE(status_of(with_gate({gate})), PlanStatus::no_path);
}

// The judge lets a path end a micrometre off its goal: here on the start's side of a lattice line.
TEST(ProofsOfZones, SpareEndsOnEitherSideOfALine) {
  const double ahead = pi / 2 + 2e-5;
  Scenario scenario{
      .bounds = {-5, 5, -5, 15}, .start = {-1e-7, 0, ahead}, .goal = {4e-7, 0.02, ahead}};
  scenario.zones = {{.area = box(-20, -20, 20, 20), .direction = HeadingRange{ahead, 3.1}}};
  const Problem problem = make_problem(scenario);
  search::ZoneBound zones(problem.task(), 0);
  while (zones.step()) {
  }
  EXPECT_FALSE(zones.is_proven());
}

TEST(ProofsOfZones, HoldForRigs) {
  Scenario scenario = with_gate({{.area = box(19, -9, 21, 9), .closed = true}});
  scenario.vehicle = semitrailer();
  EXPECT_EQ(status_of(scenario), PlanStatus::no_path);
}

}  // namespace
}  // namespace vandplan
