// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The table of the options that are no planner's own: one row an option.

#include <algorithm>
#include <array>
#include <utility>

#include "problem/option_text.h"

namespace vandplan {
namespace {

using problem::json_text;

template <typename Value>
struct Held {
  using Type = Value;
};
template <typename Value>
struct Held<std::optional<Value>> {
  using Type = Value;
};

/// Access to the field of `PlanOptions` at the end of a path of members.
template <auto... path>
struct Field {
  template <typename Options>
  static constexpr auto& in(Options& all) {
    return (all.*....*path);  // all.*first.*second
  }

  using Type = std::remove_cvref_t<decltype(in(std::declval<PlanOptions&>()))>;
  using Value = typename Held<Type>::Type;

  static std::string get(const PlanOptions& all) { return json_text(in(all)); }
  static void set(PlanOptions& all, std::string_view text) { problem::parse(text, in(all)); }
  static bool equal(const PlanOptions& a, const PlanOptions& b) { return in(a) == in(b); }
  static void copy(PlanOptions& to, const PlanOptions& from) { in(to) = in(from); }
  static std::optional<double> number(const PlanOptions& all) {
    if constexpr (problem::Word<Value>) {
      return std::nullopt;
    } else {
      const std::optional<Value> value = in(all);
      return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
    }
  }
};

/// A row for the field at the end of a path of members, which says what the field is.
template <auto... path>
constexpr CommonOption row(OptionPart part, CommonOption about) {
  using To = Field<path...>;
  about.part = part;
  if constexpr (problem::Word<typename To::Value>) {
    about.words = problem::words_of<typename To::Value>;
  }
  about.is_whole = std::is_integral_v<typename To::Value>;
  about.is_optional = !std::is_same_v<typename To::Type, typename To::Value>;
  about.get = To::get;
  about.set = To::set;
  about.number = To::number;
  about.equal = To::equal;
  about.copy = To::copy;
  return about;
}

template <auto field>
constexpr CommonOption budget_row(CommonOption about) {
  return row<&PlanOptions::budget, field>(OptionPart::budget, about);
}

template <auto field>
constexpr CommonOption price_row(CommonOption about) {
  about.needs = Capability::prices;
  return row<&PlanOptions::cost, field>(OptionPart::prices, about);
}

template <auto field>
constexpr CommonOption gears_row(CommonOption about) {
  return row<&PlanOptions::cost, field>(OptionPart::gears, about);
}

template <auto field>
constexpr CommonOption clearance_row(CommonOption about) {
  return row<&PlanOptions::clearance, field>(OptionPart::clearance, about);
}

constexpr std::array option_rows = {
    row<&PlanOptions::style>(
        OptionPart::style,
        {.name = "style",
         .summary = "prices and steering where none is set, the length's or a driver's",
         .needs = Capability::prices}),
    budget_row<&BudgetOptions::seed>({.name = "seed", .summary = "random seed", .most = 0x1p64}),
    budget_row<&BudgetOptions::time_limit>(
        {.name = "time_limit", .summary = "time limit, wall clock", .unit = "s"}),
    budget_row<&BudgetOptions::max_iterations>(
        {.name = "max_iterations", .summary = "iteration limit, repeats bit for bit"}),
    budget_row<&BudgetOptions::threads>({.name = "threads",
                                         .summary = "number of threads",
                                         .least = 1,
                                         .most = 256,
                                         .needs = Capability::threads}),
    budget_row<&BudgetOptions::target_gap>(
        {.name = "target_gap",
         .summary = "proven gap to the optimum that ends the run",
         .most = 1000,
         .needs = Capability::target_gap}),
    price_row<&CostOptions::forward_weight>(
        {.name = "forward_weight", .summary = "cost of a metre forward", .least = 1, .most = 1000}),
    price_row<&CostOptions::reverse_weight>({.name = "reverse_weight",
                                             .summary = "cost of a metre in reverse",
                                             .least = 1,
                                             .most = 1000}),
    price_row<&CostOptions::gear_change_cost>({.name = "gear_change_cost",
                                               .summary = "cost of one gear change",
                                               .unit = "m",
                                               .most = 10000}),
    price_row<&CostOptions::curvature_change_cost>({.name = "curvature_change_cost",
                                                    .summary = "cost of curvature changes",
                                                    .unit = "m per 1/m",
                                                    .most = 10000}),
    price_row<&CostOptions::clearance_weight>({.name = "clearance_weight",
                                               .summary = "extra cost of metres near obstacles",
                                               .most = 1000}),
    price_row<&CostOptions::clearance_distance>({.name = "clearance_distance",
                                                 .summary = "distance that counts as near",
                                                 .unit = "m",
                                                 .least = 0.01,
                                                 .most = 1000}),
    gears_row<&CostOptions::initial_gear>(
        {.name = "initial_gear", .summary = "gear before the start", .needs = Capability::prices}),
    gears_row<&CostOptions::gears>(
        {.name = "gears", .summary = "allowed gears", .needs = Capability::gears}),
    row<&PlanOptions::cost, &CostOptions::measure>(
        OptionPart::measure,
        {.name = "cost",
         .summary = "what is minimised, the cost by prices or the time of the fastest drive [s]",
         .needs = Capability::time}),
    clearance_row<&ClearanceOptions::margin>(
        {.name = "margin",
         .summary = "least distance from obstacles, of wheels from kerbs",
         .unit = "m",
         .most = 1000}),
    clearance_row<&ClearanceOptions::margin_ramp>(
        {.name = "margin_ramp",
         .summary = "distance in which a tight start or goal reaches the margin",
         .unit = "m",
         .most = 1000}),
    row<&PlanOptions::steering>(
        OptionPart::steering,
        {.name = "steering", .summary = "where curvature may jump", .needs = Capability::steering}),
};

/// What a number must be: "a whole number from 1 to 256", "a number >= 0 [s]".
std::string rule_of(const CommonOption& option) {
  std::string rule = option.is_whole ? "a whole number" : "a number";
  rule += option.most < CommonOption::no_limit ? " from " : " ";
  rule += problem::range_of(option.least, option.most, option.is_whole);
  if (!option.unit.empty()) rule += " [" + std::string(option.unit) + "]";
  return rule;
}

}  // namespace

std::string CommonOption::range() const {
  if (!words.empty()) return problem::either(words);
  const std::string numbers = problem::range_of(least, most, is_whole);
  // A price without a value is that of the style; a limit without one is none.
  return is_optional && part == OptionPart::budget ? numbers + " or null" : numbers;
}

std::string CommonOption::text() const {
  std::string all(summary);
  if (!unit.empty()) all += " [" + std::string(unit) + "]";
  return all + "; " + range();
}

std::span<const CommonOption> style_and_common_options() noexcept { return option_rows; }

std::span<const CommonOption> common_options() noexcept {
  return std::span(option_rows).subspan(1);
}

const CommonOption* find_common_option(std::string_view name) noexcept {
  const auto* const found =
      std::find_if(option_rows.begin(), option_rows.end(),
                   [&](const CommonOption& option) { return option.name == name; });
  return found == option_rows.end() ? nullptr : found;
}

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

void validate(const PlanOptions& options) {
  for (const CommonOption& option : common_options()) {
    const std::optional<double> value = option.number(options);
    if (!value || (*value >= option.least && *value <= option.most)) continue;
    throw InputError(std::string(option.name), option.get(options) + " is not " + rule_of(option));
  }
}

CostOptions filled(const CostOptions& cost, const CostOptions& others) {
  PlanOptions all{.cost = cost};
  const PlanOptions from{.cost = others};
  const PlanOptions unset;
  for (const CommonOption& option : common_options()) {
    if (option.part == OptionPart::prices && option.equal(all, unset)) option.copy(all, from);
  }
  return all.cost;
}

}  // namespace vandplan
