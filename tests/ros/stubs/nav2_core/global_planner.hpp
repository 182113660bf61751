// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for Nav2: the names that our plugins use.

#include <functional>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <memory>
#include <nav2_costmap_2d/costmap_2d_ros.hpp>
#include <nav2_ros_common/lifecycle_node.hpp>
#include <nav2_ros_common/tf2_factories.hpp>
#include <nav_msgs/msg/path.hpp>
#include <string>
#include <vector>

namespace nav2_core {
class GlobalPlanner {
 public:
  virtual ~GlobalPlanner() = default;
  virtual void configure(const nav2::LifecycleNode::WeakPtr& parent, std::string name,
                         nav2::TransformBuffer::SharedPtr tf,
                         std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) = 0;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;
  virtual nav_msgs::msg::Path createPlan(
      const geometry_msgs::msg::PoseStamped& start, const geometry_msgs::msg::PoseStamped& goal,
      const std::vector<geometry_msgs::msg::PoseStamped>& viapoints,
      std::function<bool()> cancel_checker) = 0;
};
}  // namespace nav2_core
