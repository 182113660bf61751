// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/estimate_options.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "sites/estimate.h"
#include "sites/way.h"

namespace vandplan::planning {
namespace {

constexpr std::string_view max_prefix = "max-";

/// Names of one estimate, or of two of which the larger counts.
struct Wanted {
  std::string_view first;
  std::string_view second = no_estimate;
};

/// Parses the name of an estimate. `names`: words of the planner's option "estimate".
std::optional<Wanted> parsed(std::string_view text, const std::vector<std::string>& names) {
  const auto is_estimate = [&](std::string_view name) {
    return std::ranges::find(names, name) != names.end();
  };
  if (is_estimate(text)) return Wanted{text};
  if (!text.starts_with(max_prefix)) return std::nullopt;
  const std::string_view both = text.substr(max_prefix.size());
  for (const std::string_view first : names) {
    if (!both.starts_with(first) || both.size() <= first.size()) continue;
    if (both[first.size()] != '-') continue;
    const std::string_view second = both.substr(first.size() + 1);
    if (is_estimate(second)) return Wanted{first, second};
  }
  return std::nullopt;
}

OptionInfo* find_option(Planner& planner, std::string_view name) {
  const auto found = std::ranges::find(planner.options, name, &OptionInfo::name);
  return found == planner.options.end() ? nullptr : &*found;
}

}  // namespace

Region region_of(const PlanOptions& options) {
  return options.planner.word("region") == "scene" ? Region::scene : Region::bounds;
}

std::vector<OptionInfo> estimate_options(std::string_view default_value,
                                         std::string_view max_with) {
  const auto names = search::goal_estimate_names();
  OptionInfo first{.name = std::string(estimate_key),
                   .summary = "cost-to-go estimate",
                   .default_value = std::string(default_value),
                   .words = {names.begin(), names.end()}};
  OptionInfo second = first;
  second.name = max_with_key;
  second.summary = "second estimate, the larger counts";
  second.default_value = std::string(max_with);
  second.words.insert(second.words.begin(), std::string(no_estimate));
  return {std::move(first), std::move(second)};
}

void name_estimate(Planner& planner) {
  const OptionInfo* const first = find_option(planner, estimate_key);
  if (first == nullptr) return;
  const auto word = [](const OptionInfo& info) {
    return std::get<std::string>(info.default_value);
  };
  const std::string second = word(*find_option(planner, max_with_key));
  planner.properties.search = planner.name;
  planner.properties.capabilities.add(Capability::site);
  planner.properties.estimate =
      second == no_estimate ? word(*first) : std::string(max_prefix) + word(*first) + "-" + second;
}

search::GoalEstimate estimate_named(std::string_view name, const PlanOptions& options,
                                    const Task& task) {
  if (name != search::site_estimate) {
    return search::make_goal_estimate(name, task, options.table.get());
  }
  sites::expect_serves(*options.site, task, options);
  return {.name = std::string(name),
          .length = [costs = sites::CostsToGoal(*options.site, task)](const LocalPose& from) {
            return costs.from(from);
          }};
}

search::GoalEstimate estimate_of(const PlanOptions& options, const Task& task) {
  const auto named = [&](const std::string& name) { return estimate_named(name, options, task); };
  const std::string& second = options.planner.word(max_with_key);
  search::GoalEstimate first = named(options.planner.word(estimate_key));
  return second == no_estimate ? first : search::max_of(std::move(first), named(second));
}

std::optional<Planner> with_estimate(Planner planner, std::string_view estimate) {
  OptionInfo* const first = find_option(planner, estimate_key);
  if (first == nullptr) return std::nullopt;
  const std::optional<Wanted> wanted = parsed(estimate, first->words);
  if (!wanted) return std::nullopt;
  first->default_value = std::string(wanted->first);
  find_option(planner, max_with_key)->default_value = std::string(wanted->second);
  planner.name += ":" + std::string(estimate);
  planner.properties.estimate = estimate;
  return planner;
}

}  // namespace vandplan::planning
