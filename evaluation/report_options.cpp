// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/report_options.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "evaluation/options_json.h"

namespace vandplan::evaluation {
namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

Values comparable_values(const PlanOptions& options) {
  Values values = option_values(options);
  // Profiled runs have wall-clock times, but belong to the report of runs with processor time.
  const OptionValue* const profile = options.planner.find("profile");
  const bool is_profiled = profile != nullptr && *profile == OptionValue(true);
  if (options.budget.processor_time || (is_profiled && options.budget.threads == 1))
    values.push_back(processor_clock);
  std::erase_if(values, [](const auto& option) {
    return option.first == "region" || option.first == "profile";
  });
  return values;
}

/// The value, or one text with all values if vehicles have different ones.
std::string joined_values(const std::vector<std::string>& values) {
  if (values.size() == 1) return values.front();
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i == 0 ? "" : i + 1 == values.size() ? " or " : ", ") + values[i];
  std::erase(text, '"');
  return "\"" + text + ", by the vehicle\"";
}

std::map<std::string, Values> values_by_planner(const std::vector<RunRecord>& runs) {
  using Found = std::vector<std::pair<std::string, std::vector<std::string>>>;
  std::map<std::string, Found> found;
  std::set<const void*> seen;
  for (const RunRecord& run : runs) {
    if (!seen.insert(run.options.identity()).second) continue;
    Found& all = found[run.planner];
    for (const auto& [name, value] : comparable_values(*run.options)) {
      auto option = std::ranges::find(all, name, &Found::value_type::first);
      if (option == all.end()) option = all.insert(all.end(), {name, {}});
      if (std::ranges::find(option->second, value) == option->second.end())
        option->second.push_back(value);
    }
  }
  std::map<std::string, Values> joined;
  for (const auto& [planner, options] : found) {
    for (const auto& [name, values] : options)
      joined[planner].emplace_back(name, joined_values(values));
  }
  return joined;
}

}  // namespace

ComparableOptions comparable_options(const PlanOptions& options) {
  constexpr std::array by_vehicle = {"gear_change_cost", "curvature_change_cost",
                                     "clearance_distance", "steering"};
  ComparableOptions text;
  for (const auto& [name, value] : comparable_values(options)) {
    const bool is_by_vehicle = std::ranges::find(by_vehicle, name) != by_vehicle.end();
    (is_by_vehicle ? text.of_vehicle : text.of_planner) += name + "=" + value + "\n";
  }
  return text;
}

ReportOptions options_of(const std::vector<RunRecord>& runs) {
  const std::map<std::string, Values> of_planner = values_by_planner(runs);
  std::vector<std::string> names;  // names of options, in order of appearance
  std::map<std::string, std::map<std::string, std::vector<std::string>>> planners;
  for (const auto& [planner, values] : of_planner) {
    for (const auto& [name, value] : values) {
      if (!planners.contains(name)) names.push_back(name);
      planners[name][value].push_back(planner);
    }
  }
  ReportOptions options;
  for (const std::string& name : names) {
    const auto& values = planners.at(name);
    if (values.size() == 1) {
      options.shared.emplace_back(name, values.begin()->first);
      continue;
    }
    for (const auto& [value, which] : values) options.differing.push_back({name, value, which});
  }
  return options;
}

}  // namespace vandplan::evaluation
