// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/options.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/nearest_word.h"
#include "planners/registered.h"
#include "planners/shared_options.h"
#include "vandplan/goal_estimate.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

constexpr std::string_view style_key = "style";
constexpr std::string_view steering_key = "steering";
constexpr std::string_view cost_key = "cost";
constexpr std::string_view gears_key = "gears";
constexpr std::string_view primitives_key = "primitives";

const OptionInfo* own_option(const Planner& planner, std::string_view name) {
  const auto found = std::ranges::find(planner.options, name, &OptionInfo::name);
  return found == planner.options.end() ? nullptr : &*found;
}

const CommonOption* common_option(std::string_view name) {
  const auto found = std::ranges::find(common_options(), name, &CommonOption::name);
  return found == common_options().end() ? nullptr : &*found;
}

bool is_price(std::string_view option) {
  return option == "forward_weight" || option == "reverse_weight" || option == "gear_change_cost" ||
         option == "curvature_change_cost" || option == "clearance_weight" ||
         option == "clearance_distance";
}

/// Names of the planners for which `does` is true, with commas between them. A large family has one
/// name if `does` is true for all its planners: "rrt-... (28)".
template <typename Predicate>
std::string planners_that(const Predicate& does) {
  constexpr std::ptrdiff_t many = 4;
  std::vector<std::string> names;
  for (const Planner& planner : planners()) {
    if (!does(planner)) continue;
    const std::string& family = planner.properties.family;
    const auto is_of_family = [&](const Planner& p) { return p.properties.family == family; };
    const std::ptrdiff_t members =
        std::count_if(planners().begin(), planners().end(), is_of_family);
    const bool is_whole = std::ranges::all_of(
        planners(), [&](const Planner& p) { return !is_of_family(p) || does(p); });
    std::string name = planner.name;
    if (members >= many && is_whole) name = family + "-... (" + std::to_string(members) + ")";
    if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  return base::joined(names);
}

[[noreturn]] void refuse(const Planner& planner, std::string_view option) {
  const std::string others =
      planners_that([&](const Planner& other) { return honours(other, option); });
  if (!others.empty()) {
    throw InputError(std::string(option),
                     "is no option of " + planner.name +
                         ", expected one of the planners that honour it: " + others);
  }
  constexpr std::array<std::string_view, 15> of_vehicles = {
      "wheelbase",          "front_overhang",
      "rear_overhang",      "width",
      "min_turning_radius", "max_steering_angle",
      "track_width",        "max_steering_rate",
      "max_curvature_rate", "max_speed",
      "max_acceleration",   "max_braking",
      "max_jerk",           "hitch",
      "max_hitch_angle"};
  if (std::ranges::find(of_vehicles, option) != of_vehicles.end()) {
    throw InputError(
        std::string(option),
        "is no option but a value of the vehicle, expected it there: \"vehicle\" of the "
        "scenario");
  }
  std::vector<std::string> names;
  if (honours(planner, style_key)) names.emplace_back(style_key);
  for (const CommonOption& common : common_options()) {
    if (honours(planner, common.name)) names.emplace_back(common.name);
  }
  for (const OptionInfo& info : planner.options) names.push_back(info.name);
  throw InputError(std::string(option), "unknown option, " + base::expected_one_of(option, names));
}

/// Throws InputError for an option that is set but ignored by the planner. Options that ask for
/// planning by length, or for arcs and lines, are allowed.
void refuse_ignored(const Planner& planner, const PlanOptions& options) {
  const PlanOptions unset;
  const PlanOptions known{.cost = shortest_style, .steering = Steering::reeds_shepp};
  if (options.style == Style::driver && !honours(planner, style_key)) refuse(planner, style_key);
  for (const CommonOption& common : common_options()) {
    if (honours(planner, common.name)) continue;
    const std::string value = common.get(options);
    if (value != common.get(unset) && value != common.get(known)) refuse(planner, common.name);
  }
  for (const auto& [name, value] : options.planner.values()) {
    if (own_option(planner, name) == nullptr) refuse(planner, name);
  }
  if (options.table && !honours(planner, planning::table_key)) refuse(planner, planning::table_key);
  if (options.primitives && !honours(planner, primitives_key)) refuse(planner, primitives_key);
}

/// Throws InputError for a price that is set, unless to a value without effect.
void refuse_prices(const PlanOptions& options) {
  const PlanOptions unset;
  const PlanOptions neutral{.cost = shortest_style};
  for (const CommonOption& common : common_options()) {
    if (!is_price(common.name)) continue;
    const std::string value = common.get(options);
    if (value == common.get(unset) || value == common.get(neutral)) continue;
    throw InputError(std::string(common.name), "is a price, and the cost is the time");
  }
}

/// Replaces the style by its prices and its steering.
void settle_style(const Planner& planner, const Vehicle& vehicle, PlanOptions& all) {
  const Style style = planner.properties.honours_prices
                          ? all.style.value_or(planner.properties.style)
                          : Style::shortest;
  all.style.reset();
  const bool is_time = all.cost.measure == CostMeasure::time;
  if (is_time) refuse_prices(all);
  all.cost = filled(all.cost, is_time ? shortest_style : prices_of(style, vehicle));
  if (!planner.properties.honours_steering) all.steering = Steering::reeds_shepp;
  if (all.steering) return;
  const bool is_shortest = style == Style::shortest || is_length(all.cost);
  const Steering usual = is_shortest ? Steering::reeds_shepp : Steering::continuous_between_stops;
  all.steering = planner.properties.steering.value_or(usual);
}

/// Throws InputError if a table is missing, or is given but not used.
void settle_table(const Planner& planner, const PlanOptions& all) {
  const bool is_asked = asks_for_table(planner, all);
  if (is_asked && !all.table) {
    throw InputError(std::string(planning::estimate_key), "table needs a table, and there is none");
  }
  if (!is_asked && all.table) {
    throw InputError(std::string(planning::table_key), "is for estimate=table or max_with=table");
  }
}

/// Sets the style, and unsets prices and steering. A planner without prices takes only the
/// shortest.
void set_style(PlanOptions& options, const Planner& planner, std::string_view name) {
  const Style style = style_named(name);
  if (style != Style::shortest && !honours(planner, style_key)) refuse(planner, style_key);
  options.style = style;
  options.cost = {.initial_gear = options.cost.initial_gear, .gears = options.cost.gears};
  options.steering.reset();
}

}  // namespace

namespace planning {

void refuse_moving(const Planner& planner) {
  const std::string others =
      planners_that([](const Planner& other) { return other.properties.honours_moving; });
  throw InputError("moving", "is not honoured by " + planner.name +
                                 ", expected one of the planners that honour it: " + others);
}

}  // namespace planning

std::span<const Planner> planners() {
  static const std::vector<Planner> all = planning::registered_planners();
  return all;
}

const Planner& default_planner() { return planners().front(); }

std::optional<Planner> find_planner(std::string_view name) {
  const std::size_t colon = std::min(name.find(':'), name.size());
  const auto found = std::ranges::find(planners(), name.substr(0, colon), &Planner::name);
  if (found == planners().end()) return std::nullopt;
  if (colon == name.size()) return *found;
  return planning::with_estimate(*found, name.substr(colon + 1));
}

Planner planner_named(std::string_view name) {
  if (std::optional<Planner> found = find_planner(name)) return *std::move(found);
  if (const std::size_t colon = name.find(':'); colon != std::string_view::npos) {
    const std::optional<Planner> search = find_planner(name.substr(0, colon));
    if (search && honours(*search, planning::estimate_key)) {
      throw InputError("planner", "\"" + std::string(name.substr(colon + 1)) +
                                      "\" is no estimate, expected max-A-B or one of " +
                                      base::joined(search::goal_estimate_names()));
    }
  }
  std::vector<std::string_view> names;
  for (const Planner& planner : planners()) names.emplace_back(planner.name);
  const std::string_view meant = base::nearest_word(name, names);
  throw InputError(
      "planner",
      "\"" + std::string(name) + "\" is unknown, " +
          (meant.empty() ? "expected" : "did you mean " + std::string(meant) + "? Expected") +
          " one of " + planners_that([](const Planner&) { return true; }));
}

bool honours(const Planner& planner, std::string_view option) {
  if (own_option(planner, option) != nullptr) return true;
  if (option == style_key) return planner.properties.honours_prices;
  if (option == planning::table_key) return own_option(planner, planning::estimate_key) != nullptr;
  if (option == primitives_key) return planner.properties.honours_primitives;
  if (common_option(option) == nullptr) return false;
  if (option == cost_key) return planner.properties.honours_time;
  if (option == "threads") return planner.properties.honours_threads;
  if (option == "target_gap") return planner.properties.honours_target_gap;
  if (option == steering_key) return planner.properties.honours_steering;
  if (option == gears_key) return planner.properties.honours_gears;
  return !(is_price(option) || option == "initial_gear") || planner.properties.honours_prices;
}

bool asks_for_table(const Planner& planner, const PlanOptions& options) {
  return std::ranges::any_of(
      std::array{planning::estimate_key, planning::max_with_key}, [&](std::string_view key) {
        const OptionInfo* const info = own_option(planner, key);
        if (info == nullptr) return false;
        const OptionValue* const given = options.planner.find(key);
        const auto* const word =
            std::get_if<std::string>(given != nullptr ? given : &info->default_value);
        return word != nullptr && *word == search::user_table;
      });
}

void set_option(PlanOptions& options, const Planner& planner, std::string_view name,
                std::string_view text) {
  if (name == planning::table_key && honours(planner, name)) {
    throw InputError(std::string(name), "is a table and no text, expected --table FILE");
  }
  if (name == primitives_key && honours(planner, name)) {
    throw InputError(std::string(name), "are a file and no text, expected --primitives FILE");
  }
  if (name == style_key) {
    set_style(options, planner, text);
    return;
  }
  const bool is_usual = (name == steering_key && text == name_of(Steering::reeds_shepp)) ||
                        (name == gears_key && text == name_of(AllowedGears::both));
  if (!honours(planner, name) && !is_usual) refuse(planner, name);
  if (const OptionInfo* const own = own_option(planner, name)) {
    options.planner.set(name, parsed_value(*own, text));
    return;
  }
  const CommonOption& common = *common_option(name);
  PlanOptions changed = options;
  try {
    common.set(changed, text);
  } catch (const InputError& error) {
    throw InputError(std::string(name),
                     error.problem() + ", expected: " + std::string(common.summary));
  }
  if (changed.cost.measure != options.cost.measure) {
    changed.cost = {.initial_gear = changed.cost.initial_gear,
                    .measure = changed.cost.measure,
                    .gears = changed.cost.gears};
  }
  validate(changed);
  options = changed;
}

bool is_set_first(std::string_view option) noexcept {
  return option == style_key || option == cost_key;
}

void set_honoured(PlanOptions& options, const Planner& planner, std::span<const Setting> settings) {
  for (const bool is_first : {true, false}) {
    for (const auto& [name, value] : settings) {
      if (is_set_first(name) == is_first && honours(planner, name)) {
        set_option(options, planner, name, value);
      }
    }
  }
}

PlanOptions complete(const Planner& planner, const PlanOptions& options, const Vehicle& vehicle) {
  validate(options);
  refuse_ignored(planner, options);
  PlanOptions all = options;
  for (const OptionInfo& info : planner.options) {
    const OptionValue* const given = options.planner.find(info.name);
    all.planner.set(info.name, given == nullptr ? info.default_value : fitting_value(info, *given));
  }
  settle_style(planner, vehicle, all);
  settle_table(planner, all);
  if (!all.budget.time_limit && !all.budget.max_iterations) {
    all.budget.time_limit = default_time_limit;
  }
  if (!vehicle.trailer) return all;
  if (!planner.properties.honours_trailers) {
    const std::string others =
        planners_that([](const Planner& other) { return other.properties.honours_trailers; });
    throw InputError("planner", planner.name +
                                    " plans for a vehicle without a trailer, expected one of those "
                                    "that know trailers: " +
                                    others);
  }
  const bool is_time = options.cost.measure == CostMeasure::time;
  const Steering usual = is_time ? *all.steering : Steering::reeds_shepp;
  const Steering steering = options.steering.value_or(usual);
  if (steering != Steering::reeds_shepp && !planner.properties.honours_steering_of_rigs) {
    const std::string others = planners_that(
        [](const Planner& other) { return other.properties.honours_steering_of_rigs; });
    throw InputError(std::string(steering_key),
                     "is " + std::string(name_of(steering)) +
                         ", expected reeds-shepp for a vehicle with a trailer, or a planner that "
                         "steers it so: " +
                         others);
  }
  all.steering = steering;
  return all;
}

}  // namespace vandplan
