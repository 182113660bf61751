// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for Autoware: the names that our plugins use.

#include <geometry_msgs/msg/pose_array.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <rclcpp/rclcpp.hpp>
#include <vector>

namespace autoware::freespace_planning_algorithms {

struct VehicleShape {
  double length = 0.0;
  double width = 0.0;
  double base_length = 0.0;
  double max_steering = 0.0;
  double base2back = 0.0;
};

struct PlannerCommonParam {
  double time_limit = 0.0;
  int theta_size = 0;
  double curve_weight = 0.0;
  double reverse_weight = 0.0;
  double direction_change_weight = 0.0;
  double lateral_goal_range = 0.0;
  double longitudinal_goal_range = 0.0;
  double angle_goal_range = 0.0;
  double max_turning_ratio = 0.0;
  int turning_steps = 0;
  int obstacle_threshold = 0;
};

struct PlannerWaypoint {
  geometry_msgs::msg::PoseStamped pose;
  bool is_back = false;
};

struct PlannerWaypoints {
  std_msgs::msg::Header header;
  std::vector<PlannerWaypoint> waypoints;
};

class AbstractPlanningAlgorithm {
 public:
  AbstractPlanningAlgorithm(const PlannerCommonParam& planner_common_param,
                            rclcpp::Clock::SharedPtr clock,
                            const VehicleShape& collision_vehicle_shape)
      : planner_common_param_(planner_common_param),
        collision_vehicle_shape_(collision_vehicle_shape),
        clock_(std::move(clock)) {}
  virtual ~AbstractPlanningAlgorithm() = default;

  virtual void setMap(const nav_msgs::msg::OccupancyGrid& costmap) { costmap_ = costmap; }
  virtual bool makePlan(const geometry_msgs::msg::Pose& start_pose,
                        const geometry_msgs::msg::Pose& goal_pose) = 0;
  virtual bool makePlan(const geometry_msgs::msg::Pose& start_pose,
                        const std::vector<geometry_msgs::msg::Pose>& goal_candidates) = 0;
  virtual bool hasObstacleOnTrajectory(const geometry_msgs::msg::PoseArray& trajectory) const = 0;
  [[nodiscard]] const PlannerWaypoints& getWaypoints() const { return waypoints_; }

 protected:
  PlannerCommonParam planner_common_param_;
  VehicleShape collision_vehicle_shape_;
  rclcpp::Clock::SharedPtr clock_;
  nav_msgs::msg::OccupancyGrid costmap_;
  PlannerWaypoints waypoints_;
};

}  // namespace autoware::freespace_planning_algorithms
