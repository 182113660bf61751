// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <vandplan_nav2/planner.hpp>

#include <algorithm>
#include <cstdint>
#include <nav2_core/planner_exceptions.hpp>
#include <pluginlib/class_list_macros.hpp>
#include <rcl_interfaces/msg/parameter_descriptor.hpp>
#include <utility>
#include <variant>

#include "ros/adapter/cancel_watch.h"
#include "vandplan/input_error.h"

namespace vandplan_nav2 {
namespace {

using vandplan::InputError;
using vandplan::OptionValue;
using vandplan::ros::Outcome;
using vandplan::ros::Parameter;

rclcpp::ParameterType type_of(const OptionValue& value) {
  constexpr rclcpp::ParameterType types[] = {rclcpp::PARAMETER_BOOL, rclcpp::PARAMETER_INTEGER,
                                             rclcpp::PARAMETER_DOUBLE, rclcpp::PARAMETER_STRING};
  return types[value.index()];  // in the order of OptionValue
}

rcl_interfaces::msg::ParameterDescriptor descriptor_of(const Parameter& parameter) {
  const auto& [info, has_default] = parameter;
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = parameter.description();
  if (std::holds_alternative<double>(info.default_value)) {
    rcl_interfaces::msg::FloatingPointRange range;
    range.from_value = info.least;
    range.to_value = info.most;
    descriptor.floating_point_range.push_back(range);
  } else if (std::holds_alternative<std::int64_t>(info.default_value)) {
    rcl_interfaces::msg::IntegerRange range;
    range.from_value = static_cast<std::int64_t>(info.least);
    range.to_value = info.most < 0x1p63 ? static_cast<std::int64_t>(info.most) : INT64_MAX;
    range.step = 1;
    descriptor.integer_range.push_back(range);
  }
  return descriptor;
}

/// Value of the parameter that the adapter calls `name`.
OptionValue value_of(const std::string& name, const rclcpp::Parameter& parameter) {
  switch (parameter.get_type()) {
    case rclcpp::PARAMETER_BOOL:
      return parameter.as_bool();
    case rclcpp::PARAMETER_INTEGER:
      return parameter.as_int();
    case rclcpp::PARAMETER_DOUBLE:
      return parameter.as_double();
    case rclcpp::PARAMETER_STRING:
      return parameter.as_string();
    default:
      throw InputError(name, "is a list, expected one value");
  }
}

/// Throws what Nav2 calls that outcome.
[[noreturn]] void refuse(Outcome outcome, const std::string& why) {
  switch (outcome) {
    case Outcome::start_outside_map:
      throw nav2_core::StartOutsideMapBounds(why);
    case Outcome::goal_outside_map:
      throw nav2_core::GoalOutsideMapBounds(why);
    case Outcome::start_occupied:
      throw nav2_core::StartOccupied(why);
    case Outcome::goal_occupied:
      throw nav2_core::GoalOccupied(why);
    case Outcome::no_path:
      throw nav2_core::NoValidPathCouldBeFound(why);
    case Outcome::timed_out:
      throw nav2_core::PlannerTimedOut(why);
    case Outcome::cancelled:
      throw nav2_core::PlannerCancelled(why);
    case Outcome::solved:
    case Outcome::invalid:
      break;
  }
  throw nav2_core::PlannerException(why);
}

vandplan::ros::Robot robot_of(nav2_costmap_2d::Costmap2DROS& costmap) {
  vandplan::ros::Robot robot;
  if (costmap.getUseRadius()) robot.radius = costmap.getRobotRadius();
  for (const auto& corner : costmap.getRobotFootprint()) {
    robot.footprint.push_back({corner.x, corner.y});
  }
  return robot;
}

/// Whether nobody has set an orientation: it is zero, or the one that a new message has.
bool is_unset(const geometry_msgs::msg::Quaternion& orientation) {
  const auto& [x, y, z, w] = orientation;
  return x == 0.0 && y == 0.0 && z == 0.0 && (w == 0.0 || w == 1.0);
}

/// Lets the planner copy what has changed of a costmap, which stands still meanwhile.
void take_costmap(nav2_costmap_2d::Costmap2D& costmap, vandplan::ros::Planner& planner) {
  const std::lock_guard<nav2_costmap_2d::Costmap2D::mutex_t> still(*costmap.getMutex());
  const std::size_t columns = costmap.getSizeInCellsX();
  const std::size_t rows = costmap.getSizeInCellsY();
  planner.take({.costs = {costmap.getCharMap(), columns * rows},
                .columns = static_cast<std::int32_t>(columns),
                .rows = static_cast<std::int32_t>(rows),
                .resolution = costmap.getResolution(),
                .origin = {costmap.getOriginX(), costmap.getOriginY(), 0.0}});
}

}  // namespace

void Planner::declare_parameters(nav2::LifecycleNode& node) const {
  for (const Parameter& parameter : vandplan::ros::parameters()) {
    const auto& [info, has_default] = parameter;
    const std::string full = name_ + "." + info.name;
    if (node.has_parameter(full)) continue;
    if (!has_default) {
      node.declare_parameter(full, type_of(info.default_value), descriptor_of(parameter));
      continue;
    }
    const auto value = std::visit([](const auto& held) { return rclcpp::ParameterValue(held); },
                                  info.default_value);
    node.declare_parameter(full, value, descriptor_of(parameter));
  }
}

Planner::Values Planner::values_of(const std::vector<rclcpp::Parameter>& parameters) const {
  Values values;
  const std::string prefix = name_ + ".";
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& full = parameter.get_name();
    if (full.compare(0, prefix.size(), prefix) != 0) continue;
    const std::string name = full.substr(prefix.size());
    // Others may have parameters below this name: `plugin` is Nav2's.
    if (vandplan::ros::find_parameter(name) == nullptr) continue;
    values.emplace(name, value_of(name, parameter));
  }
  return values;
}

void Planner::configure(const nav2::LifecycleNode::WeakPtr& parent, std::string name,
                        nav2::TransformBuffer::SharedPtr /*tf*/,
                        std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) {
  node_ = parent;
  const auto node = parent.lock();
  name_ = std::move(name);
  logger_ = node->get_logger();
  clock_ = node->get_clock();
  costmap_ros_ = std::move(costmap_ros);
  frame_ = costmap_ros_->getGlobalFrameID();
  declare_parameters(*node);
  std::vector<rclcpp::Parameter> known;
  for (const Parameter& parameter : vandplan::ros::parameters()) {
    rclcpp::Parameter value;
    if (node->get_parameter(name_ + "." + parameter.info.name, value)) known.push_back(value);
  }
  try {
    parameters_ = {};
    parameters_.set(values_of(known));
  } catch (const InputError& error) {
    throw nav2_core::PlannerException(name_ + "." + error.what());
  }
  RCLCPP_INFO(logger_, "%s plans with Vandplan", name_.c_str());
}

void Planner::cleanup() {
  const std::lock_guard<std::mutex> one(planner_mutex_);
  planner_ = {};
}

void Planner::activate() {
  const auto node = node_.lock();
  on_set_ = node->add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter>& parameters) { return checked(parameters); });
  after_set_ = node->add_post_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter>& parameters) { take(parameters); });
}

void Planner::deactivate() {
  on_set_.reset();
  after_set_.reset();
}

rcl_interfaces::msg::SetParametersResult Planner::checked(
    const std::vector<rclcpp::Parameter>& parameters) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  try {
    const std::lock_guard<std::mutex> one(parameters_mutex_);
    vandplan::ros::Parameters trial = parameters_;
    trial.set(values_of(parameters));
  } catch (const InputError& error) {
    result.successful = false;
    result.reason = name_ + "." + error.what();
  }
  return result;
}

void Planner::take(const std::vector<rclcpp::Parameter>& parameters) {
  const std::lock_guard<std::mutex> one(parameters_mutex_);
  parameters_.set(values_of(parameters));
}

vandplan::Pose Planner::pose_of(const geometry_msgs::msg::PoseStamped& stamped) const {
  geometry_msgs::msg::PoseStamped here = stamped;
  const std::string& frame = stamped.header.frame_id;
  if (!frame.empty() && !costmap_ros_->transformPoseToGlobalFrame(stamped, here)) {
    throw nav2_core::PlannerTFError("nothing is known of how '" + frame + "' lies in '" + frame_ +
                                    "', the frame of the costmap");
  }
  const auto& [x, y, z, w] = here.pose.orientation;
  return {here.pose.position.x, here.pose.position.y, vandplan::ros::heading_of(x, y, z, w)};
}

nav_msgs::msg::Path Planner::message_of(const vandplan::ros::Answer& answer) const {
  nav_msgs::msg::Path path;
  path.header.stamp = clock_->now();
  path.header.frame_id = frame_;
  path.poses.reserve(answer.poses.size());
  for (const vandplan::ros::PathPose& at : answer.poses) {
    geometry_msgs::msg::PoseStamped& pose = path.poses.emplace_back();
    pose.header = path.header;
    pose.pose.position.x = at.pose.x;
    pose.pose.position.y = at.pose.y;
    const auto [z, w] = vandplan::ros::quaternion_of(at.pose.heading);
    pose.pose.orientation.z = z;
    pose.pose.orientation.w = w;
  }
  return path;
}

nav_msgs::msg::Path Planner::createPlan(
    const geometry_msgs::msg::PoseStamped& start, const geometry_msgs::msg::PoseStamped& goal,
    const std::vector<geometry_msgs::msg::PoseStamped>& viapoints,
    std::function<bool()> cancel_checker) {
  const vandplan::ros::CancelWatch watch(std::move(cancel_checker));
  const std::lock_guard<std::mutex> one(planner_mutex_);
  vandplan::ros::Answer answer;
  try {
    vandplan::ros::Request request;
    {
      const std::lock_guard<std::mutex> still(parameters_mutex_);
      request = request_of(parameters_, robot_of(*costmap_ros_));
    }
    request.start = pose_of(start);
    request.goals = {pose_of(goal)};
    request.viapoints.reserve(viapoints.size());
    for (const auto& viapoint : viapoints) {
      request.viapoints.push_back({pose_of(viapoint), is_unset(viapoint.pose.orientation)});
    }
    request.stop = watch.token();
    take_costmap(*costmap_ros_->getCostmap(), planner_);
    answer = planner_.plan(request);
  } catch (const InputError& error) {
    throw nav2_core::PlannerException(error.what());
  }
  if (answer.outcome != Outcome::solved) refuse(answer.outcome, answer.message);
  return message_of(answer);
}

}  // namespace vandplan_nav2

PLUGINLIB_EXPORT_CLASS(vandplan_nav2::Planner, nav2_core::GlobalPlanner)
