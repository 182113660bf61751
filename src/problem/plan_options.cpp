// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/plan_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "base/text.h"
#include "vandplan/input_error.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

constexpr std::array<std::string_view, 3> gear_names = {"any", "forward", "reverse"};
constexpr std::array<std::string_view, 3> allowed_names = {"both", "forward", "reverse"};
constexpr std::array<std::string_view, 2> measure_names = {"prices", "time"};
constexpr std::array<std::string_view, 2> style_names = {"shortest", "driver"};
constexpr std::array<std::string_view, 3> steering_names = {
    "reeds-shepp", "continuous-between-stops", "continuous"};

/// The enumerator with that name; none if no name matches. `names` has the enum's order.
template <typename Value, std::size_t size>
std::optional<Value> value_named(const std::array<std::string_view, size>& names,
                                 std::string_view name) {
  const auto* const found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Value>(found - names.begin());
}

template <typename Number>
std::string text_of(Number value) {
  return base::shortest_text(value);
}

std::string text_of(bool value) { return value ? "true" : "false"; }

std::string text_of(const std::string& value) { return "\"" + value + "\""; }

std::string text_of(Steering steering) { return text_of(std::string(name_of(steering))); }

template <typename Number>
std::string text_of(const std::optional<Number>& value) {
  return value ? text_of(*value) : "null";
}

std::string text_of(InitialGear gear) {
  return text_of(std::string(gear_names[static_cast<std::size_t>(gear)]));
}

std::string text_of(AllowedGears gears) { return text_of(std::string(name_of(gears))); }

std::string text_of(CostMeasure measure) {
  return text_of(std::string(measure_names[static_cast<std::size_t>(measure)]));
}

// Throws InputError with an empty key: the caller adds the name of the option.
[[noreturn]] void reject(std::string_view value, const std::string& expected) {
  throw InputError("", "\"" + std::string(value) + "\" is not " + expected);
}

template <typename Number>
void parse(std::string_view value, Number& field) {
  Number number{};
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool whole = error == std::errc() && end == value.data() + value.size();
  if (!whole) reject(value, std::is_integral_v<Number> ? "a whole number in range" : "a number");
  field = number;
}

template <typename Number>
void parse(std::string_view value, std::optional<Number>& field) {
  if (value == "null") {
    field.reset();
  } else {
    parse(value, field.emplace());
  }
}

void parse(std::string_view value, bool& field) {
  if (value != "true" && value != "false") reject(value, "true or false");
  field = value == "true";
}

void parse(std::string_view value, std::string& field) { field = value; }

void parse(std::string_view value, InitialGear& field) {
  const auto gear = value_named<InitialGear>(gear_names, value);
  if (!gear) reject(value, "any, forward or reverse");
  field = *gear;
}

void parse(std::string_view value, AllowedGears& field) { field = gears_named(value); }

void parse(std::string_view value, CostMeasure& field) {
  const auto measure = value_named<CostMeasure>(measure_names, value);
  if (!measure) reject(value, "prices or time");
  field = *measure;
}

void parse(std::string_view value, std::optional<Steering>& field) {
  field = value == "null" ? std::nullopt : std::optional(steering_named(value));
}

template <auto part, auto field>
constexpr CommonOption option(std::string_view name, std::string_view summary) {
  return {name, summary, [](const PlanOptions& o) { return text_of(o.*part.*field); },
          [](PlanOptions& o, std::string_view value) { parse(value, o.*part.*field); }};
}

template <auto field>
constexpr CommonOption budget(std::string_view name, std::string_view summary) {
  CommonOption of_budget = option<&PlanOptions::budget, field>(name, summary);
  of_budget.is_of_budget = true;
  return of_budget;
}

template <auto field>
constexpr CommonOption cost(std::string_view name, std::string_view summary) {
  return option<&PlanOptions::cost, field>(name, summary);
}

template <auto field>
constexpr CommonOption clearance(std::string_view name, std::string_view summary) {
  return option<&PlanOptions::clearance, field>(name, summary);
}

constexpr CommonOption steering_option = {
    "steering", "where curvature may jump; reeds-shepp, continuous-between-stops or continuous",
    [](const PlanOptions& o) { return text_of(o.steering); },
    [](PlanOptions& o, std::string_view value) { parse(value, o.steering); }};

constexpr std::array options_of_all = {
    budget<&BudgetOptions::seed>("seed", "random seed; 0 to 18446744073709551615"),
    budget<&BudgetOptions::time_limit>("time_limit", "time limit, wall clock [s]; >= 0 or null"),
    budget<&BudgetOptions::max_iterations>("max_iterations",
                                           "iteration limit, repeats bit for bit; >= 0 or null"),
    budget<&BudgetOptions::threads>("threads", "number of threads; 1 to 256"),
    budget<&BudgetOptions::target_gap>(
        "target_gap", "proven gap to the optimum that ends the run; 0 to 1000 or null"),
    cost<&CostOptions::forward_weight>("forward_weight", "cost of a metre forward; 1 to 1000"),
    cost<&CostOptions::reverse_weight>("reverse_weight", "cost of a metre in reverse; 1 to 1000"),
    cost<&CostOptions::gear_change_cost>("gear_change_cost",
                                         "cost of one gear change [m]; 0 to 10000"),
    cost<&CostOptions::curvature_change_cost>("curvature_change_cost",
                                              "cost of curvature changes [m per 1/m]; 0 to 10000"),
    cost<&CostOptions::clearance_weight>("clearance_weight",
                                         "extra cost of metres near obstacles; 0 to 1000"),
    cost<&CostOptions::clearance_distance>("clearance_distance",
                                           "distance that counts as near [m]; 0.01 to 1000"),
    cost<&CostOptions::initial_gear>("initial_gear",
                                     "gear before the start; any, forward or reverse"),
    cost<&CostOptions::gears>("gears", "allowed gears; both, forward or reverse"),
    cost<&CostOptions::measure>("cost",
                                "what is minimised; prices, or time of the fastest drive [s]"),
    clearance<&ClearanceOptions::margin>(
        "margin", "least distance from obstacles, of wheels from kerbs [m]; 0 to 1000"),
    clearance<&ClearanceOptions::margin_ramp>(
        "margin_ramp", "distance in which a tight start or goal reaches the margin [m]; 0 to 1000"),
    steering_option,
};

void require(bool condition, std::string_view name, const std::string& value,
             const std::string& rule) {
  if (!condition) throw InputError(std::string(name), value + " is not " + rule);
}

struct Range {
  double least;
  double most;
};

void require_price(const std::optional<double>& price, std::string_view name, const Range& range,
                   const std::string& unit) {
  const auto& [least, most] = range;
  require(!price || (*price >= least && *price <= most), name, text_of(price),
          "a number from " + text_of(least) + " to " + text_of(most) + unit);
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

std::string OptionInfo::range() const {
  if (std::holds_alternative<bool>(default_value)) return "true or false";
  if (std::holds_alternative<std::int64_t>(default_value)) {
    return text_of(static_cast<std::int64_t>(least)) + " to " +
           text_of(static_cast<std::int64_t>(most));
  }
  if (std::holds_alternative<double>(default_value)) return text_of(least) + " to " + text_of(most);
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return text;
}

CostOptions filled(const CostOptions& cost, const CostOptions& others) {
  CostOptions all = cost;
  const auto fill = [&](auto price) {
    if (!(all.*price)) all.*price = others.*price;
  };
  fill(&CostOptions::forward_weight);
  fill(&CostOptions::reverse_weight);
  fill(&CostOptions::gear_change_cost);
  fill(&CostOptions::curvature_change_cost);
  fill(&CostOptions::clearance_weight);
  fill(&CostOptions::clearance_distance);
  return all;
}

bool is_length(const CostOptions& cost) {
  return cost.measure == CostMeasure::prices && cost.forward_weight == 1.0 &&
         cost.reverse_weight == 1.0 && cost.gear_change_cost == 0.0 &&
         cost.curvature_change_cost == 0.0 && cost.clearance_weight == 0.0;
}

std::string_view name_of(Steering steering) noexcept {
  return steering_names[static_cast<std::size_t>(steering)];
}

Steering steering_named(std::string_view name) {
  if (const auto found = value_named<Steering>(steering_names, name)) return *found;
  throw InputError("steering", "\"" + std::string(name) +
                                   "\" is not reeds-shepp, continuous-between-stops or continuous");
}

std::string_view name_of(AllowedGears gears) noexcept {
  return allowed_names[static_cast<std::size_t>(gears)];
}

AllowedGears gears_named(std::string_view name) {
  if (const auto found = value_named<AllowedGears>(allowed_names, name)) return *found;
  throw InputError("gears", "\"" + std::string(name) + "\" is not both, forward or reverse");
}

std::string_view name_of(Style style) noexcept {
  return style_names[static_cast<std::size_t>(style)];
}

Style style_named(std::string_view name) {
  if (const auto found = value_named<Style>(style_names, name)) return *found;
  throw InputError("style", "\"" + std::string(name) + "\" is not driver or shortest");
}

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

std::span<const CommonOption> common_options() noexcept { return options_of_all; }

std::vector<Setting> settings_of(const PlanOptions& options) {
  std::vector<Setting> settings;
  const auto add = [&](std::string_view name, std::string json) {
    if (json == "null") return;  // an option that is not set
    std::erase(json, '"');
    settings.push_back({std::string(name), std::move(json)});
  };
  for (const CommonOption& common : common_options()) add(common.name, common.get(options));
  for (const auto& [name, value] : options.planner.values()) add(name, json_of(value));
  return settings;
}

std::string json_of(const OptionValue& value) {
  return std::visit([](const auto& held) { return text_of(held); }, value);
}

OptionValue parsed_value(const OptionInfo& info, std::string_view text) {
  OptionValue value = info.default_value;
  try {
    std::visit([&](auto& held) { parse(text, held); }, value);
    if (!is_in_range(info, value)) reject(text, info.range());
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
  require(value.index() == info.default_value.index() && is_in_range(info, value), info.name,
          json_of(given), info.range());
  return value;
}

void validate(const PlanOptions& options) {
  const auto& [time, iterations, seed, threads, gap, stop, by_processor] = options.budget;
  require(!time || (std::isfinite(*time) && *time >= 0.0), "time_limit", text_of(time),
          "a number >= 0 [s]");
  require(!iterations || *iterations >= 0, "max_iterations", text_of(iterations),
          "a whole number >= 0");
  require(threads >= 1 && threads <= 256, "threads", text_of(threads),
          "a whole number from 1 to 256");
  require(!gap || (*gap >= 0.0 && *gap <= 1000.0), "target_gap", text_of(gap),
          "a number from 0 to 1000");
  const CostOptions& cost = options.cost;
  require_price(cost.forward_weight, "forward_weight", {1.0, 1000.0}, "");
  require_price(cost.reverse_weight, "reverse_weight", {1.0, 1000.0}, "");
  require_price(cost.gear_change_cost, "gear_change_cost", {0.0, 10000.0}, " [m]");
  require_price(cost.curvature_change_cost, "curvature_change_cost", {0.0, 10000.0},
                " [m per 1/m]");
  require_price(cost.clearance_weight, "clearance_weight", {0.0, 1000.0}, "");
  require_price(cost.clearance_distance, "clearance_distance", {0.01, 1000.0}, " [m]");
  const auto& [margin, ramp] = options.clearance;
  require(margin >= 0.0 && margin <= 1000.0, "margin", text_of(margin),
          "a number from 0 to 1000 [m]");
  require(ramp >= 0.0 && ramp <= 1000.0, "margin_ramp", text_of(ramp),
          "a number from 0 to 1000 [m]");
}

}  // namespace vandplan
