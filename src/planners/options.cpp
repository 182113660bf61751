// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/options.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "base/nearest_word.h"
#include "planners/registered.h"
#include "vandplan/graphs.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

constexpr std::string_view primitives_key = "primitives";

/// An option that is a file and no text, and what `set_option` says of it.
struct FileOption {
  std::string_view name;
  const char* said;
};

constexpr std::array of_files = {
    FileOption{planning::table_key, "is a table and no text, expected --table FILE"},
    FileOption{primitives_key, "are a file and no text, expected --primitives FILE"},
    FileOption{planning::site_key, "is a table and no text, expected --site FILE.vst"}};

const OptionInfo* own_option(const Planner& planner, std::string_view name) {
  const auto found = std::ranges::find(planner.options, name, &OptionInfo::name);
  return found == planner.options.end() ? nullptr : &*found;
}

bool is_honoured(const Planner& planner, const CommonOption& option) {
  return !option.needs || planner.can(*option.needs);
}

/// Whether every planner does what the option says: it is not set, or asks for planning by length,
/// or for arcs and lines.
bool has_no_effect(const CommonOption& option, const PlanOptions& options) {
  const PlanOptions unset;
  const PlanOptions by_length{
      .style = Style::shortest, .cost = shortest_style, .steering = Steering::reeds_shepp};
  return option.equal(options, unset) || option.equal(options, by_length);
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

/// Names of the planners that can do that.
std::string planners_with(Capability capability) {
  return planners_that([=](const Planner& planner) { return planner.can(capability); });
}

/// End of a message that refuses gears which are asked for.
std::string ignored_gears(const Planner& planner) {
  return ", which " + planner.name + " does not honour, expected one of the planners that do: " +
         planners_with(Capability::gears);
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
  for (const CommonOption& common : style_and_common_options()) {
    if (is_honoured(planner, common)) names.emplace_back(common.name);
  }
  for (const OptionInfo& info : planner.options) names.push_back(info.name);
  throw InputError(std::string(option), "unknown option, " + base::expected_one_of(option, names));
}

/// Throws InputError for an option that has an effect which the planner ignores.
void refuse_ignored(const Planner& planner, const PlanOptions& options) {
  for (const CommonOption& common : style_and_common_options()) {
    if (is_honoured(planner, common) || has_no_effect(common, options)) continue;
    refuse(planner, common.name);
  }
  for (const auto& [name, value] : options.planner.values()) {
    if (own_option(planner, name) == nullptr) refuse(planner, name);
  }
  if (options.table && !honours(planner, planning::table_key)) refuse(planner, planning::table_key);
  if (options.primitives && !honours(planner, primitives_key)) refuse(planner, primitives_key);
  if (options.site && !honours(planner, planning::site_key)) refuse(planner, planning::site_key);
}

/// Throws InputError for a price that is set, unless to a value without effect.
void refuse_prices(const PlanOptions& options) {
  for (const CommonOption& common : common_options()) {
    if (common.part != OptionPart::prices || has_no_effect(common, options)) continue;
    throw InputError(std::string(common.name), "is a price, expected none beside cost=time");
  }
}

/// Replaces the style by its prices and its steering.
void settle_style(const Planner& planner, const Vehicle& vehicle, PlanOptions& all) {
  const Style style = planner.can(Capability::prices) ? all.style.value_or(planner.properties.style)
                                                      : Style::shortest;
  all.style.reset();
  const bool is_time = all.cost.measure == CostMeasure::time;
  if (is_time) refuse_prices(all);
  all.cost = filled(all.cost, is_time ? shortest_style : prices_of(style, vehicle));
  if (!planner.can(Capability::steering)) all.steering = Steering::reeds_shepp;
  if (all.steering) return;
  const bool is_shortest = style == Style::shortest || is_length(all.cost);
  const Steering usual = is_shortest ? Steering::reeds_shepp : Steering::continuous_between_stops;
  all.steering = planner.properties.steering.value_or(usual);
}

/// The tree of that name that the estimate "site" guides; none if there is none.
std::optional<Planner> tree_with_site(std::string_view name) {
  static const std::vector<Planner> all = planning::laboratory_of_sites();
  const auto found = std::ranges::find(all, name, &Planner::name);
  return found == all.end() ? std::nullopt : std::optional(*found);
}

/// Throws InputError if a table is missing, or is given but not used.
void settle_tables(const Planner& planner, const PlanOptions& all) {
  const bool takes_table = asks_for_estimate(planner, all, search::user_table);
  if (takes_table && !all.table) {
    throw InputError(std::string(planning::estimate_key), "table needs a table, and there is none");
  }
  if (!takes_table && all.table) {
    throw InputError(std::string(planning::table_key), "is for estimate=table or max_with=table");
  }
  const bool takes_site = asks_for_estimate(planner, all, search::site_estimate);
  if (takes_site && !all.site) {
    throw InputError(std::string(planning::site_key),
                     "the estimate needs a table of the site, expected --site FILE.vst, site=TABLE "
                     "in Python, PlanOptions::site in C++");
  }
  if (!takes_site && all.site && own_option(planner, planning::estimate_key) != nullptr) {
    throw InputError(std::string(planning::site_key), "is for estimate=site or max_with=site");
  }
}

}  // namespace

namespace planning {

void refuse_moving(const Planner& planner) {
  throw InputError("moving", "is not honoured by " + planner.name +
                                 ", expected one of the planners that honour it: " +
                                 planners_with(Capability::moving));
}

void expect_gears_in_zones(const Planner& planner, std::span<const Zone> zones) {
  const bool ask = std::ranges::any_of(
      zones, [](const Zone& zone) { return zone.direction || zone.gears != AllowedGears::both; });
  if (!ask || planner.can(Capability::gears)) return;
  throw InputError("zones", "ask for gears or directions" + ignored_gears(planner));
}

void unset_prices(PlanOptions& options) {
  const PlanOptions unset;
  for (const CommonOption& common : common_options()) {
    if (common.part == OptionPart::prices) common.copy(options, unset);
  }
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
  if (found == planners().end()) return tree_with_site(name);
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
  if (option == planning::table_key) return own_option(planner, planning::estimate_key) != nullptr;
  if (option == primitives_key) return planner.can(Capability::primitives);
  if (option == planning::site_key) return planner.can(Capability::site);
  const CommonOption* const common = find_common_option(option);
  return common != nullptr && is_honoured(planner, *common);
}

bool asks_for_estimate(const Planner& planner, const PlanOptions& options, std::string_view name) {
  if (own_option(planner, planning::estimate_key) == nullptr) {
    return planner.properties.estimate == name;
  }
  return std::ranges::any_of(
      std::array{planning::estimate_key, planning::max_with_key}, [&](std::string_view key) {
        const OptionInfo* const info = own_option(planner, key);
        if (info == nullptr) return false;
        const OptionValue* const given = options.planner.find(key);
        const auto* const word =
            std::get_if<std::string>(given != nullptr ? given : &info->default_value);
        return word != nullptr && *word == name;
      });
}

void set_option(PlanOptions& options, const Planner& planner, std::string_view name,
                std::string_view text) {
  for (const auto& [file, said] : of_files) {
    if (name == file && honours(planner, name)) throw InputError(std::string(name), said);
  }
  if (const OptionInfo* const own = own_option(planner, name)) {
    options.planner.set(name, parsed_value(*own, text));
    return;
  }
  const CommonOption* const common = find_common_option(name);
  if (common == nullptr) refuse(planner, name);
  PlanOptions changed = options;
  try {
    common->set(changed, text);
  } catch (const InputError& error) {
    throw InputError(std::string(name), error.problem() + ", expected: " + common->text());
  }
  if (!is_honoured(planner, *common) && !has_no_effect(*common, changed)) refuse(planner, name);
  const bool is_style = common->part == OptionPart::style;
  if (is_style) {
    changed.cost.measure = CostMeasure::prices;
    changed.steering.reset();
  }
  if (is_style || changed.cost.measure != options.cost.measure) planning::unset_prices(changed);
  validate(changed);
  options = changed;
}

int setting_order(std::string_view option) noexcept {
  const CommonOption* const common = find_common_option(option);
  if (common == nullptr) return 2;
  return common->part == OptionPart::style ? 0 : common->part == OptionPart::measure ? 1 : 2;
}

void set_honoured(PlanOptions& options, const Planner& planner, std::span<const Setting> settings) {
  for (const auto& [name, value] : settings) {
    if (name != "gears" || value == name_of(AllowedGears::both) || honours(planner, name)) continue;
    throw InputError(name, "is " + value + ignored_gears(planner));
  }
  std::vector<Setting> honoured;
  std::copy_if(settings.begin(), settings.end(), std::back_inserter(honoured),
               [&](const Setting& setting) { return honours(planner, setting.name); });
  std::stable_sort(honoured.begin(), honoured.end(), [](const Setting& a, const Setting& b) {
    return setting_order(a.name) < setting_order(b.name);
  });
  for (const auto& [name, value] : honoured) set_option(options, planner, name, value);
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
  settle_tables(planner, all);
  if (!all.budget.time_limit && !all.budget.max_iterations) {
    all.budget.time_limit = default_time_limit;
  }
  if (!vehicle.trailer) return all;
  if (!planner.can(Capability::trailers)) {
    throw InputError("planner", planner.name +
                                    " plans for a vehicle without a trailer, expected one of those "
                                    "that know trailers: " +
                                    planners_with(Capability::trailers));
  }
  const bool is_time = options.cost.measure == CostMeasure::time;
  const Steering usual = is_time ? *all.steering : Steering::reeds_shepp;
  const Steering steering = options.steering.value_or(usual);
  if (steering != Steering::reeds_shepp && !planner.can(Capability::steering_of_rigs)) {
    throw InputError("steering",
                     "is " + std::string(name_of(steering)) +
                         ", expected reeds-shepp for a vehicle with a trailer, or a planner that "
                         "steers it so: " +
                         planners_with(Capability::steering_of_rigs));
  }
  all.steering = steering;
  return all;
}

}  // namespace vandplan
