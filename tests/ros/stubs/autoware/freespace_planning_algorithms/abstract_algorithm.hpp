// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for Autoware: the names that our plugins use.

#include <geometry_msgs/msg/pose_array.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <rclcpp/rclcpp.hpp>
#include <vector>

#ifdef AUTOWARE_OF_2025
namespace autoware::freespace_planning_algorithms {
struct VehicleShape {
  double length = 0.0;
  double width = 0.0;
  double base_length = 0.0;
  double max_steering = 0.0;
  double base2back = 0.0;
};
using Vehicle = VehicleShape;
}  // namespace autoware::freespace_planning_algorithms
#else
namespace autoware::vehicle_info_utils {
struct VehicleInfo {
  double wheel_base_m = 0.0;
  double rear_overhang_m = 0.0;
  double max_steer_angle_rad = 0.0;
  double vehicle_length_m = 0.0;
  double vehicle_width_m = 0.0;
};
}  // namespace autoware::vehicle_info_utils
namespace autoware::freespace_planning_algorithms {
using Vehicle = vehicle_info_utils::VehicleInfo;
}  // namespace autoware::freespace_planning_algorithms
#endif

namespace autoware::freespace_planning_algorithms {

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
                            const rclcpp::Clock::SharedPtr& clock, const Vehicle& vehicle)
      : planner_common_param_(planner_common_param),
#ifdef AUTOWARE_OF_2025
        collision_vehicle_shape_(vehicle),
#else
        collision_vehicle_info_(vehicle),
#endif
        clock_(clock) {
  }
  virtual ~AbstractPlanningAlgorithm() = default;

  virtual void setMap(const nav_msgs::msg::OccupancyGrid& costmap) { costmap_ = costmap; }
  virtual bool makePlan(const geometry_msgs::msg::Pose& start_pose,
                        const geometry_msgs::msg::Pose& goal_pose) = 0;
  virtual bool makePlan(const geometry_msgs::msg::Pose& start_pose,
                        const std::vector<geometry_msgs::msg::Pose>& goal_candidates) = 0;
  virtual bool hasObstacleOnTrajectory(const geometry_msgs::msg::PoseArray& trajectory) const {
    return trajectory.poses.empty();
  }
  [[nodiscard]] const PlannerWaypoints& getWaypoints() const { return waypoints_; }

 protected:
  PlannerCommonParam planner_common_param_;
#ifdef AUTOWARE_OF_2025
  VehicleShape collision_vehicle_shape_;
#else
  vehicle_info_utils::VehicleInfo collision_vehicle_info_;
#endif
  rclcpp::Clock::SharedPtr clock_;
  nav_msgs::msg::OccupancyGrid costmap_;
  PlannerWaypoints waypoints_;
};

}  // namespace autoware::freespace_planning_algorithms
