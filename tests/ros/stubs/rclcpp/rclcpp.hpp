// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for ROS 2: names that our plugins use, and parameters that behave as those of a node.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <rcl_interfaces/msg/parameter_descriptor.hpp>
#include <rcl_interfaces/msg/set_parameters_result.hpp>
#include <std_msgs/msg/header.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rclcpp {

class Logger {};
inline Logger get_logger(const std::string& /*name*/) { return {}; }

class Time {
 public:
  operator builtin_interfaces::msg::Time() const {  // NOLINT(google-explicit-constructor)
    return {1, 2};
  }
};

class Clock {
 public:
  using SharedPtr = std::shared_ptr<Clock>;
  [[nodiscard]] Time now() const { return {}; }
};

enum ParameterType : std::uint8_t {
  PARAMETER_NOT_SET,
  PARAMETER_BOOL,
  PARAMETER_INTEGER,
  PARAMETER_DOUBLE,
  PARAMETER_STRING,
  PARAMETER_BYTE_ARRAY,
};

class ParameterValue {
 public:
  ParameterValue() = default;
  explicit ParameterValue(bool value) : held_(value) {}
  explicit ParameterValue(std::int64_t value) : held_(value) {}
  explicit ParameterValue(double value) : held_(value) {}
  explicit ParameterValue(std::string value) : held_(std::move(value)) {}
  explicit ParameterValue(std::vector<std::uint8_t> value) : held_(std::move(value)) {}

  [[nodiscard]] ParameterType get_type() const { return static_cast<ParameterType>(held_.index()); }
  template <typename Value>
  [[nodiscard]] const Value& as() const {
    return std::get<Value>(held_);
  }

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<std::uint8_t>>
      held_;
};

class Parameter {
 public:
  Parameter() = default;
  Parameter(std::string name, ParameterValue value)
      : name_(std::move(name)), value_(std::move(value)) {}
  template <typename Value>
  Parameter(std::string name, Value value)
      : name_(std::move(name)), value_(ParameterValue(std::move(value))) {}

  [[nodiscard]] const std::string& get_name() const { return name_; }
  [[nodiscard]] ParameterType get_type() const { return value_.get_type(); }
  [[nodiscard]] bool as_bool() const { return value_.as<bool>(); }
  [[nodiscard]] std::int64_t as_int() const { return value_.as<std::int64_t>(); }
  [[nodiscard]] double as_double() const { return value_.as<double>(); }
  [[nodiscard]] const std::string& as_string() const { return value_.as<std::string>(); }

 private:
  std::string name_;
  ParameterValue value_;
};

namespace node_interfaces {
struct OnSetParametersCallbackHandle {
  using SharedPtr = std::shared_ptr<OnSetParametersCallbackHandle>;
  std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter>&)> callback;
};
struct PostSetParametersCallbackHandle {
  using SharedPtr = std::shared_ptr<PostSetParametersCallbackHandle>;
  std::function<void(const std::vector<Parameter>&)> callback;
};
}  // namespace node_interfaces

/// Parameters of a node. Values of a file are `overrides`; callbacks live as long as their handles.
class Node {
 public:
  std::map<std::string, ParameterValue> overrides = {};
  std::map<std::string, rcl_interfaces::msg::ParameterDescriptor> descriptors = {};

  [[nodiscard]] Logger get_logger() const { return {}; }
  Clock::SharedPtr get_clock() { return std::make_shared<Clock>(); }

  [[nodiscard]] bool has_parameter(const std::string& name) const {
    return values_.count(name) != 0;
  }
  void declare_parameter(const std::string& name, const ParameterValue& value,
                         const rcl_interfaces::msg::ParameterDescriptor& descriptor = {}) {
    declare(name, value, value.get_type(), descriptor);
  }
  void declare_parameter(const std::string& name, ParameterType type,
                         const rcl_interfaces::msg::ParameterDescriptor& descriptor = {}) {
    declare(name, {}, type, descriptor);
  }
  bool get_parameter(const std::string& name, Parameter& parameter) const {
    const auto found = values_.find(name);
    if (found == values_.end() || found->second.get_type() == PARAMETER_NOT_SET) return false;
    parameter = Parameter(name, found->second);
    return true;
  }
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(
      const std::vector<Parameter>& parameters) {
    if (const auto check = on_set_.lock()) {
      const auto result = check->callback(parameters);
      if (!result.successful) return result;
    }
    if (const auto take = after_set_.lock()) take->callback(parameters);
    return {true, ""};
  }
  node_interfaces::OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
      std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter>&)> call) {
    auto handle = std::make_shared<node_interfaces::OnSetParametersCallbackHandle>();
    handle->callback = std::move(call);
    on_set_ = handle;
    return handle;
  }
  node_interfaces::PostSetParametersCallbackHandle::SharedPtr add_post_set_parameters_callback(
      std::function<void(const std::vector<Parameter>&)> call) {
    auto handle = std::make_shared<node_interfaces::PostSetParametersCallbackHandle>();
    handle->callback = std::move(call);
    after_set_ = handle;
    return handle;
  }

 private:
  void declare(const std::string& name, const ParameterValue& value, ParameterType type,
               const rcl_interfaces::msg::ParameterDescriptor& descriptor) {
    const auto found = overrides.find(name);
    if (found != overrides.end() && found->second.get_type() != type) {
      throw std::runtime_error("parameter '" + name + "' has another type");
    }
    values_[name] = found != overrides.end() ? found->second : value;
    descriptors[name] = descriptor;
  }

  std::map<std::string, ParameterValue> values_;
  std::weak_ptr<node_interfaces::OnSetParametersCallbackHandle> on_set_;
  std::weak_ptr<node_interfaces::PostSetParametersCallbackHandle> after_set_;
};

}  // namespace rclcpp

#define RCLCPP_INFO(logger, ...) ((void)(logger))
