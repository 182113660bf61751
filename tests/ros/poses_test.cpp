// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ros/adapter/outcome.h"
#include "support/cases.h"
#include "support/place_of_error.h"

namespace vandplan::ros {
namespace {

using std::numbers::pi;

TEST(RosOutcome, EveryStatusHasOne) {
  EXPECT_EQ(outcome_of(PlanStatus::solved), Outcome::solved);
  EXPECT_EQ(outcome_of(PlanStatus::start_in_collision), Outcome::start_occupied);
  EXPECT_EQ(outcome_of(PlanStatus::goal_in_collision), Outcome::goal_occupied);
  EXPECT_EQ(outcome_of(PlanStatus::iteration_limit), Outcome::timed_out);
  EXPECT_EQ(outcome_of(PlanStatus::node_limit), Outcome::timed_out);
  EXPECT_EQ(outcome_of(PlanStatus::time_limit), Outcome::timed_out);
  EXPECT_EQ(outcome_of(PlanStatus::stopped), Outcome::cancelled);
  EXPECT_EQ(outcome_of(PlanStatus::no_path), Outcome::no_path);
  EXPECT_EQ(outcome_of(PlanStatus::rejected), Outcome::no_path);
  EXPECT_EQ(name_of(Outcome::solved), "solved");
  EXPECT_EQ(name_of(Outcome::start_outside_map), "start_outside_map");
  EXPECT_EQ(name_of(Outcome::goal_outside_map), "goal_outside_map");
  EXPECT_EQ(name_of(Outcome::start_occupied), "start_occupied");
  EXPECT_EQ(name_of(Outcome::goal_occupied), "goal_occupied");
  EXPECT_EQ(name_of(Outcome::no_path), "no_path");
  EXPECT_EQ(name_of(Outcome::timed_out), "timed_out");
  EXPECT_EQ(name_of(Outcome::cancelled), "cancelled");
  EXPECT_EQ(name_of(Outcome::invalid), "invalid");
}

TEST(RosPoses, HeadingsBecomeQuaternionsAndBack) {
  for (const double heading : {-pi, -2.0, -0.1, 0.0, 1.0, pi - 1e-9}) {
    const auto [z, w] = quaternion_of(heading);
    EXPECT_NEAR(std::cos(heading_of(0, 0, z, w)), std::cos(heading), 1e-12);
    EXPECT_NEAR(std::sin(heading_of(0, 0, z, w)), std::sin(heading), 1e-12);
    EXPECT_NEAR(heading_of(0, 0, -z, -w) - heading_of(0, 0, z, w), 0, 1e-12) << "one rotation";
  }
  EXPECT_NEAR(heading_of(0, std::sin(0.25), 0, std::cos(0.25)), 0, 1e-12) << "a pitch is no yaw";
}

/// Ahead, back to the right, and ahead again.
const Path three_strokes{{1, 2, 0}, {{0, 1}, {-0.5, -1}, {0.5, 0.75}}};

TEST(RosPoses, CuspsAreWhereTheGearChanges) {
  const auto poses = poses_of(three_strokes, 0.25, 0.0);
  ASSERT_EQ(poses.size(), 12U);
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_EQ(poses[i].is_cusp, i == 4 || i == 8) << i;
  EXPECT_EQ(poses[0].pose, (Pose{1, 2, 0}));
  EXPECT_EQ(poses[4].gear, Gear::reverse) << "the gear in which it goes on";
  EXPECT_EQ(poses[8].gear, Gear::forward);
  EXPECT_EQ(poses[11].gear, Gear::forward);
  EXPECT_EQ(poses[4].curvature, -0.5);
  EXPECT_NEAR(poses[11].pose.x, end_pose(three_strokes).x, 1e-12);
  EXPECT_NEAR(poses[6].pose.heading, 0.25, 1e-12) << "the front, not the way it goes";
}

/// The index behind a cusp that Nav2's controllers find: where two steps point to opposite sides.
std::vector<std::size_t> inversions(const std::vector<PathPose>& poses) {
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i + 1 < poses.size(); ++i) {
    const Pose& a = poses[i - 1].pose;
    const Pose& b = poses[i].pose;
    const Pose& c = poses[i + 1].pose;
    if ((b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0.0) found.push_back(i);
  }
  return found;
}

TEST(RosPoses, Nav2FindsTheCuspsOfAnyPath) {
  for_each_case(3, 3000, [](Rng& rng) {
    Path path{{uniform(-5, 5, rng), uniform(-5, 5, rng), uniform(-3, 3, rng)}, {}};
    const auto count = static_cast<int>(uniform(1, 8, rng));
    for (int i = 0; i < count; ++i) {
      // A stroke of at least 0.3 m in one gear, with a crumb in it at times.
      const double sign = uniform01(rng) < 0.5 ? 1 : -1;
      path.segments.push_back({uniform(-1, 1, rng), sign * uniform(0.3, 2, rng)});
      if (uniform01(rng) < 0.5) {
        path.segments.push_back({uniform(-1, 1, rng), sign * uniform(1e-9, 3e-4, rng)});
      }
    }
    const double step = uniform(0.02, 0.2, rng);
    const auto poses = poses_of(path, step, 0.0);
    std::vector<std::size_t> cusps;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      if (poses[i].is_cusp) cusps.push_back(i);
      if (i == 0) continue;
      const double distance =
          std::hypot(poses[i].pose.x - poses[i - 1].pose.x, poses[i].pose.y - poses[i - 1].pose.y);
      ASSERT_LE(distance, step + 1e-3);
      ASSERT_GT(distance, 1e-4) << "Nav2 would see a turn on the spot";
    }
    ASSERT_EQ(static_cast<int>(cusps.size()), gear_changes(path));
    ASSERT_EQ(cusps, inversions(poses));
  });
}

TEST(RosPoses, APathWithoutAMetreIsOnePose) {
  EXPECT_EQ(poses_of({{1, 2, 3}, {}}, 0.5, 0.0).size(), 1U);
}

TEST(RosPoses, PosesAreThoseOfBaseLink) {
  const Path turn{{0, 0, 0}, {{0.5, pi}}};  // a quarter turn of 2 m
  const auto poses = poses_of(turn, 10, -0.5);
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_NEAR(poses[0].pose.x, 0.5, 1e-12);
  EXPECT_NEAR(poses[0].pose.y, 0.0, 1e-12);
  EXPECT_NEAR(poses[1].pose.x, 2.0, 1e-12);
  EXPECT_NEAR(poses[1].pose.y, 2.5, 1e-12);
}

TEST(RosPoses, AFineStepOnALongPathIsNotRefused) {
  const Path path{{0, 0, 0}, {{0, 1000}}};
  EXPECT_NEAR(static_cast<double>(poses_of(path, 1e-6, 0.0).size()), 1e6, 2);
}

TEST(RosPoses, ATrajectoryHasTimesAndSpeeds) {
  const Vehicle vehicle{.limits = {.max_steering_rate = 1}};
  const auto points = trajectory_of(three_strokes, vehicle, 0.0, 0.1);
  ASSERT_GT(points.size(), 10U);
  EXPECT_EQ(points.front().time_from_start, 0.0);
  EXPECT_EQ(points.front().longitudinal_velocity_mps, 0.0);
  EXPECT_EQ(points.back().longitudinal_velocity_mps, 0.0);
  double slowest = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_GT(points[i].time_from_start, points[i - 1].time_from_start);
    const double v = points[i].longitudinal_velocity_mps;
    slowest = std::min(slowest, v);
    if (v >= 0.0) continue;
    EXPECT_NEAR(points[i].heading_rate_rps, -0.5 * v, 1e-9);
    EXPECT_NEAR(points[i].front_wheel_angle_rad, std::atan(4.5 * -0.5), 1e-9);
  }
  EXPECT_LT(slowest, -0.5);
  EXPECT_EQ(place_of_error([&] { (void)trajectory_of(three_strokes, vehicle, 0, 0); }), "step");
}

}  // namespace
}  // namespace vandplan::ros
