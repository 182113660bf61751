// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Autoware's freespace planning plan with Vändplan?
//
// Everything but the messages is in ros/adapter.

#include <autoware/freespace_planning_algorithms/abstract_algorithm.hpp>
#include <autoware_planning_msgs/msg/trajectory.hpp>
#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/pose_array.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <rclcpp/rclcpp.hpp>
#include <string>
#include <vector>

#include "ros/adapter/freespace.h"

namespace vandplan_autoware {

/// Finds out how this Autoware describes a vehicle: by `VehicleInfo` since 2026, before by
/// `VehicleShape`.
struct VehicleOfAutoware : autoware::freespace_planning_algorithms::AbstractPlanningAlgorithm {
  template <typename Self>
  static auto of(const Self* self) -> decltype(self->collision_vehicle_info_);
  template <typename Self>
  static auto of(const Self* self) -> decltype(self->collision_vehicle_shape_);
  using Type = decltype(of(static_cast<const VehicleOfAutoware*>(nullptr)));
};

/// Takes the place of `AstarSearch` and `RRTStar`. Poses are in the frame of the costmap.
class FreespacePlanner : public autoware::freespace_planning_algorithms::AbstractPlanningAlgorithm {
 public:
  using PlannerCommonParam = autoware::freespace_planning_algorithms::PlannerCommonParam;
  using VehicleInfo = VehicleOfAutoware::Type;

  /// `own` are values of Vändplan's parameters by name (ros/README.md), such as
  /// {{"style", std::string("driver")}, {"margin", 0.2}}. Throws vandplan::InputError naming the
  /// number that is wrong.
  FreespacePlanner(const PlannerCommonParam& planner_common_param,
                   const rclcpp::Clock::SharedPtr& clock, const VehicleInfo& collision_vehicle,
                   const vandplan::ros::Parameters::Values& own = {});
  /// The same with the arguments of `AstarSearch`.
  FreespacePlanner(const PlannerCommonParam& planner_common_param,
                   const VehicleInfo& collision_vehicle, rclcpp::Node& node,
                   const vandplan::ros::Parameters::Values& own = {});
  ~FreespacePlanner() override;  // in the library, which shows others nothing of Vändplan

  void setMap(const nav_msgs::msg::OccupancyGrid& costmap) override;
  bool makePlan(const geometry_msgs::msg::Pose& start_pose,
                const geometry_msgs::msg::Pose& goal_pose) override;
  /// Plans to whichever goal is cheapest to reach.
  bool makePlan(const geometry_msgs::msg::Pose& start_pose,
                const std::vector<geometry_msgs::msg::Pose>& goal_candidates) override;
  bool hasObstacleOnTrajectory(const geometry_msgs::msg::PoseArray& trajectory) const override;

  /// The last path with the times of its fastest drive; points are at most `period` apart [s].
  /// Empty without a path.
  [[nodiscard]] autoware_planning_msgs::msg::Trajectory trajectory(double period) const;

  /// Why the last call found no path; empty if it found one.
  [[nodiscard]] const std::string& reason() const noexcept { return answer_.message; }

 private:
  vandplan::ros::Request request_;  // without start and goals
  mutable vandplan::ros::Planner planner_;
  vandplan::ros::Answer answer_;
};

}  // namespace vandplan_autoware
