// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan planners: which planners are there?
#include "vandplan/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "commands.h"

namespace vandplan {
namespace {

void print_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const PlannerInfo& planner : planners()) {
    list.push_back({{"name", planner.name}, {"summary", planner.summary}});
  }
  print({{"default", default_planner().name}, {"planners", list}});
}

void print_text() {
  std::size_t width = 0;
  for (const PlannerInfo& planner : planners()) width = std::max(width, planner.name.size());
  for (const PlannerInfo& planner : planners()) {
    const bool is_default = planner.name == default_planner().name;
    fmt::print("{:{}}  {}{}\n", planner.name, width, planner.summary,
               is_default ? " (the default)" : "");
  }
}

}  // namespace

void add_planners(CLI::App& vandplan, int&) {
  CLI::App* const command = vandplan.add_subcommand("planners", "List every planner.");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print one JSON object instead of a table");
  command->callback([json] { *json ? print_json() : print_text(); });
}

}  // namespace vandplan
