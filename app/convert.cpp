// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan convert: how do other people's problems become scenarios?
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "commands.h"
#include "endings.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/scenario_file.h"
#include "wording.h"

namespace vandplan::app {
namespace {

struct ConvertArguments {
  std::string input;
  MovingAiProblem movingai;
  std::string vehicle = "tpcap-car";
  std::string output;
  bool json = false;
};

/// Writes the map of a scenario beside it: yard.yaml has yard.map.yaml and yard.map.pgm.
void write_map(Scenario& scenario, const std::string& output) {
  if (output == "-")
    throw InputError("--output", "is -, expected a file: the map is put beside it");
  const std::filesystem::path place = output;
  const std::string stem = place.stem().string() + ".map";
  scenario.map_file = stem + ".yaml";
  const auto beside = [&](const std::string& name) {
    return (place.parent_path() / name).string();
  };
  for (const std::string& file : {beside(stem + ".pgm"), beside(scenario.map_file), output}) {
    expect_writable(file);  // all of them before any is touched
  }
  write_file(beside(stem + ".pgm"), map_to_pgm(*scenario.map));
  write_file(beside(scenario.map_file), map_to_yaml(*scenario.map, stem + ".pgm"));
}

void write(Scenario scenario, const ConvertArguments& arguments) {
  expect_ending(arguments.output, scenario_file);
  if (scenario.map) write_map(scenario, arguments.output);
  write_file(arguments.output, to_yaml(scenario));
  if (arguments.json) {
    print({{"scenario", scenario.name}, {"output", arguments.output}});
    return;
  }
  const std::string what =
      scenario.map ? fmt::format("{} x {} cells", scenario.map->columns, scenario.map->rows)
                   : fmt::format("{} obstacles", scenario.obstacles.size());
  fmt::print("{}: {}, written to {}\n", printable(scenario.name), what,
             printable(arguments.output));
}

/// What all formats have.
void add_output(CLI::App& format, const std::shared_ptr<ConvertArguments>& arguments) {
  format.add_option("-o,--output", arguments->output, "Scenario file (YAML)")
      ->type_name("FILE")
      ->required();
  format.add_flag("--json", arguments->json, "Print one JSON object instead of a summary");
}

void add_vehicle(CLI::App& format, std::string& vehicle) {
  const std::string names = fmt::format("{}", fmt::join(vehicle_names(), ", "));
  format.add_option("--vehicle", vehicle, "Who drives: " + names)
      ->type_name("NAME")
      ->capture_default_str();
}

void add_tpcap(CLI::App& convert) {
  CLI::App* const tpcap = convert.add_subcommand(
      "tpcap", "A case of the Trajectory Planning Competition for Automated Parking 2022.");
  const auto arguments = std::make_shared<ConvertArguments>();
  tpcap->add_option("CASE", arguments->input, "Case file (CSV)")->required();
  add_output(*tpcap, arguments);
  tpcap->callback([arguments] { write(read_tpcap(arguments->input), *arguments); });
}

void add_movingai(CLI::App& convert) {
  CLI::App* const movingai = convert.add_subcommand(
      "movingai",
      "A problem on a map of the MovingAI benchmarks. It has no headings: both are the direction\n"
      "from start to goal. The map is put beside the scenario (.map.yaml, .map.pgm).");
  const auto arguments = std::make_shared<ConvertArguments>();
  MovingAiProblem& problem = arguments->movingai;
  movingai->add_option("MAP", problem.map, "Map file (.map)")->required();
  movingai->add_option("SCEN", problem.problems, "Problem file (.scen)")->required();
  movingai->add_option("--number", problem.number, "Which problem of the file, from 1")
      ->type_name("N")
      ->capture_default_str();
  movingai->add_option("--resolution", problem.resolution, "Side of a cell [m]")
      ->type_name("M")
      ->capture_default_str();
  add_vehicle(*movingai, problem.vehicle);
  add_output(*movingai, arguments);
  movingai->callback([arguments] { write(read_movingai(arguments->movingai), *arguments); });
}

void add_dynobench(CLI::App& convert) {
  CLI::App* const dynobench = convert.add_subcommand(
      "dynobench", "A problem in the manner of dynobench: one car without trailer among boxes.");
  const auto arguments = std::make_shared<ConvertArguments>();
  dynobench->add_option("PROBLEM", arguments->input, "Problem file (YAML)")->required();
  add_vehicle(*dynobench, arguments->vehicle);
  add_output(*dynobench, arguments);
  dynobench->callback(
      [arguments] { write(read_dynobench(arguments->input, arguments->vehicle), *arguments); });
}

}  // namespace

void add_convert(CLI::App& vandplan, int&) {
  CLI::App* const convert =
      vandplan.add_subcommand("convert", "Make scenarios of other people's problems.");
  convert->require_subcommand(0, 1);
  convert->callback([convert] {
    if (!convert->get_subcommands().empty()) return;
    throw InputError("convert", "a format is missing, expected tpcap, movingai or dynobench");
  });
  add_tpcap(*convert);
  add_movingai(*convert);
  add_dynobench(*convert);
}

}  // namespace vandplan::app
