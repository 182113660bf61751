// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan planners: which planners are there, and what can be set?
#include "vandplan/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "commands.h"
#include "option_flags.h"

namespace vandplan::app {
namespace {

using Json = nlohmann::ordered_json;

Json json_of_option(const OptionInfo& info) {
  return {{"name", info.name},
          {"summary", info.summary},
          {"default", Json::parse(vandplan::json_of(info.default_value))},
          {"range", info.range()}};
}

Json json_of_planner(const Planner& planner) {
  const PlannerProperties& properties = planner.properties;
  Json json = {{"name", planner.name}, {"summary", planner.summary}};
  json["properties"] = {
      {"family", properties.family},         {"strategy", properties.strategy},
      {"estimate", properties.estimate},     {"search", properties.search},
      {"tries_goal", properties.tries_goal}, {"capabilities", names_of(properties.capabilities)},
      {"anytime", properties.anytime},       {"deterministic", properties.deterministic},
      {"groups", properties.groups}};
  for (const Capability capability : all_capabilities()) {  // as version 0.2.0 had them
    json["properties"]["honours_" + std::string(name_of(capability))] = planner.can(capability);
  }
  json["options"] = Json::array();
  for (const OptionInfo& info : planner.options) json["options"].push_back(json_of_option(info));
  json["common_options"] = Json::array();
  for (const CommonOption& option : style_and_common_options()) {
    if (honours(planner, option.name)) json["common_options"].push_back(option.name);
  }
  return json;
}

void print_list(bool as_json) {
  if (as_json) {
    Json list = Json::array();
    for (const Planner& planner : planners()) list.push_back(json_of_planner(planner));
    print({{"default", default_planner().name}, {"planners", list}});
    return;
  }
  std::size_t width = 0;
  for (const Planner& planner : planners()) width = std::max(width, planner.name.size());
  for (const Planner& planner : planners()) {
    const bool is_default = planner.name == default_planner().name;
    fmt::print("{:{}}  {}{}\n", planner.name, width, planner.summary,
               is_default ? " (the default)" : "");
  }
}

void print_one(const Planner& planner, bool as_json) {
  if (as_json) {
    print(json_of_planner(planner));
    return;
  }
  std::string common;
  for (const CommonOption& option : style_and_common_options()) {
    if (!honours(planner, option.name)) continue;
    common += (common.empty() ? "" : ", ") + std::string(option.name);
  }
  fmt::print("{}: {}\nOwn options (plan --set):\n{}Common options: {}\n", planner.name,
             planner.summary, help_on_options_of(planner), common);
}

struct PlannersArguments {
  std::string name;
  bool options = false;
  bool json = false;
};

}  // namespace

void add_planners(CLI::App& vandplan, int&) {
  CLI::App* const command =
      vandplan.add_subcommand("planners", "List planners, or the options of one.");
  const auto arguments = std::make_shared<PlannersArguments>();
  command->add_option("NAME", arguments->name, "Planner to describe");
  command->add_flag("--options", arguments->options, "List the options of all planners")
      ->excludes("NAME");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] {
    if (arguments->options) {
      fmt::print("{}", help_on_own_options());
    } else if (arguments->name.empty()) {
      print_list(arguments->json);
    } else {
      print_one(planner_named(arguments->name), arguments->json);
    }
  });
}

}  // namespace vandplan::app
