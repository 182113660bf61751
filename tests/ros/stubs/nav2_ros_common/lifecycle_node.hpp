// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for Nav2: the names that our plugins use.

#include <memory>
#include <rclcpp/rclcpp.hpp>

namespace nav2 {
class LifecycleNode : public rclcpp::Node {
 public:
  using SharedPtr = std::shared_ptr<LifecycleNode>;
  using WeakPtr = std::weak_ptr<LifecycleNode>;
};
}  // namespace nav2
