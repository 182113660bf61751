// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Nav2's planner server plan with Vändplan?
//
// Everything but the messages is in ros/adapter.

#include <functional>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <memory>
#include <mutex>
#include <nav2_core/global_planner.hpp>
#include <nav2_costmap_2d/costmap_2d_ros.hpp>
#include <nav2_ros_common/lifecycle_node.hpp>
#include <nav2_ros_common/tf2_factories.hpp>
#include <nav_msgs/msg/path.hpp>
#include <rcl_interfaces/msg/set_parameters_result.hpp>
#include <rclcpp/rclcpp.hpp>
#include <string>
#include <vector>

#include "ros/adapter/planner.h"

namespace vandplan_nav2 {

/// Planner plugin `vandplan_nav2::Planner`.
class Planner : public nav2_core::GlobalPlanner {
 public:
  /// Declares and reads the parameters NAME.*. Throws nav2_core::PlannerException for a value that
  /// is not valid.
  void configure(const nav2::LifecycleNode::WeakPtr& parent, std::string name,
                 nav2::TransformBuffer::SharedPtr tf,
                 std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) override;
  void cleanup() override;
  /// From now on changed parameters are checked and taken.
  void activate() override;
  void deactivate() override;

  /// Throws the exception of nav2_core that says why there is no path.
  nav_msgs::msg::Path createPlan(const geometry_msgs::msg::PoseStamped& start,
                                 const geometry_msgs::msg::PoseStamped& goal,
                                 const std::vector<geometry_msgs::msg::PoseStamped>& viapoints,
                                 std::function<bool()> cancel_checker) override;

 private:
  using Values = vandplan::ros::Parameters::Values;

  void declare_parameters(nav2::LifecycleNode& node) const;
  [[nodiscard]] Values values_of(const std::vector<rclcpp::Parameter>& parameters) const;
  [[nodiscard]] rcl_interfaces::msg::SetParametersResult checked(
      const std::vector<rclcpp::Parameter>& parameters);
  void take(const std::vector<rclcpp::Parameter>& parameters);
  /// A pose in the frame of the costmap. One without a frame has that frame.
  [[nodiscard]] vandplan::Pose pose_of(const geometry_msgs::msg::PoseStamped& stamped) const;
  [[nodiscard]] nav_msgs::msg::Path message_of(const vandplan::ros::Answer& answer) const;

  nav2::LifecycleNode::WeakPtr node_;
  std::string name_;
  rclcpp::Logger logger_{rclcpp::get_logger("vandplan_nav2")};
  rclcpp::Clock::SharedPtr clock_;
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros_;
  std::string frame_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr on_set_;
  rclcpp::node_interfaces::PostSetParametersCallbackHandle::SharedPtr after_set_;

  std::mutex parameters_mutex_;
  vandplan::ros::Parameters parameters_;
  std::mutex planner_mutex_;  // one call at a time
  vandplan::ros::Planner planner_;
};

}  // namespace vandplan_nav2
