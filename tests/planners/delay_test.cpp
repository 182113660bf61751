// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How long drives wait for what moves, as searches see it.
#include "planners/delay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "planners/default_search.h"
#include "planners/drive_time.h"
#include "planners/last_stretch.h"
#include "planners/pricing.h"
#include "planners/refuges.h"
#include "support/cases.h"
#include "support/problems.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

using planning::Delay;
using std::numbers::pi;

/// Comes from the right and crosses x = 15 within `seconds`.
MovingObstacle crossing_in(double seconds) {
  return {.outline = box(-2, -1, 2, 1),
          .trajectory = {{0, {15, -12, pi / 2}}, {seconds, {15, 28, pi / 2}}}};
}

Problem road_among(const std::vector<MovingObstacle>& moving, const Vehicle& vehicle = {}) {
  const Problem alone = problem_in({.bounds = {-90, 90, -90, 90}}, {0, 0, 0}, {40, 0, 0}, vehicle);
  return with_moving(alone, moving);
}

double delay_of(const Problem& problem, const Path& path) {
  const Task& task = problem.task();
  return Delay(task).of(path, planning::fastest_drive(task, path));
}

const Path ahead{{0, 0, 0}, {{0, 40}}};

TEST(Delay, GrowsWithTheTimeOfTheMeeting) {
  EXPECT_EQ(delay_of(road_among({crossing_in(5)}), ahead), 0);  // it is past
  const double of_fast = delay_of(road_among({crossing_in(16)}), ahead);
  const double of_slow = delay_of(road_among({crossing_in(24)}), ahead);
  EXPECT_GT(of_fast, 1);
  EXPECT_GT(of_slow, of_fast + 1);
}

TEST(Delay, WhoHasLeftIsNotMet) {
  MovingObstacle parks = crossing_in(16);
  parks.trajectory.back() = {3, {15, 0, pi / 2}};
  EXPECT_GT(delay_of(road_among({parks}), ahead), 0);
  parks.after = Afterwards::leaves;
  EXPECT_EQ(delay_of(road_among({parks}), ahead), 0);
}

TEST(Delay, OfAPathIsAPartOfItsPrice) {
  const Problem problem = road_among({crossing_in(16)});
  const Problem alone = road_among({});
  const double delay = delay_of(problem, ahead);
  const auto sampling = search::ClearanceSampling::search;
  for (const CostMeasure measure : {CostMeasure::prices, CostMeasure::time}) {
    CostOptions cost;
    cost.measure = measure;
    const planning::Pricing among(problem.task(), cost, 2.0);
    const planning::Pricing without(alone.task(), cost, 2.0);
    const double each = measure == CostMeasure::time ? 1.0 : 2.0;
    EXPECT_DOUBLE_EQ(among.cost(ahead.segments, sampling),
                     without.cost(ahead.segments, sampling) + each * delay);
    EXPECT_EQ(among.path_cost(ahead.segments, sampling),
              without.path_cost(ahead.segments, sampling));
  }
}

/// A drive of a few arcs, lines and clothoids in both gears.
std::vector<Segment> any_drive(const Vehicle& vehicle, Rng& rng) {
  std::vector<Segment> drive;
  for (int i = 0; i < 5; ++i) {
    const double lock = uniform(-1, 1, rng) / vehicle.min_turning_radius;
    const double length = uniform(2, 12, rng) * (rng() % 4 == 0 && !vehicle.trailer ? -1 : 1);
    const double rate = rng() % 2 == 0 ? 0.0 : -lock / std::abs(length);
    drive.push_back({lock, length, rate});
  }
  return drive;
}

/// Looks at which the drive is too near to somebody, by the motion of the drive.
int meetings(const Task& task, const Path& path) {
  const SpeedProfile drive = planning::fastest_drive(task, path);
  const moving::Encounters movers({path, task.vehicle, task.hitch_angles.start}, task.moving, 0.0);
  int sum = 0;
  for (int look = 0; look * 0.3 < drive.duration; ++look) {
    const double t = look * 0.3;
    const State state = movers.state_at(motion_at(path, task.vehicle, drive, t).s);
    bool is_near = false;
    for (std::size_t i = 0; i < movers.size(); ++i) {
      is_near = is_near || movers.gap(i, state, t, 1.0) <= 0.0;
    }
    sum += is_near ? 1 : 0;
  }
  return sum;
}

TEST(DelayLaw, TellsHowManyLooksFindSomebodyNear) {
  Rng rng(7);
  Vehicle rig;
  rig.trailer = Trailer{};
  std::map<int, double> delays;  // by the number of looks
  for (int i = 0; i < cases(400); ++i) {
    const Vehicle vehicle = rng() % 2 == 0 ? rig : Vehicle{};
    const double x = uniform(-30, 30, rng), y = uniform(-30, 30, rng);
    MovingObstacle mover = crossing_in(uniform(10, 60, rng));
    mover.trajectory.front().pose = {x, y, 0};
    mover.trajectory.back().pose = {-x, -y, 2};
    const Problem problem = road_among({mover}, vehicle);
    const Path path{{0, 0, 0}, any_drive(vehicle, rng)};
    const int looks = meetings(problem.task(), path);
    const double delay = delay_of(problem, path);
    EXPECT_EQ(looks == 0, delay == 0.0);
    EXPECT_NEAR(delays.try_emplace(looks, delay).first->second, delay, 1e-9) << looks;
  }
  EXPECT_GT(delays.size(), is_sanitized ? 1U : 10U);
  double less = -1.0;
  for (const auto& [looks, delay] : delays) {
    EXPECT_GT(delay, less + 0.3) << looks;
    less = delay;
  }
}

// When a later leg begins is not known before the vehicle is there.
TEST(Delay, OnlyTheFirstLegIsPricedAmongWhatMoves) {
  Scenario scenario{.bounds = {-60, 100, -60, 60}, .goal = {40, 0, 0}};
  scenario.via = {{{region_of_pose({20, 0, 0})}, false}};
  scenario.moving = {crossing_in(16)};
  const Problem problem = make_problem(scenario);
  int first = 0, later = 0;
  const auto search_to = [&](const Task& leg, const PlanOptions& options, const Path* known) {
    const bool is_first = leg.start == problem.task().start;
    EXPECT_EQ(leg.moving.size(), is_first ? 1U : 0U);
    ++(is_first ? first : later);
    return planning::default_search(leg, options, 2.0, {.known = known});
  };
  const PlanOptions options = complete(default_planner());
  const auto search =
      planning::search_with_line(problem.task(), options, 2.0, nullptr, {}, search_to);
  for (int round = 0; round < 20; ++round) (void)search->advance(200);
  EXPECT_GT(first, 0);
  EXPECT_GT(later, 0);
}

TEST(Delay, TheWayOnFromARefugeIsPricedAsIfNothingMoved) {
  const Problem problem = road_among({crossing_in(16)});
  const in_time::Detour detour{.refuge = Local(Pose{20, 5, 0})};
  std::vector<std::size_t> movers;
  const auto make = [&](const Task& leg, const Path&) {
    movers.push_back(leg.moving.size());
    return planning::default_search(leg, complete(default_planner()), 2.0, {});
  };
  const auto search = in_time::search_through(problem.task(), detour, make);
  for (int round = 0; round < 60 && movers.size() < 2; ++round) (void)search->advance(200);
  EXPECT_EQ(movers, (std::vector<std::size_t>{1, 0}));
}

}  // namespace
}  // namespace vandplan
