// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan draw: what does a scenario or a result look like?
#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "pictures.h"

namespace vandplan {
namespace {

struct DrawArguments {
  std::string scenario;
  std::optional<std::string> result;
  std::string output;
  bool json = false;
};

void run(const DrawArguments& arguments) {
  expect_picture(arguments.output);
  const Scenario scenario = read_scenario(arguments.scenario);
  std::vector<ResultRecord> records;
  if (arguments.result) records = read_results(*arguments.result, scenario);
  write_picture(arguments.output, scenario, records);
  if (arguments.json) {
    print({{"scenario", scenario.name}, {"output", arguments.output}});
  } else {
    fmt::print("{}: drawn to {}\n", scenario.name, arguments.output);
  }
}

}  // namespace

void add_draw(CLI::App& vandplan, int&) {
  CLI::App* const command = vandplan.add_subcommand(
      "draw",
      "Draw a scenario: obstacles, start and goal. With a result also the footprints\n"
      "along its path, and its tree if it holds one (plan --set keep_tree=true).");
  const auto arguments = std::make_shared<DrawArguments>();
  command->add_option("SCENARIO", arguments->scenario, "Scenario file (YAML), - is standard input")
      ->required();
  command->add_option("RESULT", arguments->result, "Result file (JSON)");
  command->add_option("-o,--output", arguments->output, "Picture (.svg, .png or .pdf)")
      ->type_name("FILE")
      ->required();
  command->add_flag("--json", arguments->json, "Print one JSON object instead of a summary");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace vandplan
