// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/report_options.h"

#include <algorithm>
#include <map>

#include "evaluation/options_json.h"

namespace vandplan::evaluation {
namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

Values comparable_values(const PlanOptions& options) {
  Values values = option_values(options);
  // Profiled runs are told of beside those whose time counts.
  const OptionValue* const profile = options.planner.find("profile");
  const bool is_profiled = profile != nullptr && *profile == OptionValue(true);
  if (options.budget.processor_time || (is_profiled && options.budget.threads == 1))
    values.push_back(processor_clock);
  std::erase_if(values, [](const auto& option) {
    return option.first == "region" || option.first == "profile";
  });
  return values;
}

}  // namespace

std::string comparable_options(const PlanOptions& options) {
  std::string text;
  for (const auto& [name, value] : comparable_values(options)) text += name + "=" + value + "\n";
  return text;
}

std::string comparable_options(const RunRecord& run) { return comparable_options(*run.options); }

ReportOptions options_of(const std::vector<RunRecord>& runs) {
  std::map<std::string, Values> of_planner;
  for (const RunRecord& run : runs) {
    if (of_planner.contains(run.planner)) continue;
    of_planner[run.planner] = comparable_values(*run.options);
  }
  std::vector<std::string> names;  // in order of appearance
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
