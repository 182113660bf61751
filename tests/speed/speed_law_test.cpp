// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Do drives along random paths keep every limit, and is none faster?

#include <gtest/gtest.h>

#include "judge/drive_time.h"
#include "judge/track.h"
#include "support/cases.h"
#include "support/draws.h"
#include "support/drive_oracle.h"
#include "support/jerk_oracle.h"
#include "support/problems.h"
#include "vandplan/judge.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

/// A truck or something else, with limits of which any may be the one that holds it back.
Vehicle any_driver(Rng& rng) {
  Vehicle vehicle;
  vehicle.wheelbase = any_size(0.5, 8, rng);
  DrivingLimits& limits = vehicle.limits;
  limits.max_steering_rate = any_size(0.05, 3, rng);
  limits.max_speed = {any_size(0.3, 30, rng), any_size(0.3, 10, rng)};
  limits.max_acceleration = any_size(0.1, 5, rng);
  if (chance(0.5, rng)) limits.max_braking = any_size(0.1, 8, rng);
  limits.max_lateral_acceleration = any_size(0.1, 8, rng);
  return vehicle;
}

/// Shortest paths of a few turns and lines: the curvature jumps.
Path any_shortest_path(Rng& rng) {
  const Pose goal = uniform_pose({-30, 30, -30, 30}, rng);
  const Piece piece = reeds_shepp({0, 0, 0}, goal, uniform(3, 12, rng));
  return {{0, 0, 0}, {piece.view().begin(), piece.view().end()}};
}

/// Clothoids, arcs and lines without jumps, but for some gear changes and a few jumps.
Path any_chain(Rng& rng) {
  Path path;
  double curvature = chance(0.5, rng) ? 0 : uniform(-0.2, 0.2, rng);
  double gear = any_sign(1, rng);
  const int count = 1 + static_cast<int>(uniform(0, 9, rng));
  for (int i = 0; i < count; ++i) {
    Segment segment{curvature, any_size(0.02, 15, rng)};
    if (chance(0.7, rng)) {
      segment.curvature_rate = (uniform(-0.3, 0.3, rng) - curvature) / segment.length;
    }
    curvature = curvature_at(segment, segment.length);
    if (chance(0.1, rng)) curvature = uniform(-0.2, 0.2, rng);
    if (chance(0.2, rng)) gear = -gear;
    segment.length *= gear;
    path.segments.push_back(segment);
  }
  return path;
}

Path any_path(Rng& rng) { return chance(0.3, rng) ? any_shortest_path(rng) : any_chain(rng); }

TEST(SpeedLaw, KeepsEveryLimitAtEveryMillimetre) {
  for_each_case(1, 1000, [](Rng& rng) {
    const Path path = any_path(rng);
    const Vehicle vehicle = any_driver(rng);
    const SpeedProfile profile = speed_profile(path, vehicle);
    EXPECT_EQ(fault_of(path, vehicle, profile), "") << as_code(path);
  });
}

TEST(SpeedLaw, NoDriveIsFasterByAThousandth) {
  double worst = 0;
  for_each_case(2, 1000, [&](Rng& rng) {
    const Path path = any_path(rng);
    const Vehicle vehicle = any_driver(rng);
    const double duration = speed_profile(path, vehicle).duration;
    const double dense = dense_duration(path, vehicle);
    worst = std::max(worst, duration / dense - 1);
    EXPECT_LE(duration, dense * (1 + 1e-3)) << as_code(path);
    EXPECT_GE(duration, dense * (1 - 1e-4)) << as_code(path);
  });
  EXPECT_LE(worst, 2e-4);
}

TEST(SpeedLaw, KeepsTheLimitOfJerk) {
  double worst = 0;
  double sum = 0;
  for_each_case(3, 500, [&](Rng& rng) {
    const Path path = any_path(rng);
    Vehicle vehicle = any_driver(rng);
    const double unlimited = speed_profile(path, vehicle).duration;
    vehicle.limits.max_jerk = any_size(0.2, 20, rng);
    const SpeedProfile profile = speed_profile(path, vehicle);
    EXPECT_EQ(fault_of(path, vehicle, profile), "") << as_code(path);
    EXPECT_GE(profile.duration, unlimited * (1 - 1e-3)) << as_code(path);
    vehicle.limits.max_jerk = 1000;
    const double nearly = speed_profile(path, vehicle).duration / unlimited - 1;
    worst = std::max(worst, nearly);
    sum += nearly;
  });
  EXPECT_LE(worst, 0.03);
  if (!is_sanitized) {
    EXPECT_LE(sum, 0.003 * 500);
  }
}

/// Puts in strokes that nobody drives, alone or some together, between segments or at the ends.
void put_in_hairs(Path& path, Rng& rng) {
  for (int strokes = chance(0.5, rng) ? 1 + static_cast<int>(rng() % 3) : 0; strokes > 0;
       --strokes) {
    const auto at = static_cast<std::ptrdiff_t>(rng() % (path.segments.size() + 1));
    path.segments.insert(path.segments.begin() + at,
                         {uniform(-0.1, 0.1, rng), any_sign(any_size(1e-17, 1e-10, rng), rng)});
  }
}

TEST(SpeedLaw, TheJudgeOfPathsKnowsTheSameTime) {
  for_each_case(10, 300, [](Rng& rng) {
    Path path = any_path(rng);
    put_in_hairs(path, rng);
    const Vehicle vehicle = any_driver(rng);
    const double time = judge::drive_time(judge::integrate(path), vehicle, 0);
    const double found = speed_profile(path, vehicle, {.start_curvature = 0}).duration;
    EXPECT_NEAR(found, time, 1e-3 * time + 1e-6) << as_code(path);
  });
}

TEST(SpeedLaw, TheJudgeOfDrivesAcceptsIt) {
  for_each_case(9, 500, [](Rng& rng) {
    Path path = any_path(rng);
    put_in_hairs(path, rng);
    Vehicle vehicle = any_driver(rng);
    if (chance(0.3, rng)) vehicle.limits.max_acceleration = any_size(0.01, 0.1, rng);
    if (chance(0.7, rng)) vehicle.limits.max_jerk = any_size(0.05, 50, rng);
    const Problem problem = problem_of_path({.bounds = wide_bounds}, path, vehicle);
    const DriveCheck check = check_drive(problem, {path, speed_profile(path, vehicle)});
    EXPECT_TRUE(check.valid) << check.reason << " " << as_code(path);
  });
}

// From rest to rest along a line the fastest drive has seven phases.
TEST(SpeedLaw, OnALineNoDriveWithoutJerksIsFaster) {
  for_each_case(8, 100, [](Rng& rng) {
    Path path;
    path.segments = {{0, any_sign(any_size(0.1, 100, rng), rng)}};
    Vehicle vehicle = any_driver(rng);
    vehicle.limits.max_jerk = any_size(0.2, 20, rng);
    const double found = speed_profile(path, vehicle).duration;
    const double least = dense_jerk_duration(path, vehicle, 400);
    EXPECT_LE(found, least * (1 + 1e-3)) << as_code(path);
    EXPECT_GE(found, least * (1 - 1e-3)) << as_code(path);
  });
}

TEST(SpeedLaw, DrivesWithoutJerksAreNearTheFastest) {
  double sum = 0;
  constexpr int count = 100;
  for_each_case(9, count, [&](Rng& rng) {
    const Path path = any_chain(rng);
    Vehicle vehicle = any_driver(rng);
    vehicle.limits.max_jerk = any_size(0.2, 20, rng);
    const double found = speed_profile(path, vehicle).duration;
    const double least = dense_jerk_duration(path, vehicle, 300);
    EXPECT_LE(found, least * 1.25) << as_code(path);
    EXPECT_GE(found, least * 0.985) << as_code(path);
    sum += found / least - 1;
  });
  if (!is_sanitized) {
    EXPECT_LE(sum, 0.016 * count);
  }
}

// Tiny segments far from the start, models and trucks, limits of any size.
TEST(SpeedLaw, EveryDriveEnds) {
  for_each_case(7, 3000, [](Rng& rng) {
    Vehicle vehicle;
    vehicle.wheelbase = any_size(0.05, 20, rng);
    const auto limit = [&] { return any_size(1e-3, 1e3, rng); };
    vehicle.limits = {.max_steering_rate = limit(),
                      .max_speed = {limit(), limit()},
                      .max_acceleration = limit(),
                      .max_braking = limit(),
                      .max_lateral_acceleration = limit()};
    if (chance(0.5, rng)) vehicle.limits.max_jerk = limit();
    Path path;
    for (int i = 0; i < 6; ++i) {
      Segment segment{any_sign(any_size(1e-9, 10, rng), rng), any_size(1e-12, 1e4, rng)};
      if (chance(0.3, rng)) segment.curvature = 0;
      const double change = any_sign(any_size(1e-12, 10, rng), rng);
      if (chance(0.7, rng)) segment.curvature_rate = change / segment.length;
      segment.length = any_sign(segment.length, rng);
      path.segments.push_back(segment);
    }
    const SpeedProfile profile = speed_profile(path, vehicle);
    EXPECT_TRUE(std::isfinite(profile.duration)) << as_code(path);
    for (std::size_t i = 1; i < profile.knots.size(); ++i) {
      EXPECT_GE(profile.knots[i].t, profile.knots[i - 1].t) << as_code(path);
    }
  });
}

TEST(SpeedLaw, IsTheSameOnTheMirroredPath) {
  for_each_case(4, 200, [](Rng& rng) {
    const Path path = any_path(rng);
    const Vehicle vehicle = any_driver(rng);
    Path mirrored = path;
    for (Segment& segment : mirrored.segments) {
      segment.curvature = -segment.curvature;
      segment.curvature_rate = -segment.curvature_rate;
    }
    EXPECT_EQ(speed_profile(path, vehicle).duration, speed_profile(mirrored, vehicle).duration);
  });
}

TEST(SpeedLaw, NothingGetsSlowerWhenALimitIsRaised) {
  for_each_case(5, 200, [](Rng& rng) {
    const Path path = any_path(rng);
    const Vehicle vehicle = any_driver(rng);
    const double before = speed_profile(path, vehicle).duration;
    Vehicle raised = vehicle;
    double* const limits[] = {&raised.limits.max_steering_rate, &raised.limits.max_speed.forward,
                              &raised.limits.max_speed.reverse, &raised.limits.max_acceleration,
                              &raised.limits.max_lateral_acceleration};
    for (double* const limit : limits) *limit *= uniform(1, 2, rng);
    if (vehicle.limits.max_braking) *raised.limits.max_braking *= 1.5;
    EXPECT_LE(speed_profile(path, raised).duration, before * (1 + 1e-3)) << as_code(path);
  });
}

TEST(SpeedLaw, MotionsAreOnThePathAndFollowFromEachOther) {
  for_each_case(6, 100, [](Rng& rng) {
    Path path = any_path(rng);
    path.start = {uniform(-1e9, 1e9, rng), uniform(-100, 100, rng), uniform(-3, 3, rng)};
    Vehicle vehicle = any_driver(rng);
    if (chance(0.3, rng)) vehicle.limits.max_jerk = any_size(0.2, 20, rng);
    const SpeedProfile profile = speed_profile(path, vehicle);
    const std::vector<Motion> motions = sampled(path, vehicle, profile, 0.05);
    EXPECT_EQ(motions.front().t, 0);
    EXPECT_EQ(motions.back().t, profile.duration);
    EXPECT_EQ(motions.back().v, 0);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const Motion& motion = motions[i];
      const Pose pose = pose_at(path, motion.s);
      EXPECT_NEAR(motion.pose.x, pose.x, 1e-6);
      EXPECT_NEAR(motion.pose.y, pose.y, 1e-9);
      EXPECT_NEAR(std::remainder(motion.pose.heading - pose.heading, 6.283185307179586), 0, 1e-9);
      EXPECT_NEAR(std::tan(motion.steering_angle), vehicle.wheelbase * motion.curvature, 1e-9);
      if (i == 0) continue;
      const Motion& last = motions[i - 1];
      const double passed = motion.t - last.t;
      EXPECT_GT(passed, 0);
      EXPECT_LE(passed, 0.0501);
      EXPECT_LE(std::abs(motion.steering_angle - last.steering_angle),
                passed * vehicle.limits.max_steering_rate * (1 + 1e-9) + 2 * ignored_steering_jump);
    }
  });
}

}  // namespace
}  // namespace vandplan
