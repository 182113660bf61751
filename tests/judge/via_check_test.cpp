// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// The judge finds where a path passes its vias, in their order, and the one that it misses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/cases.h"
#include "support/draws.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

/// A problem of driving along a path, past vias.
Problem along(const Path& path, const std::vector<Via>& via, const Vehicle& vehicle = {}) {
  return make_problem({.vehicle = vehicle,
                       .bounds = wide_bounds,
                       .start = path.start,
                       .goal = end_pose(path),
                       .via = via});
}

Via at(const Pose& pose, bool stop = false) { return {{region_of_pose(pose)}, stop}; }

const Path bend{{}, {{0.0, 10.0}, {0.1, 8.0}, {-0.1, -3.0}, {0.0, -5.0}}};

TEST(JudgeOfVias, FindsWhereAPathPassesThem) {
  for_each_case(2601, 200, [](Rng& rng) {
    const double first = uniform(0, length(bend), rng);
    const double second = uniform(first, length(bend), rng);
    const Problem problem = along(bend, {at(pose_at(bend, first)), at(pose_at(bend, second))});
    const PathCheck check = check_path(problem, bend);
    ASSERT_TRUE(check.valid) << check.reason;
    ASSERT_EQ(check.via.size(), 2U);
    EXPECT_NEAR(check.via[0].s, first, 3e-6);
    EXPECT_NEAR(check.via[1].s, second, 3e-6);
  });
}

// In a tenth of a micrometre such a vehicle turns by more than the tolerance.
TEST(JudgeOfVias, FindsWhereATinyVehiclePassesThem) {
  for_each_case(2602, 200, [](Rng& rng) {
    const double radius = any_size(1e-4, 0.2, rng);
    const Vehicle tiny{radius / 3, radius / 3, radius / 3, radius / 3, radius};
    const Path path{{}, {{1 / radius, 4 * radius}, {-1 / radius, -3 * radius}}};
    const double s = uniform(0, length(path), rng);
    const Problem problem = along(path, {at(pose_at(path, s)), at(end_pose(path))}, tiny);
    const PathCheck check = check_path(problem, path);
    ASSERT_TRUE(check.valid) << check.reason;
    EXPECT_NEAR(check.via[0].s, s, 3e-6 * radius);
    EXPECT_NEAR(check.via[1].s, length(path), 3e-6 * radius);
  });
}

TEST(JudgeOfVias, NamesTheOneThatIsMissed) {
  const auto reason = [](const std::vector<Via>& via) {
    return check_path(along(bend, via), bend).reason;
  };
  EXPECT_EQ(reason({at({5, 0.001, 0})}), "the path does not pass via[0]");
  EXPECT_EQ(reason({at({5, 0, 0.001})}), "the path does not pass via[0]");
  EXPECT_EQ(reason({at({5, 0.9e-6, 0})}), "");
  EXPECT_EQ(reason({at({5, 1.2e-6, 0})}), "the path does not pass via[0]");
  EXPECT_EQ(reason({at({5, 0, 0}), at({4, 0, 0})}), "the path does not pass via[1] behind via[0]");
  EXPECT_EQ(reason({at({5, 0, 0}), at({5, 0, 0})}), "");
  EXPECT_EQ(reason({at({}), at(end_pose(bend))}), "");
  EXPECT_EQ(reason({at(compose(end_pose(bend), {-0.99e-6, 0, 0}))}), "");  // ends short of it
  EXPECT_NE(reason({at(compose(end_pose(bend), {-1.01e-6, 0, 0}))}), "");
}

TEST(JudgeOfVias, FindsWhereARegionIsEntered) {
  const Via gate{{{.x = {4, 6}, .y = {-1, 1}, .heading = {-0.1, 0.1}}}};
  const PathCheck check = check_path(along(bend, {gate}), bend);
  ASSERT_TRUE(check.valid) << check.reason;
  EXPECT_NEAR(check.via[0].s, 4, 3e-6);
}

TEST(JudgeOfVias, LetsWheelsTurnWhereTheVehicleStands) {
  const Path kinked{{}, {{0.0, 10.0}, {0.1, 8.0}}};
  const PathClaims claims{.steering = Steering::continuous_between_stops};
  const auto is_valid = [&](const std::vector<Via>& via) {
    return check_path(along(kinked, via), kinked, claims).valid;
  };
  EXPECT_FALSE(is_valid({}));
  EXPECT_TRUE(is_valid({at({10, 0, 0}, true)}));
  EXPECT_FALSE(is_valid({at({10, 0, 0})}));
  EXPECT_FALSE(is_valid({at({9, 0, 0}, true)}));
  // It stands where it has to, anywhere in a region.
  const Via lay_by{{{.x = {4, 12}, .y = {-1, 1}, .heading = {-0.1, 0.1}}}, true};
  EXPECT_TRUE(is_valid({lay_by}));
  EXPECT_FALSE(
      check_path(along(kinked, {at({10, 0, 0}, true)}), kinked, {.steering = Steering::continuous})
          .valid);
}

// The path turns round in the lay-by before, where the vehicle stands in any case.
TEST(JudgeOfVias, LetsWheelsTurnBehindAnotherStopOfTheLayBy) {
  const Path path{{}, {{0.0, 10.0}, {0.0, -2.0}, {0.0, 4.0}, {0.1, 8.0}, {0.0, 4.0}}};
  const Via lay_by{{{.x = {4, 12}, .y = {-1, 1}, .heading = {-0.1, 0.1}}}, true};
  const Via next{{{.x = {12, 25}, .y = {-1, 9}, .heading = {-1.0, 1.0}}}, true};
  const auto is_valid = [&](const std::vector<Via>& via) {
    return check_path(along(path, via), path, {.steering = Steering::continuous_between_stops})
        .valid;
  };
  EXPECT_FALSE(is_valid({lay_by}));  // the wheels turn twice
  EXPECT_TRUE(is_valid({lay_by, next}));
  EXPECT_TRUE(is_valid({lay_by, lay_by, next}));
}

// Rounding makes the segment between both stops a bit shorter than a nanometre.
TEST(JudgeOfVias, TellsStopsApartThatAreNearlyAtOnePlace) {
  const Path path{{}, {{0.0, 10.0}, {0.1, 9.99e-10}, {0.0, 8.0}}};
  const auto is_valid = [&](const std::vector<Via>& via) {
    return check_path(along(path, via), path, {.steering = Steering::continuous_between_stops})
        .valid;
  };
  const Via stop = at({10, 0, 0}, true);
  EXPECT_FALSE(is_valid({stop}));
  EXPECT_TRUE(is_valid({stop, stop}));
}

// The stop of the first via is not kept for the end of the path, where both vias are and the
// vehicle stands anyway: wheels turn at the stop of the second one.
TEST(JudgeOfVias, LetsWheelsTurnAtTheStopOfALaterVia) {
  const Path path{{}, {{0.0, 10.0}, {0.1, 8.0}}};
  const auto around = [](const Pose& pose) {
    return GoalRegion{.x = {pose.x - 1, pose.x + 1}, .y = {pose.y - 1, pose.y + 1}};
  };
  const GoalRegion end = around(end_pose(path));
  const std::vector<Via> via = {{{around({4, 0, 0}), end}, true},
                                {{around({10, 0, 0}), end}, true}};
  const PathCheck check =
      check_path(along(path, via), path, {.steering = Steering::continuous_between_stops});
  ASSERT_TRUE(check.valid) << check.reason;
  EXPECT_NEAR(check.via[0].s, 3, 3e-6);
  EXPECT_NEAR(check.via[1].s, 10, 1e-9);
}

TEST(JudgeOfVias, CountsTheTimeOfAStop) {
  const Path line{{}, {{0.0, 12.0}, {0.0, 18.0}}};
  for (const bool stop : {false, true}) {
    const Problem problem = along(line, {at({12, 0, 0}, stop)});
    const SpeedOptions options = speed_options(problem, line);
    EXPECT_EQ(options.limits.size(), stop ? 1U : 0U);
    const double time = speed_profile(line, problem.vehicle(), options).duration;
    const double without = speed_profile(line, problem.vehicle()).duration;
    EXPECT_EQ(time > without + 1, stop);
    const CostOptions by_time{.measure = CostMeasure::time};
    EXPECT_EQ(check_path(problem, line, {.cost = StatedCost{time, by_time}}).reason, "");
    EXPECT_EQ(check_path(problem, line, {.cost = StatedCost{without, by_time}}).valid, !stop);
  }
}

// The vehicle also stands at the first via when it comes back, but by then it has passed the
// second.
TEST(JudgeOfVias, StopsBeforeTheViasBehind) {
  const Path there_and_back{{}, {{0.0, 10.0}, {0.0, 10.0}, {0.0, -10.0}, {0.0, 5.0}}};
  const auto stop = [&](const std::vector<Via>& via) {
    return speed_options(along(there_and_back, via), there_and_back).limits.at(0).begin;
  };
  EXPECT_EQ(stop({at({10, 0, 0}, true)}), 30.0);
  EXPECT_EQ(stop({at({10, 0, 0}, true), at({20, 0, 0})}), 10.0);
}

TEST(JudgeOfVias, HoldsDrivesToStops) {
  const Path line{{}, {{0.0, 30.0}}};
  const Problem problem = along(line, {at({12, 0, 0}, true)});
  const auto reason = [&](std::vector<SpeedLimit> stops) {
    const SpeedProfile speeds =
        speed_profile(line, problem.vehicle(), {.limits = std::move(stops)});
    return check_drive(problem, {line, speeds}).reason;
  };
  EXPECT_EQ(reason({}), "the vehicle does not stand at via[0]");
  EXPECT_EQ(reason({{11, 11, 0.0}}), "the vehicle does not stand at via[0]");
  EXPECT_EQ(reason({{12, 12, 0.0}}), "");
}

TEST(JudgeOfVias, PrefersPlacesWhereTheVehicleStandsAnyway) {
  const Via yard{{{.x = {5, 12}, .y = {-1, 1}}}, true};
  const Path path{{}, {{0.0, 6.0}, {0.0, 4.0}, {0.0, -3.0}}};
  const Problem problem = along(path, {yard});
  EXPECT_NEAR(check_path(problem, path).via.at(0).s, 10.0, 1e-9);
  EXPECT_EQ(speed_options(problem, path).limits.at(0).begin, 10.0);
  // Not if the next via would be missed.
  const Problem next = along(path, {yard, at({8, 0, 0}), at({9, 0, 0})});
  EXPECT_NEAR(check_path(next, path).via.at(0).s, 6.0, 1e-9);
}

TEST(JudgeOfVias, FollowsTrailers) {
  const Vehicle rig = semitrailer();
  const Path path{{}, {{0.0, 6.0}, {0.05, 8.0}}};
  State state{};
  state = advance(rig, state, path.segments[0]);
  state = advance(rig, state, part_of(path.segments[1], 0, 3));
  const auto check = [&](double hitch_angle) {
    GoalRegion region = region_of_pose(state.pose);
    region.hitch_angle = {hitch_angle, hitch_angle};
    Scenario scenario{.vehicle = rig,
                      .bounds = wide_bounds,
                      .goal_set = {{.x = {-100, 100}, .y = {-100, 100}, .heading = any_heading}},
                      .via = {{{region}, false}}};
    scenario.goal_set[0].hitch_angle = {-rig.max_hitch_angle, rig.max_hitch_angle};
    return check_path(make_problem(scenario), path);
  };
  ASSERT_TRUE(check(state.hitch_angle).valid) << check(state.hitch_angle).reason;
  EXPECT_NEAR(check(state.hitch_angle).via[0].s, 9, 1e-4);
  EXPECT_FALSE(check(state.hitch_angle + 1e-4).valid);
}

// The hitch angle of so short a trailer changes quickly, also on a straight line.
TEST(JudgeOfVias, FollowsTinyTrailers) {
  const Vehicle rig{.wheelbase = 0.036,
                    .front_overhang = 0.014,
                    .rear_overhang = 0.009,
                    .width = 0.025,
                    .min_turning_radius = 0.06,
                    .trailer = Trailer{0.02, 0.001, 0.01, 0.025}};
  const Path path{{}, {{0.0, 0.1}}};
  for_each_case(2603, 20, [&](Rng& rng) {
    const double start_angle = any_sign(uniform(0.2, 0.6, rng), rng);
    const double s = uniform(0, 0.05, rng);
    const double angle = hitch_angle_after(rig, start_angle, {0.0, s});
    Scenario scenario{.vehicle = rig,
                      .bounds = wide_bounds,
                      .goal = end_pose(path),
                      .via = {at(pose_at(path, s))}};
    scenario.hitch_angles = {start_angle, hitch_angle_after(rig, start_angle, path.segments[0])};
    scenario.via[0].any_of[0].hitch_angle = {angle, angle};
    const PathCheck check = check_path(make_problem(scenario), path);
    ASSERT_TRUE(check.valid) << check.reason;
    EXPECT_NEAR(check.via[0].s, s, 3e-6);
  });
}

/// The state after driving a path from `from` to `to`, both from its start.
State driven(const Vehicle& vehicle, State state, const Path& path, double from, double to) {
  double begin = 0.0;
  for (const Segment& segment : path.segments) {
    const double size = std::abs(segment.length);
    const double first = std::clamp(from - begin, 0.0, size);
    const double last = std::clamp(to - begin, 0.0, size);
    if (first < last) state = advance(vehicle, state, part_of(segment, first, last));
    begin += size;
  }
  return state;
}

TEST(JudgeOfVias, FollowsTrailersThroughTurns) {
  Vehicle rig{.wheelbase = 3.6,
              .front_overhang = 1.4,
              .rear_overhang = 0.9,
              .width = 2.5,
              .min_turning_radius = 6,
              .trailer = Trailer{5.0, 0.1, 1.0, 2.5}};
  for_each_case(2604, 60, [&](Rng& rng) {
    rig.hitch = uniform(-0.5, 0.5, rng);
    const double bent = any_sign(uniform(0.05, 0.15, rng), rng);
    const double rate = uniform(0.02, 0.3, rng);
    const double turns = 2 * std::abs(bent) / rate;
    const Path path{{}, {{bent, 2}, {bent, turns, -std::copysign(rate, bent)}, {-bent, 3}}};
    const double s = uniform(0, length(path), rng);
    State state{path.start, uniform(-0.4, 0.4, rng)};
    Scenario scenario{.vehicle = rig, .bounds = wide_bounds, .goal = end_pose(path)};
    scenario.hitch_angles.start = state.hitch_angle;
    state = driven(rig, state, path, 0, s);
    scenario.via = {at(state.pose)};
    scenario.via[0].any_of[0].hitch_angle = {state.hitch_angle, state.hitch_angle};
    scenario.hitch_angles.goal = driven(rig, state, path, s, length(path)).hitch_angle;
    const PathCheck check = check_path(make_problem(scenario), path);
    ASSERT_TRUE(check.valid) << check.reason;
    EXPECT_NEAR(check.via[0].s, s, 3e-6);
  });
}

TEST(JudgeOfVias, HoldsStatedPlacesToThePath) {
  const Problem problem = along(bend, {at({5, 0, 0}), at({8, 0, 0})});
  const auto reason = [&](const std::vector<PassedVia>& stated) {
    return check_path(problem, bend, {.via = stated}).reason;
  };
  EXPECT_EQ(reason({{5, {5, 0, 0}}, {8, {8, 0, 0}}}), "");
  EXPECT_EQ(reason({{5, {5, 0, 0}}}), "1 vias are stated, the scenario has 2");
  EXPECT_EQ(reason({{5, {5, 0, 0}}, {8.1, {8, 0, 0}}}),
            "the stated via[1] is not where the path passes it");
  EXPECT_EQ(reason({{6, {6, 0, 0}}, {8, {8, 0, 0}}}),
            "the stated via[0] is not where the path passes it");
  EXPECT_EQ(reason({{8, {8, 0, 0}}, {5, {5, 0, 0}}}),
            "the stated via[0] is not where the path passes it");
}

}  // namespace
}  // namespace vandplan
