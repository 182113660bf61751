// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <vandplan_autoware/freespace_planner.hpp>

#include <cmath>
#include <cstdint>

#include "vandplan/input_error.h"

namespace vandplan_autoware {
namespace {

vandplan::Pose pose_of(const geometry_msgs::msg::Pose& pose) {
  const auto& [x, y, z, w] = pose.orientation;
  return {pose.position.x, pose.position.y, vandplan::ros::heading_of(x, y, z, w)};
}

geometry_msgs::msg::Pose message_of(const vandplan::Pose& pose) {
  geometry_msgs::msg::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  const auto [z, w] = vandplan::ros::quaternion_of(pose.heading);
  message.orientation.z = z;
  message.orientation.w = w;
  return message;
}

vandplan::ros::FreespaceParameters parameters_of(const FreespacePlanner::PlannerCommonParam& from) {
  return {.time_limit = from.time_limit,
          .reverse_weight = from.reverse_weight,
          .direction_change_weight = from.direction_change_weight,
          .lateral_goal_range = from.lateral_goal_range,
          .longitudinal_goal_range = from.longitudinal_goal_range,
          .angle_goal_range = from.angle_goal_range,
          .max_turning_ratio = from.max_turning_ratio,
          .obstacle_threshold = from.obstacle_threshold};
}

/// Costs of an OccupancyGrid as bytes: -1, unknown, becomes 255.
vandplan::ros::Costmap costmap_of(const nav_msgs::msg::OccupancyGrid& grid) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(grid.data.data());
  return {.costs = {bytes, grid.data.size()},
          .columns = static_cast<std::int32_t>(grid.info.width),
          .rows = static_cast<std::int32_t>(grid.info.height),
          .resolution = static_cast<double>(grid.info.resolution),
          .origin = pose_of(grid.info.origin)};
}

}  // namespace

FreespacePlanner::FreespacePlanner(const PlannerCommonParam& planner_common_param,
                                   const rclcpp::Clock::SharedPtr& clock,
                                   const VehicleInfo& collision_vehicle,
                                   const vandplan::ros::Parameters::Values& own)
    : AbstractPlanningAlgorithm(planner_common_param, clock, collision_vehicle),
      request_(request_of(parameters_of(planner_common_param),
                          vandplan::ros::freespace_vehicle(collision_vehicle), own)) {}

FreespacePlanner::FreespacePlanner(const PlannerCommonParam& planner_common_param,
                                   const VehicleInfo& collision_vehicle, rclcpp::Node& node,
                                   const vandplan::ros::Parameters::Values& own)
    : FreespacePlanner(planner_common_param, node.get_clock(), collision_vehicle, own) {}

FreespacePlanner::~FreespacePlanner() = default;

void FreespacePlanner::setMap(const nav_msgs::msg::OccupancyGrid& costmap) {
  AbstractPlanningAlgorithm::setMap(costmap);
  planner_.take(costmap_of(costmap));
}

bool FreespacePlanner::makePlan(const geometry_msgs::msg::Pose& start_pose,
                                const geometry_msgs::msg::Pose& goal_pose) {
  return makePlan(start_pose, std::vector{goal_pose});
}

bool FreespacePlanner::makePlan(const geometry_msgs::msg::Pose& start_pose,
                                const std::vector<geometry_msgs::msg::Pose>& goal_candidates) {
  vandplan::ros::Request request = request_;
  request.start = pose_of(start_pose);
  for (const geometry_msgs::msg::Pose& goal : goal_candidates) {
    request.goals.push_back(pose_of(goal));
  }
  answer_ = planner_.plan(request);
  waypoints_.waypoints.clear();
  waypoints_.header.frame_id = costmap_.header.frame_id;
  waypoints_.header.stamp = clock_->now();
  for (const auto& [pose, is_back] : vandplan::ros::waypoints_of(answer_.poses)) {
    auto& waypoint = waypoints_.waypoints.emplace_back();
    waypoint.pose.header = waypoints_.header;
    waypoint.pose.pose = message_of(pose);
    waypoint.is_back = is_back;
  }
  return answer_.outcome == vandplan::ros::Outcome::solved;
}

bool FreespacePlanner::hasObstacleOnTrajectory(
    const geometry_msgs::msg::PoseArray& trajectory) const {
  std::vector<vandplan::Pose> poses;
  for (const geometry_msgs::msg::Pose& pose : trajectory.poses) poses.push_back(pose_of(pose));
  return planner_.is_blocked(poses, request_.vehicle, request_.cost_rule);
}

autoware_planning_msgs::msg::Trajectory FreespacePlanner::trajectory(double period) const {
  autoware_planning_msgs::msg::Trajectory message;
  message.header = waypoints_.header;
  if (!answer_.path) return message;
  const double wheels = answer_.poses.front().curvature;
  for (const vandplan::ros::TrajectoryPoint& at :
       vandplan::ros::trajectory_of(*answer_.path, request_.vehicle, wheels, period)) {
    auto& point = message.points.emplace_back();
    const double whole = std::floor(at.time_from_start);
    point.time_from_start.sec = static_cast<std::int32_t>(whole);
    point.time_from_start.nanosec = static_cast<std::uint32_t>((at.time_from_start - whole) * 1e9);
    point.pose = message_of(at.pose);
    point.longitudinal_velocity_mps = static_cast<float>(at.longitudinal_velocity_mps);
    point.acceleration_mps2 = static_cast<float>(at.acceleration_mps2);
    point.heading_rate_rps = static_cast<float>(at.heading_rate_rps);
    point.front_wheel_angle_rad = static_cast<float>(at.front_wheel_angle_rad);
  }
  return message;
}

}  // namespace vandplan_autoware
