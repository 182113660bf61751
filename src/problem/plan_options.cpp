// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/plan_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/text.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

template <typename Number>
std::string text_of(Number value) {
  return base::shortest_text(value);
}

std::string text_of(bool value) { return value ? "true" : "false"; }

template <typename Number>
std::string text_of(const std::optional<Number>& value) {
  return value ? text_of(*value) : "null";
}

std::string text_of(InitialGear gear) {
  constexpr std::array names = {"\"any\"", "\"forward\"", "\"reverse\""};
  return names[static_cast<std::size_t>(gear)];
}

std::string text_of(Region region) { return region == Region::bounds ? "\"bounds\"" : "\"scene\""; }

// The setter throws with an empty place; set_option adds the name of the option.
[[noreturn]] void reject(std::string_view value, std::string_view expected) {
  throw InputError("", "\"" + std::string(value) + "\" is not " + std::string(expected));
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

void parse(std::string_view value, Region& field) {
  if (value != "bounds" && value != "scene") reject(value, "bounds or scene");
  field = value == "bounds" ? Region::bounds : Region::scene;
}

void parse(std::string_view value, InitialGear& field) {
  constexpr std::array<std::string_view, 3> names = {"any", "forward", "reverse"};
  const auto name = std::find(names.begin(), names.end(), value);
  if (name == names.end()) reject(value, "any, forward or reverse");
  field = static_cast<InitialGear>(name - names.begin());
}

template <auto field>
constexpr OptionInfo option(std::string_view name, std::string_view summary) {
  return {name, summary, [](const PlanOptions& options) { return text_of(options.*field); },
          [](PlanOptions& options, std::string_view value) { parse(value, options.*field); }};
}

constexpr std::array option_infos = {
    option<&PlanOptions::seed>("seed", "of the random numbers; a whole number"),
    option<&PlanOptions::time_limit>("time_limit", "wall clock [s]; >= 0 or null"),
    option<&PlanOptions::max_iterations>("max_iterations", "reproduces bit for bit; >= 0 or null"),
    option<&PlanOptions::max_nodes>("max_nodes", "of the search tree; 1 to 10000000"),
    option<&PlanOptions::region>("region", "where samples are drawn; bounds or scene"),
    option<&PlanOptions::goal_bias>("goal_bias", "share of samples that are the goal; 0 to 1"),
    option<&PlanOptions::max_parents>("max_parents", "parents tried for one sample; >= 1"),
    option<&PlanOptions::try_goal>("try_goal",
                                   "RRT: try the goal from every new node; true or false"),
    option<&PlanOptions::reverse_weight>("reverse_weight", "cost of a metre in reverse; 1 to 1000"),
    option<&PlanOptions::gear_change_cost>("gear_change_cost",
                                           "cost of one gear change [m]; 0 to 10000"),
    option<&PlanOptions::initial_gear>("initial_gear",
                                       "driven before the start; any, forward or reverse"),
    option<&PlanOptions::threads>("threads", "that share the work; 1 to 256"),
    option<&PlanOptions::keep_tree>("keep_tree", "return the search tree as well; true or false"),
    option<&PlanOptions::profile>("profile", "measure where the time goes; true or false"),
};

void require(bool condition, std::string_view name, const std::string& value,
             const std::string& rule) {
  if (!condition) throw InputError(std::string(name), value + " is not " + rule);
}

}  // namespace

std::span<const OptionInfo> option_table() noexcept { return option_infos; }

void set_option(PlanOptions& options, std::string_view name, std::string_view value) {
  for (const OptionInfo& info : option_infos) {
    if (info.name == name) {
      try {
        info.set(options, value);
      } catch (const InputError& error) {
        throw InputError(std::string(name),
                         error.problem() + ", expected: " + std::string(info.summary));
      }
      return;
    }
  }
  throw InputError(std::string(name), "unknown option, expected one of " +
                                          base::joined(option_infos, &OptionInfo::name));
}

void validate(const PlanOptions& options) {
  const auto& [time, share] = std::pair{options.time_limit, options.goal_bias};
  require(!time || (std::isfinite(*time) && *time >= 0.0), "time_limit", text_of(time),
          "a number >= 0 [s]");
  require(!options.max_iterations || *options.max_iterations >= 0, "max_iterations",
          text_of(options.max_iterations), "a whole number >= 0");
  require(options.max_nodes >= 1 && options.max_nodes <= 10'000'000, "max_nodes",
          text_of(options.max_nodes), "a whole number from 1 to 10000000");
  require(share >= 0.0 && share <= 1.0, "goal_bias", text_of(share), "a number from 0 to 1");
  const double weight = options.reverse_weight;
  require(weight >= 1.0 && weight <= 1000.0, "reverse_weight", text_of(weight),
          "a number from 1 to 1000");
  const double change = options.gear_change_cost;
  require(change >= 0.0 && change <= 10000.0, "gear_change_cost", text_of(change),
          "a number from 0 to 10000 [m]");
  require(options.threads >= 1 && options.threads <= 256, "threads", text_of(options.threads),
          "a whole number from 1 to 256");
  require(options.max_parents >= 1, "max_parents", text_of(options.max_parents),
          "a whole number >= 1");
}

}  // namespace vandplan
