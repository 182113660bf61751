// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "ros/adapter/parameters.h"

#include <algorithm>
#include <array>
#include <vector>

#include "vandplan/input_error.h"
#include "vandplan/planner.h"

namespace vandplan::ros {
namespace {

constexpr double longest = 1000.0;  // largest length of a robot [m]
constexpr std::array heading_modes = {"DEFAULT", "BIDIRECTIONAL", "ALL_DIRECTION"};

Parameter number(std::string name, std::string summary, std::optional<double> default_value,
                 double least, double most) {
  return {{.name = std::move(name),
           .summary = std::move(summary),
           .default_value = default_value.value_or(least),
           .least = least,
           .most = most},
          default_value.has_value()};
}

/// What concerns the robot and its costmap.
std::vector<Parameter> own_parameters() {
  const DrivingLimits limits;
  return {
      {{.name = "allow_unknown",
        .summary = "whether unknown cells are free",
        .default_value = true}},
      {{.name = "lethal_cost",
        .summary = "least cost of a cell that the body may not touch; 253 keeps it out of "
                   "inscribed cells, too",
        .default_value = std::int64_t{nav2_lethal_cost},
        .least = 1,
        .most = nav2_lethal_cost}},
      number("cost_penalty",
             "price of a metre in a cell of the highest graded cost, on top of its length; in "
             "proportion below; 0: costs have no price",
             CostRule{}.cost_penalty, 0.0, 999.0),
      {{.name = "goal_heading_mode",
        .summary = "headings that the goal allows: its own, also turned by half a turn, or any",
        .default_value = std::string(heading_modes.front()),
        .words = {heading_modes.begin(), heading_modes.end()}}},
      number(
          "tolerance",
          "half the side of the square around the goal, along its heading, in which the path may "
          "end if the goal is not free [m]",
          0.0, 0.0, longest),
      number("minimum_turning_radius", "least turning radius of the midpoint of the rear axle [m]",
             Chassis{}.min_turning_radius, 0.001, longest),
      number("wheelbase",
             "rear axle to front axle [m]; not set: the front axle is at the front of the body",
             std::nullopt, 0.001, longest),
      number("rear_axle", "x of the rear axle in the frame base_link [m]", 0.0, -longest, longest),
      number("max_steering_rate", "largest rate of the front wheels' angle [rad/s]",
             limits.max_steering_rate, 0.001, 1000.0),
      number("max_curvature_rate",
             "largest change of curvature per metre driven [1/m^2]; not set: what "
             "max_steering_rate allows at 1 m/s",
             std::nullopt, 0.001, 1000.0),
  };
}

/// A common option as a parameter. It has the default of `PlanOptions`, if that has a value.
Parameter parameter_of(const CommonOption& option) {
  Parameter parameter{{.name = std::string(option.name),
                       .summary = std::string(option.summary),
                       .default_value = !option.words.empty() ? OptionValue(std::string())
                                        : option.is_whole     ? OptionValue(std::int64_t{0})
                                                              : OptionValue(0.0),
                       .least = option.least,
                       .most = option.most,
                       .words = {option.words.begin(), option.words.end()}}};
  if (!option.unit.empty()) parameter.info.summary += " [" + std::string(option.unit) + "]";
  std::string text = option.get(PlanOptions{});
  std::erase(text, '"');
  parameter.has_default = text != "null";
  if (parameter.has_default) parameter.info.default_value = parsed_value(parameter.info, text);
  return parameter;
}

std::vector<Parameter> all_parameters() {
  std::vector<Parameter> all = own_parameters();
  for (const CommonOption& option : style_and_common_options()) all.push_back(parameter_of(option));
  for (const OptionInfo& option : default_planner().options) all.push_back({option});
  return all;
}

/// Text of a value, as `--set` takes it.
std::string text_of(const OptionValue& value) {
  const auto* const word = std::get_if<std::string>(&value);
  return word != nullptr ? *word : json_of(value);
}

PlanOptions options_of(const Parameters::Values& values) {
  std::vector<Setting> settings;
  for (const auto& [name, value] : values) {
    if (honours(default_planner(), name) || name == "style") {
      settings.push_back({name, text_of(value)});
    }
  }
  std::stable_sort(settings.begin(), settings.end(), [](const Setting& a, const Setting& b) {
    return setting_order(a.name) < setting_order(b.name);
  });
  PlanOptions options;
  for (const auto& [name, value] : settings) set_option(options, default_planner(), name, value);
  return options;
}

template <typename Value>
const Value& value_of(const Parameters::Values& values, std::string_view name) {
  return std::get<Value>(values.find(name)->second);
}

std::optional<double> number_of(const Parameters::Values& values, std::string_view name) {
  const auto found = values.find(name);
  if (found == values.end()) return std::nullopt;
  return std::get<double>(found->second);
}

}  // namespace

std::string Parameter::description() const { return info.summary + "; " + info.range(); }

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> all = all_parameters();
  return all;
}

const Parameter* find_parameter(std::string_view name) {
  const std::span<const Parameter> all = parameters();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& parameter) {
    return parameter.info.name == name;
  });
  return found == all.end() ? nullptr : &*found;
}

Parameters::Parameters() {
  for (const auto& [info, has_default] : parameters()) {
    if (has_default) values_.emplace(info.name, info.default_value);
  }
  options_ = options_of(values_);
}

void Parameters::set(const Values& values) {
  Values all = values_;
  for (const auto& [name, value] : values) {
    const Parameter* const parameter = find_parameter(name);
    if (parameter == nullptr) throw InputError(name, "is no parameter of this planner");
    all.insert_or_assign(name, fitting_value(parameter->info, value));
  }
  PlanOptions options = options_of(all);
  (void)complete(default_planner(), options);
  const bool is_any = value_of<std::string>(all, "goal_heading_mode") == heading_modes.back();
  if (is_any && value_of<double>(all, "rear_axle") != 0.0) {
    throw InputError("goal_heading_mode",
                     "is ALL_DIRECTION, expected another one with a rear_axle that is not 0");
  }
  values_ = std::move(all);
  options_ = std::move(options);
}

const OptionValue* Parameters::find(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : &found->second;
}

CostRule Parameters::cost_rule() const {
  return {.lethal_cost = static_cast<int>(value_of<std::int64_t>(values_, "lethal_cost")),
          .allow_unknown = value_of<bool>(values_, "allow_unknown"),
          .cost_penalty = value_of<double>(values_, "cost_penalty")};
}

Chassis Parameters::chassis() const {
  Chassis chassis{.min_turning_radius = value_of<double>(values_, "minimum_turning_radius"),
                  .wheelbase = number_of(values_, "wheelbase"),
                  .rear_axle = value_of<double>(values_, "rear_axle")};
  chassis.limits.max_steering_rate = value_of<double>(values_, "max_steering_rate");
  chassis.limits.max_curvature_rate = number_of(values_, "max_curvature_rate");
  return chassis;
}

GoalHeading Parameters::goal_heading() const {
  const auto* const found = std::find(heading_modes.begin(), heading_modes.end(),
                                      value_of<std::string>(values_, "goal_heading_mode"));
  return static_cast<GoalHeading>(found - heading_modes.begin());
}

double Parameters::tolerance() const { return value_of<double>(values_, "tolerance"); }

}  // namespace vandplan::ros
