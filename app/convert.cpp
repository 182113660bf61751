// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan convert: how do other people's problems become scenarios?
#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "vandplan/input_error.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

struct ConvertArguments {
  std::string input;
  std::string output;
  bool json = false;
};

void run(const ConvertArguments& arguments) {
  const Scenario scenario = read_tpcap(arguments.input);
  write_file(arguments.output, scenario_to_yaml(scenario));
  if (arguments.json) {
    print({{"scenario", scenario.name}, {"output", arguments.output}});
  } else {
    fmt::print("{}: {} obstacles, written to {}\n", scenario.name, scenario.obstacles.size(),
               arguments.output);
  }
}

}  // namespace

void add_convert(CLI::App& vandplan, int&) {
  CLI::App* const convert =
      vandplan.add_subcommand("convert", "Make scenarios of other people's problems.");
  convert->require_subcommand(0, 1);
  convert->callback([convert] {
    if (!convert->get_subcommands().empty()) return;
    throw InputError("convert", "a format is missing, expected tpcap");
  });
  CLI::App* const tpcap = convert->add_subcommand(
      "tpcap", "A case of the Trajectory Planning Competition for Automated Parking 2022.");
  const auto arguments = std::make_shared<ConvertArguments>();
  tpcap->add_option("CASE", arguments->input, "Case file (CSV)")->required();
  tpcap->add_option("-o,--output", arguments->output, "Scenario file (YAML)")
      ->type_name("FILE")
      ->required();
  tpcap->add_flag("--json", arguments->json, "Print one JSON object instead of a summary");
  tpcap->callback([arguments] { run(*arguments); });
}

}  // namespace vandplan
