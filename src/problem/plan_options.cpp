// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/plan_options.h"

#include <algorithm>
#include <limits>

#include "problem/option_text.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using problem::json_text;
using problem::words_of;

/// The value of that name. Throws InputError naming the option.
template <problem::Word Value>
Value word_named(std::string_view option, std::string_view name) {
  try {
    Value value{};
    problem::parse(name, value);
    return value;
  } catch (const InputError& error) {
    throw InputError(std::string(option), error.problem());
  }
}

template <problem::Word Value>
std::string_view word_of(Value value) {
  return words_of<Value>[static_cast<std::size_t>(value)];
}

/// The value of a planner's own option. Throws InputError when the option has no value or one of
/// another type: the planner then reads an option that its registration does not name.
template <typename Value>
const Value& value_of(const PlannerSettings& settings, std::string_view name,
                      const std::string& type) {
  const OptionValue* const found = settings.find(name);
  const Value* const value = found == nullptr ? nullptr : std::get_if<Value>(found);
  if (value != nullptr) return *value;
  throw InputError(std::string(name),
                   "is not set to " + type + ", expected an option of the planner that is " + type);
}

bool is_in_range(const OptionInfo& info, const OptionValue& value) {
  if (const auto* const word = std::get_if<std::string>(&value)) {
    return std::find(info.words.begin(), info.words.end(), *word) != info.words.end();
  }
  if (const auto* const number = std::get_if<double>(&value)) {
    return *number >= info.least && *number <= info.most;
  }
  if (const auto* const integer = std::get_if<std::int64_t>(&value)) {
    const auto number = static_cast<double>(*integer);
    return number >= info.least && number <= info.most;
  }
  return true;
}

}  // namespace

void PlannerSettings::set(std::string_view name, OptionValue value) {
  values_.insert_or_assign(std::string(name), std::move(value));
}

const OptionValue* PlannerSettings::find(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : &found->second;
}

bool PlannerSettings::flag(std::string_view name) const {
  return value_of<bool>(*this, name, "true or false");
}

std::int64_t PlannerSettings::integer(std::string_view name) const {
  return value_of<std::int64_t>(*this, name, "a whole number");
}

double PlannerSettings::number(std::string_view name) const {
  return value_of<double>(*this, name, "a number");
}

const std::string& PlannerSettings::word(std::string_view name) const {
  return value_of<std::string>(*this, name, "a word");
}

std::string problem::range_of(double least, double most, bool is_whole) {
  const auto bound = [&](double value) {
    if (!is_whole) return json_text(value);
    if (value >= 0x1p63) return json_text(std::numeric_limits<std::uint64_t>::max());
    return json_text(static_cast<std::int64_t>(std::max(value, -0x1p63)));
  };
  const bool has_least = least >= -CommonOption::no_limit;
  if (most < CommonOption::no_limit) {
    return has_least ? bound(least) + " to " + bound(most) : "<= " + bound(most);
  }
  if (has_least) return ">= " + bound(least);
  return is_whole ? "any whole number" : "any number";
}

std::string OptionInfo::range() const {
  if (std::holds_alternative<bool>(default_value)) return "true or false";
  if (std::holds_alternative<std::string>(default_value)) return problem::either(words);
  return problem::range_of(least, most, std::holds_alternative<std::int64_t>(default_value));
}

bool is_length(const CostOptions& cost) {
  return cost.measure == CostMeasure::prices && cost.forward_weight == 1.0 &&
         cost.reverse_weight == 1.0 && cost.gear_change_cost == 0.0 &&
         cost.curvature_change_cost == 0.0 && cost.clearance_weight == 0.0;
}

std::string_view name_of(Steering steering) noexcept { return word_of(steering); }
Steering steering_named(std::string_view name) { return word_named<Steering>("steering", name); }

std::string_view name_of(AllowedGears gears) noexcept { return word_of(gears); }
AllowedGears gears_named(std::string_view name) { return word_named<AllowedGears>("gears", name); }

std::string_view name_of(Style style) noexcept { return word_of(style); }
Style style_named(std::string_view name) { return word_named<Style>("style", name); }

CostOptions prices_of(Style style, const Vehicle& vehicle) {
  if (style == Style::shortest) return shortest_style;
  constexpr double smallest = 0.01;  // least scale of prices; keeps them in range
  const double radius = vehicle.min_turning_radius;
  const double truck = Vehicle{}.min_turning_radius;
  const double scale = radius < truck ? std::max(smallest, radius / truck) : 1.0;
  CostOptions prices = driver_style;
  *prices.gear_change_cost *= scale;
  *prices.curvature_change_cost *= scale * scale;
  *prices.clearance_distance *= scale;
  return prices;
}

std::string json_of(const OptionValue& value) {
  return std::visit([](const auto& held) { return json_text(held); }, value);
}

OptionValue parsed_value(const OptionInfo& info, std::string_view text) {
  OptionValue value = info.default_value;
  try {
    std::visit([&](auto& held) { problem::parse(text, held); }, value);
    if (!is_in_range(info, value)) problem::reject(text, info.range());
  } catch (const InputError& error) {
    throw InputError(info.name,
                     error.problem() + ", expected: " + info.summary + "; " + info.range());
  }
  return value;
}

OptionValue fitting_value(const OptionInfo& info, const OptionValue& given) {
  OptionValue value = given;
  const auto* const integer = std::get_if<std::int64_t>(&given);
  if (integer != nullptr && std::holds_alternative<double>(info.default_value)) {
    value = static_cast<double>(*integer);
  }
  if (value.index() == info.default_value.index() && is_in_range(info, value)) return value;
  throw InputError(info.name, json_of(given) + " is not " + info.range());
}

}  // namespace vandplan
