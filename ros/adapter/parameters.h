// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which parameters does the plugin have, and what do their values mean?

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ros/adapter/costmap.h"
#include "ros/adapter/robot.h"
#include "vandplan/plan_options.h"

namespace vandplan::ros {

/// A parameter as ROS declares it. Whole numbers are integers, words are strings.
struct Parameter {
  /// Name, meaning, range and words. The type of `default_value` is that of the parameter.
  OptionInfo info;
  /// Whether `default_value` is the default. Otherwise there is none: while it is not set, the
  /// style or the vehicle says what holds.
  bool has_default = true;

  /// Meaning and range in one line, for a ParameterDescriptor.
  [[nodiscard]] std::string description() const;
};

/// All parameters: what concerns ROS, the common options of Vändplan and those of its default
/// planner. Their names are those of Nav2 where Nav2 has a parameter of equal meaning and unit, and
/// otherwise those of `vandplan --set`.
[[nodiscard]] std::span<const Parameter> parameters();

/// The parameter of that name; null if there is none.
[[nodiscard]] const Parameter* find_parameter(std::string_view name);

/// Headings that a goal allows, as Nav2's `goal_heading_mode` names them.
enum class GoalHeading {
  given,       ///< DEFAULT: the heading of the goal
  either_way,  ///< BIDIRECTIONAL: that heading, or turned by half a turn
  any,         ///< ALL_DIRECTION: every heading
};

/// Values of all parameters, which fit together.
class Parameters {
 public:
  /// Values by name.
  using Values = std::map<std::string, OptionValue, std::less<>>;

  /// The default values.
  Parameters();

  /// Sets several values at once. Throws InputError naming the parameter that does not exist, whose
  /// value has another type or is out of range, or that does not fit the others; then nothing has
  /// changed.
  void set(const Values& values);

  /// The value of a parameter; null while it is not set.
  [[nodiscard]] const OptionValue* find(std::string_view name) const;

  /// Options of planning.
  [[nodiscard]] const PlanOptions& options() const noexcept { return options_; }
  [[nodiscard]] CostRule cost_rule() const;
  [[nodiscard]] Chassis chassis() const;
  [[nodiscard]] GoalHeading goal_heading() const;
  /// Half the side of the square in which the path may end if the goal is not free [m].
  [[nodiscard]] double tolerance() const;

 private:
  Values values_;
  PlanOptions options_;
};

}  // namespace vandplan::ros
