// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Does the plugin for Nav2 tell Nav2 what the adapter says? Nav2 is a stand-in here.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <nav2_core/planner_exceptions.hpp>
#include <numbers>

#include <vandplan_nav2/planner.hpp>
#include "ros/adapter/parameters.h"

namespace vandplan_nav2 {
namespace {

geometry_msgs::msg::PoseStamped pose_at(double x, double y, double heading = 0.0) {
  geometry_msgs::msg::PoseStamped pose;
  pose.header.frame_id = "map";
  pose.pose.position.x = x;
  pose.pose.position.y = y;
  pose.pose.orientation.z = std::sin(heading / 2);
  pose.pose.orientation.w = std::cos(heading / 2);
  return pose;
}

/// A room of 20 x 12 m, a wall in it, and a node that has read a parameter file.
class Nav2Plugin : public testing::Test {
 protected:
  void SetUp() override {
    for (unsigned int row = 0; row < 80; ++row) {
      for (unsigned int column = 98; column < 102; ++column) costs(column, row) = 254;
    }
    ros_->footprint = {{0.5, 0.2, 0}, {-0.1, 0.2, 0}, {-0.1, -0.2, 0}, {0.5, -0.2, 0}};
    override_with("max_iterations", std::int64_t{2000});
  }

  unsigned char& costs(unsigned int column, unsigned int row) {
    return costmap_.costs[std::size_t{row} * 200 + column];
  }
  template <typename Value>
  void override_with(const std::string& name, Value value) {
    node_->overrides[name_ + "." + name] = rclcpp::ParameterValue(std::move(value));
  }
  void configure() {
    planner_.configure(node_, name_, nullptr, ros_);
    planner_.activate();
  }
  template <typename Value>
  rcl_interfaces::msg::SetParametersResult set(const std::string& name, Value value) {
    return node_->set_parameters_atomically({rclcpp::Parameter(name, std::move(value))});
  }
  nav_msgs::msg::Path plan(const geometry_msgs::msg::PoseStamped& start,
                           const geometry_msgs::msg::PoseStamped& goal) {
    return planner_.createPlan(start, goal, {}, [] { return false; });
  }

  const std::string name_ = "GridBased";
  nav2_costmap_2d::Costmap2D costmap_{200, 120, 0.1, 0.0, 0.0};
  std::shared_ptr<nav2_costmap_2d::Costmap2DROS> ros_ =
      std::make_shared<nav2_costmap_2d::Costmap2DROS>(costmap_);
  std::shared_ptr<nav2::LifecycleNode> node_ = std::make_shared<nav2::LifecycleNode>();
  Planner planner_;
};

TEST_F(Nav2Plugin, APathIsAMessage) {
  configure();
  const nav_msgs::msg::Path path = plan(pose_at(3, 3, 1), pose_at(17, 3));
  EXPECT_EQ(path.header.frame_id, "map");
  EXPECT_EQ(path.header.stamp.sec, 1);
  ASSERT_GT(path.poses.size(), 140U);
  EXPECT_EQ(path.poses[7].header.frame_id, "map");
  EXPECT_NEAR(path.poses.front().pose.orientation.z, std::sin(0.5), 1e-12);
  EXPECT_NEAR(path.poses.back().pose.position.x, 17, 1e-6);
  EXPECT_NEAR(path.poses.back().pose.orientation.w, 1, 1e-6);
}

TEST_F(Nav2Plugin, EveryOutcomeIsAnException) {
  configure();
  const auto good = pose_at(3, 3), goal = pose_at(17, 3);
  EXPECT_THROW(plan(pose_at(10, 3), goal), nav2_core::StartOccupied);
  EXPECT_THROW(plan(good, pose_at(10, 3)), nav2_core::GoalOccupied);
  EXPECT_THROW(plan(pose_at(-1, 3), goal), nav2_core::StartOutsideMapBounds);
  EXPECT_THROW(plan(good, pose_at(21, 3)), nav2_core::GoalOutsideMapBounds);
  EXPECT_THROW(planner_.createPlan(good, goal, {}, [] { return true; }),
               nav2_core::PlannerCancelled);
  for (unsigned int row = 80; row < 120; ++row) costs(99, row) = 254;
  EXPECT_THROW(plan(good, goal), nav2_core::NoValidPathCouldBeFound);
  for (unsigned int row = 80; row < 120; ++row) costs(99, row) = 0;
  EXPECT_TRUE(set(name_ + ".max_iterations", std::int64_t{0}).successful);
  EXPECT_THROW(plan(good, pose_at(16, 4, 3)), nav2_core::PlannerTimedOut);
  auto elsewhere = goal;
  elsewhere.header.frame_id = "odom";
  EXPECT_THROW(plan(good, elsewhere), nav2_core::PlannerTFError);
  auto no_number = goal;
  no_number.pose.position.x = NAN;
  EXPECT_THROW(plan(good, no_number), nav2_core::PlannerException);
  ros_->footprint.clear();
  EXPECT_THROW(plan(good, goal), nav2_core::PlannerException);
  ros_->radius = 0.3;
  EXPECT_TRUE(set(name_ + ".max_iterations", std::int64_t{2000}).successful);
  EXPECT_FALSE(plan(good, goal).poses.empty()) << "a round robot has no corners";
}

TEST_F(Nav2Plugin, AViaPointMayHaveAnotherFrame) {
  configure();
  ros_->frames["dock"] = pose_at(5, 10, std::numbers::pi / 2).pose;
  auto viapoint = pose_at(-1, -2, -std::numbers::pi / 2);  // at (7, 9) in the costmap, heading 0
  viapoint.header.frame_id = "dock";
  const auto path =
      planner_.createPlan(pose_at(3, 3), pose_at(17, 3), {viapoint}, [] { return false; });
  const auto is_there = [](const geometry_msgs::msg::PoseStamped& at) {
    return std::hypot(at.pose.position.x - 7, at.pose.position.y - 9) < 0.06 &&
           std::abs(at.pose.orientation.z) < 0.1;
  };
  EXPECT_TRUE(std::any_of(path.poses.begin(), path.poses.end(), is_there));
  viapoint.header.frame_id = "moon";
  EXPECT_THROW(planner_.createPlan(pose_at(3, 3), pose_at(17, 3), {viapoint}, [] { return false; }),
               nav2_core::PlannerTFError);
}

TEST_F(Nav2Plugin, AFrameThatIsNotNamedIsTheCostmaps) {
  configure();
  auto goal = pose_at(6, 3);
  goal.header.frame_id.clear();
  EXPECT_FALSE(plan(pose_at(3, 3), goal).poses.empty());
}

TEST_F(Nav2Plugin, ParametersAreDeclaredWithTheirRanges) {
  node_->declare_parameter("GridBased.margin", rclcpp::ParameterValue(0.1));  // somebody was first
  configure();
  for (const auto& [info, has_default] : vandplan::ros::parameters()) {
    EXPECT_TRUE(node_->has_parameter("GridBased." + info.name)) << info.name;
  }
  const auto& price = node_->descriptors["GridBased.reverse_weight"];
  EXPECT_EQ(price.description, "cost of a metre in reverse; 1 to 1000");
  ASSERT_EQ(price.floating_point_range.size(), 1U);
  EXPECT_EQ(price.floating_point_range[0].from_value, 1.0);
  EXPECT_EQ(price.floating_point_range[0].to_value, 1000.0);
  const auto& seed = node_->descriptors["GridBased.seed"];
  ASSERT_EQ(seed.integer_range.size(), 1U);
  EXPECT_EQ(seed.integer_range[0].to_value, INT64_MAX);
  EXPECT_TRUE(node_->descriptors["GridBased.style"].integer_range.empty());
  rclcpp::Parameter value;
  EXPECT_TRUE(node_->get_parameter("GridBased.margin", value));
  EXPECT_EQ(value.as_double(), 0.1);
  EXPECT_FALSE(node_->get_parameter("GridBased.style", value)) << "not set";
}

TEST_F(Nav2Plugin, AWrongValueInTheFileIsNamed) {
  override_with("minimum_turning_radius", 0.0);
  try {
    configure();
    FAIL();
  } catch (const nav2_core::PlannerException& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 33), "GridBased.minimum_turning_radius:");
  }
}

TEST_F(Nav2Plugin, ChangedParametersAreChecked) {
  configure();
  const auto margin_is = [&](double margin) { return set("GridBased.margin", margin); };
  EXPECT_TRUE(margin_is(0.2).successful);
  EXPECT_THROW(plan(pose_at(9.2, 3), pose_at(17, 3)), nav2_core::StartOccupied) << "too near";
  const auto refused = margin_is(-1.0);
  EXPECT_FALSE(refused.successful);
  EXPECT_EQ(refused.reason.substr(0, 17), "GridBased.margin:");
  EXPECT_FALSE(set("GridBased.style", std::string("sideways")).successful);
  EXPECT_EQ(set("GridBased.margin", std::vector<std::uint8_t>{1}).reason,
            "GridBased.margin: is a list, expected one value");
  EXPECT_TRUE(set("GridBased.plugin", std::string("other")).successful) << "Nav2's own";
  EXPECT_TRUE(set("Other.margin", -1.0).successful) << "of another planner";
  EXPECT_TRUE(margin_is(0.0).successful);
  EXPECT_FALSE(plan(pose_at(9.2, 3), pose_at(17, 3)).poses.empty());
  planner_.deactivate();
  EXPECT_TRUE(margin_is(-1.0).successful) << "nobody listens";
}

TEST_F(Nav2Plugin, GradedCostsHaveAPriceThatMayChange) {
  configure();
  for (unsigned int row = 95; row < 107; ++row) {
    for (unsigned int column = 60; column < 140; ++column) costs(column, row) = 252;
  }
  const auto farthest = [&] {
    planner_.cleanup();
    double most = 0.0;
    for (const auto& pose : plan(pose_at(3, 10), pose_at(17, 10)).poses) {
      most = std::max(most, std::abs(pose.pose.position.y - 10));
    }
    return most;
  };
  EXPECT_GT(farthest(), 0.4);
  EXPECT_TRUE(set("GridBased.cost_penalty", 0.0).successful);
  EXPECT_LT(farthest(), 0.01);
  EXPECT_FALSE(set("GridBased.cost_penalty", -1.0).successful);
}

TEST_F(Nav2Plugin, WordsAndFlagsReachTheAdapter) {
  override_with("gears", std::string("forward"));
  override_with("allow_unknown", false);
  configure();
  EXPECT_FALSE(plan(pose_at(6, 3), pose_at(4, 3)).poses.empty());
  costs(40, 30) = 255;
  EXPECT_THROW(plan(pose_at(4, 3), pose_at(6, 3)), nav2_core::StartOccupied);
}

TEST_F(Nav2Plugin, ViaPointsArePassed) {
  configure();
  const auto path =
      planner_.createPlan(pose_at(3, 3), pose_at(17, 3), {pose_at(5, 10)}, [] { return false; });
  double nearest = 1e9;
  for (const auto& pose : path.poses) {
    nearest = std::min(nearest, std::hypot(pose.pose.position.x - 5, pose.pose.position.y - 10));
  }
  EXPECT_LT(nearest, 0.1) << "poses are a cell apart";
}

TEST_F(Nav2Plugin, AViaPointWithoutAnOrientationHasAnyHeading) {
  override_with("steering", std::string("reeds-shepp"));
  configure();
  const auto length_past = [&](const geometry_msgs::msg::PoseStamped& viapoint) {
    const auto path =
        planner_.createPlan(pose_at(4, 4, std::numbers::pi / 2),
                            pose_at(4, 10, std::numbers::pi / 2), {viapoint}, [] { return false; });
    double sum = 0.0;
    for (std::size_t i = 1; i < path.poses.size(); ++i) {
      sum += std::hypot(path.poses[i].pose.position.x - path.poses[i - 1].pose.position.x,
                        path.poses[i].pose.position.y - path.poses[i - 1].pose.position.y);
    }
    return sum;
  };
  auto viapoint = pose_at(4, 7);
  EXPECT_NEAR(length_past(viapoint), 6.0, 0.01) << "as a new message has it";
  viapoint.pose.orientation.w = 0.0;
  EXPECT_NEAR(length_past(viapoint), 6.0, 0.01) << "all zero";
  EXPECT_GT(length_past(pose_at(4, 7, 1e-6)), 6.5) << "a heading";
  EXPECT_GT(length_past(pose_at(4, 7, -0.5)), 6.1) << "a heading";
}

TEST_F(Nav2Plugin, ACancelledActionEndsSoon) {
  override_with("time_limit", 1000.0);
  node_->overrides.erase("GridBased.max_iterations");
  configure();
  std::atomic<int> asked = 0;
  EXPECT_THROW(planner_.createPlan(pose_at(3, 3), pose_at(17, 3), {}, [&] { return ++asked > 10; }),
               nav2_core::PlannerCancelled);
}

TEST_F(Nav2Plugin, CleaningUpForgetsTheLastPath) {
  configure();
  EXPECT_FALSE(plan(pose_at(3, 3), pose_at(17, 3)).poses.empty());
  EXPECT_TRUE(set("GridBased.max_iterations", std::int64_t{0}).successful);
  EXPECT_FALSE(plan(pose_at(3, 3), pose_at(17, 3)).poses.empty()) << "the last path";
  planner_.cleanup();
  EXPECT_THROW(plan(pose_at(3, 3), pose_at(17, 3)), nav2_core::PlannerTimedOut);
}

}  // namespace
}  // namespace vandplan_nav2
