// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does the plugin for Autoware tell Autoware what the adapter says? Autoware is a stand-in here.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <vandplan_autoware/freespace_planner.hpp>

namespace vandplan_autoware {
namespace {

geometry_msgs::msg::Pose pose_at(double x, double y, double heading = 0.0) {
  geometry_msgs::msg::Pose pose;
  pose.position.x = x;
  pose.position.y = y;
  pose.orientation.z = std::sin(heading / 2);
  pose.orientation.w = std::cos(heading / 2);
  return pose;
}

/// A yard of 40 x 24 m whose corner is at (-5, -5), with a wall in the middle.
nav_msgs::msg::OccupancyGrid yard() {
  nav_msgs::msg::OccupancyGrid grid;
  grid.header.frame_id = "map";
  grid.info.resolution = 0.25F;
  grid.info.width = 160;
  grid.info.height = 96;
  grid.info.origin = pose_at(-5, -5);
  grid.data.assign(std::size_t{160} * 96, 0);
  for (std::size_t row = 0; row < 50; ++row) grid.data[row * 160 + 80] = 100;
  return grid;
}

const FreespacePlanner::PlannerCommonParam usual{.time_limit = 60000.0,
                                                 .reverse_weight = 2.0,
                                                 .direction_change_weight = 1.5,
                                                 .max_turning_ratio = 1.0,
                                                 .obstacle_threshold = 100};
const FreespacePlanner::VehicleInfo car{.wheel_base_m = 2.8,
                                        .rear_overhang_m = 1.1,
                                        .max_steer_angle_rad = 0.6,
                                        .vehicle_length_m = 4.9,
                                        .vehicle_width_m = 2.0};

std::unique_ptr<FreespacePlanner> planner_in_yard() {
  auto planner =
      std::make_unique<FreespacePlanner>(usual, std::make_shared<rclcpp::Clock>(), car,
                                         vandplan::ros::Parameters::Values{{"target_gap", 0.5}});
  planner->setMap(yard());
  return planner;
}

TEST(AutowarePlugin, WaypointsLeadAroundTheWall) {
  const auto planner = planner_in_yard();
  ASSERT_TRUE(planner->makePlan(pose_at(0, 0), pose_at(25, 0))) << planner->reason();
  EXPECT_EQ(planner->reason(), "");
  const auto& way = planner->getWaypoints();
  EXPECT_EQ(way.header.frame_id, "map");
  EXPECT_EQ(way.header.stamp.sec, 1);
  ASSERT_GT(way.waypoints.size(), 100U);
  EXPECT_EQ(way.waypoints.front().pose.pose.position.x, 0.0);
  EXPECT_EQ(way.waypoints.front().pose.header.frame_id, "map");
  EXPECT_NEAR(way.waypoints.back().pose.pose.position.x, 25, 1e-5);
  EXPECT_NEAR(way.waypoints.back().pose.pose.orientation.w, 1, 1e-6);
}

TEST(AutowarePlugin, IsMadeWithTheArgumentsOfAstarSearch) {
  rclcpp::Node node;
  FreespacePlanner planner(usual, car, node);
  planner.setMap(yard());
  EXPECT_TRUE(planner.makePlan(pose_at(0, 0), pose_at(8, 0))) << planner.reason();
  EXPECT_EQ(planner.getWaypoints().header.stamp.sec, 1);
}

TEST(AutowarePlugin, GoesBackWhereThatIsShort) {
  const auto planner = planner_in_yard();
  ASSERT_TRUE(planner->makePlan(pose_at(8, 0), pose_at(0, 0))) << planner->reason();
  for (const auto& waypoint : planner->getWaypoints().waypoints) EXPECT_TRUE(waypoint.is_back);
}

TEST(AutowarePlugin, AnyOfSeveralGoalsIsReached) {
  const auto planner = planner_in_yard();
  const std::vector goals = {pose_at(15, 0), pose_at(8, 0)};  // the first one is in the wall
  ASSERT_TRUE(planner->makePlan(pose_at(0, 0), goals)) << planner->reason();
  EXPECT_NEAR(planner->getWaypoints().waypoints.back().pose.pose.position.x, 8, 1e-5);
}

TEST(AutowarePlugin, AFailureHasAReasonAndNoWaypoints) {
  const auto planner = planner_in_yard();
  ASSERT_TRUE(planner->makePlan(pose_at(0, 0), pose_at(8, 0)));
  EXPECT_FALSE(planner->makePlan(pose_at(0, 0), pose_at(15, 0)));
  EXPECT_NE(planner->reason(), "");
  EXPECT_TRUE(planner->getWaypoints().waypoints.empty());
  EXPECT_TRUE(planner->trajectory(0.1).points.empty());
  EXPECT_FALSE(planner->makePlan(pose_at(0, 0), std::vector<geometry_msgs::msg::Pose>{}));
}

TEST(AutowarePlugin, PosesAreCheckedAgainstTheLastMap) {
  const auto planner = planner_in_yard();
  geometry_msgs::msg::PoseArray poses;
  poses.poses = {pose_at(0, 0), pose_at(25, 0)};
  EXPECT_FALSE(planner->hasObstacleOnTrajectory(poses));
  nav_msgs::msg::OccupancyGrid grid = yard();
  grid.data[20 * 160 + 120] = -1;  // unknown, below the second pose
  planner->setMap(grid);
  EXPECT_TRUE(planner->hasObstacleOnTrajectory(poses));
  poses.poses = {pose_at(34, 0)};
  EXPECT_TRUE(planner->hasObstacleOnTrajectory(poses)) << "beyond the edge";
}

TEST(AutowarePlugin, ATrajectoryHasTimes) {
  const auto planner = planner_in_yard();
  ASSERT_TRUE(planner->makePlan(pose_at(0, 0), pose_at(25, 0)));
  const auto trajectory = planner->trajectory(0.1);
  EXPECT_EQ(trajectory.header.frame_id, "map");
  ASSERT_GT(trajectory.points.size(), 100U);
  double last = -1.0;
  for (const auto& point : trajectory.points) {
    EXPECT_LT(point.time_from_start.nanosec, 1'000'000'000U);
    const double t = point.time_from_start.sec + 1e-9 * point.time_from_start.nanosec;
    EXPECT_GT(t, last);
    last = t;
  }
  EXPECT_EQ(trajectory.points.front().longitudinal_velocity_mps, 0.0F);
  EXPECT_EQ(trajectory.points.back().longitudinal_velocity_mps, 0.0F);
  EXPECT_NEAR(trajectory.points.back().pose.position.x, 25, 1e-5);
}

}  // namespace
}  // namespace vandplan_autoware
