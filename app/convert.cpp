// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan convert: how do other people's problems become scenarios?
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "chosen_path.h"
#include "commands.h"
#include "convert_footprint.h"
#include "endings.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "vandplan/result_file.h"
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
    throw InputError("--output", "is -, expected a file, because the map is written beside it");
  const std::filesystem::path place = output;
  const std::string stem = place.stem().string() + ".map";
  scenario.map_file = stem + ".yaml";
  const auto beside = [&](const std::string& name) {
    return (place.parent_path() / name).string();
  };
  for (const std::string& file : {beside(stem + ".pgm"), beside(scenario.map_file), output}) {
    expect_writable(file);  // all files, before one is written
  }
  write_file(beside(stem + ".pgm"), map_to_pgm(*scenario.map));
  write_file(beside(scenario.map_file), map_to_yaml(*scenario.map, stem + ".pgm"));
}

/// Writes a scenario and prints a summary, or JSON with the members of `more`.
void write(ScenarioFile file, const ConvertArguments& arguments,
           const nlohmann::ordered_json& more = nlohmann::ordered_json::object()) {
  Scenario& scenario = file.scenario;
  expect_ending(arguments.output, scenario_file);
  if (scenario.map) write_map(scenario, arguments.output);
  write_file(arguments.output, to_yaml(file));
  if (arguments.json) {
    nlohmann::ordered_json json = {{"scenario", scenario.name}, {"output", arguments.output}};
    json.update(more);
    print(json);
    return;
  }
  const std::string what =
      scenario.map ? fmt::format("{} x {} cells", scenario.map->columns, scenario.map->rows)
                   : fmt::format("{} obstacles", scenario.obstacles.size());
  fmt::print("{}: {}, written to {}\n", printable(scenario.name), what,
             printable(arguments.output));
}

/// Adds the options that all formats have.
void add_output(CLI::App& format, const std::shared_ptr<ConvertArguments>& arguments) {
  format.add_option("-o,--output", arguments->output, "Scenario (YAML)")
      ->type_name("FILE")
      ->required();
  format.add_flag("--json", arguments->json, "Print JSON");
}

void add_vehicle(CLI::App& format, std::string& vehicle) {
  format.add_option("--vehicle", vehicle, "Vehicle of the catalogue")
      ->type_name("NAME")
      ->capture_default_str();
}

void add_tpcap(CLI::App& convert) {
  CLI::App* const tpcap =
      convert.add_subcommand("tpcap", "Convert a case of the parking competition TPCAP 2022.");
  const auto arguments = std::make_shared<ConvertArguments>();
  tpcap->add_option("CASE", arguments->input, "Case (CSV)")->required();
  add_output(*tpcap, arguments);
  tpcap->callback([arguments] { write({read_tpcap(arguments->input)}, *arguments); });
}

void add_movingai(CLI::App& convert) {
  CLI::App* const movingai =
      convert.add_subcommand("movingai", "Convert a problem of the MovingAI benchmarks.");
  const auto arguments = std::make_shared<ConvertArguments>();
  MovingAiProblem& problem = arguments->movingai;
  movingai->add_option("MAP", problem.map, "Map (.map)")->required();
  movingai->add_option("SCEN", problem.problems, "Problems (.scen)")->required();
  movingai->add_option("--number", problem.number, "Number of the problem, from 1")
      ->type_name("N")
      ->capture_default_str();
  movingai->add_option("--resolution", problem.resolution, "Side of a cell [m]")
      ->type_name("M")
      ->capture_default_str();
  add_vehicle(*movingai, problem.vehicle);
  add_output(*movingai, arguments);
  movingai->callback([arguments] { write({read_movingai(arguments->movingai)}, *arguments); });
}

void add_dynobench(CLI::App& convert) {
  CLI::App* const dynobench = convert.add_subcommand(
      "dynobench", "Convert a dynobench problem of one car, with or without a trailer.");
  const auto arguments = std::make_shared<ConvertArguments>();
  dynobench->add_option("PROBLEM", arguments->input, "Problem (YAML)")->required();
  add_vehicle(*dynobench, arguments->vehicle);
  add_output(*dynobench, arguments);
  dynobench->callback(
      [arguments] { write({read_dynobench(arguments->input, arguments->vehicle)}, *arguments); });
}

/// Pose of a flag with a text such as "3.5,-2,1.57"; none if the text is empty. Throws InputError
/// naming the flag.
std::optional<Pose> pose_of(const std::string& flag, const std::string& text) {
  if (text.empty()) return {};
  double numbers[3] = {};
  const char* at = text.data();
  const char* const last = at + text.size();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [end, error] = std::from_chars(at, last, numbers[i]);
    const bool ends_well = i < 2 ? end != last && *end == ',' : end == last;
    if (error != std::errc() || !ends_well || !std::isfinite(numbers[i])) {
      throw InputError(flag, fmt::format("is {}, expected X,Y,HEADING", text.substr(0, 60)));
    }
    at = end + 1;
  }
  return Pose{numbers[0], numbers[1], numbers[2]};
}

/// Vehicle of the catalogue with that name, or of that file.
Vehicle vehicle_of(const std::string& vehicle) {
  return has_ending(vehicle, scenario_file) ? read_vehicle(vehicle) : vehicle_named(vehicle);
}

/// Writes a scenario, and prints its warnings, its origin and notes.
void write_with_notes(const ScenarioFile& file, const std::vector<std::string>& notes,
                      const ConvertArguments& arguments) {
  nlohmann::ordered_json more = {{"notes", notes}};
  if (file.origin) {
    more["origin"] = {{"longitude", file.origin->longitude}, {"latitude", file.origin->latitude}};
  }
  expect_writable(arguments.output);  // before any warning
  warn(file.warnings);
  write(file, arguments, more);
  if (arguments.json) return;
  if (file.origin) {
    fmt::print("  origin at longitude {}, latitude {}\n", file.origin->longitude,
               file.origin->latitude);
  }
  for (const std::string& note : notes) fmt::print("  {}\n", printable(note));
}

struct GeoJsonArguments {
  ConvertArguments general;
  GeoJsonSite site;
  std::string start;
  std::string goal;
};

void convert_geojson(GeoJsonArguments& arguments) {
  GeoJsonSite& site = arguments.site;
  site.vehicle = vehicle_of(arguments.general.vehicle);
  site.start = pose_of("--start", arguments.start);
  site.goal = pose_of("--goal", arguments.goal);
  const GeoJsonScenario read = read_geojson(site);
  write_with_notes({.scenario = read.scenario, .warnings = read.warnings, .origin = read.origin},
                   read.notes, arguments.general);
}

void add_geojson(CLI::App& convert) {
  CLI::App* const geojson =
      convert.add_subcommand("geojson", "Convert a site in GeoJSON, from QGIS or OpenStreetMap.");
  const auto arguments = std::make_shared<GeoJsonArguments>();
  GeoJsonSite& site = arguments->site;
  geojson->add_option("SITE", site.file, "Site (GeoJSON); - is standard input")->required();
  geojson->add_flag("--metres", site.is_in_metres,
                    "Coordinates are metres, whatever the file says");
  geojson
      ->add_option("--start", arguments->start,
                   "Start in coordinates of the file, HEADING [rad]; default: of the file")
      ->type_name("X,Y,HEADING");
  geojson->add_option("--goal", arguments->goal, "Goal, likewise")->type_name("X,Y,HEADING");
  geojson
      ->add_option("--width", site.default_width,
                   "Width of lines and points without their own [m]; 0.001 to 1000")
      ->type_name("M")
      ->capture_default_str();
  geojson
      ->add_option("--vehicle", arguments->general.vehicle,
                   "Vehicle of the catalogue, or file (.yaml)")
      ->type_name("NAME")
      ->capture_default_str();
  add_output(*geojson, std::shared_ptr<ConvertArguments>(arguments, &arguments->general));
  geojson->callback([arguments] { convert_geojson(*arguments); });
}

/// Adds the options that all maps of roads have.
void add_rules(CLI::App& format, RoadRules& rules) {
  format.add_flag("--both-ways", rules.both_ways, "Lanes may be driven in both directions");
  format.add_flag("--open-edges", rules.open_edges, "The body may leave lanes and areas");
}

struct RoadArguments {
  ConvertArguments general;
  RoadMap map;
  std::string start;
  std::string goal;
};

using ReadRoads = RoadScenario (*)(const RoadMap&);

/// Adds a format of maps of roads.
void add_roads(CLI::App& convert, const char* name, const char* description, ReadRoads read) {
  CLI::App* const roads = convert.add_subcommand(name, description);
  const auto arguments = std::make_shared<RoadArguments>();
  roads->add_option("MAP", arguments->map.file, "Map (XML); - is standard input")->required();
  roads->add_option("--start", arguments->start, "Start in coordinates of the map, HEADING [rad]")
      ->type_name("X,Y,HEADING")
      ->required();
  roads->add_option("--goal", arguments->goal, "Goal, likewise")
      ->type_name("X,Y,HEADING")
      ->required();
  roads
      ->add_option("--vehicle", arguments->general.vehicle,
                   "Vehicle of the catalogue, or file (.yaml)")
      ->type_name("NAME")
      ->capture_default_str();
  add_rules(*roads, arguments->map.rules);
  add_output(*roads, std::shared_ptr<ConvertArguments>(arguments, &arguments->general));
  roads->callback([arguments, read] {
    RoadMap& map = arguments->map;
    map.start = pose_of("--start", arguments->start).value_or(Pose{});
    map.goal = pose_of("--goal", arguments->goal).value_or(Pose{});
    map.vehicle = vehicle_of(arguments->general.vehicle);
    const RoadScenario made = read(map);
    write_with_notes(made.file, made.notes, arguments->general);
  });
}

struct CommonRoadArguments {
  ConvertArguments general;
  CommonRoadCase one;
  std::string solution;
};

/// Writes a result as a solution, if the judge accepts its path. Returns the exit status.
int write_solution(const CommonRoadArguments& arguments) {
  const ConvertArguments& general = arguments.general;
  expect_ending(general.output, {"a solution is XML", {".xml"}});
  const ScenarioFile file = read_commonroad(arguments.one).file;
  const ResultRecord record = read_results(arguments.solution, file).front();
  const Choice choice{file.scenario, make_problem(file.scenario), record, file.scenario.name};
  if (const std::string reason = reason_not_to_drive(choice); !reason.empty()) {
    return refuse(choice, reason, general.json);
  }
  if (record.result.speeds) {
    const DriveCheck check =
        check_drive(choice.problem, {*record.result.path, *record.result.speeds});
    if (!check.valid) return refuse(choice, check.reason, general.json);
  }
  const CommonRoadSolution solution = commonroad_solution(arguments.one, record.result);
  warn(solution.warnings);
  write_file(general.output, solution.text);
  if (general.json) {
    print({{"scenario", file.scenario.name}, {"output", general.output}});
  } else {
    fmt::print("{}: solution written to {}\n", printable(file.scenario.name),
               printable(general.output));
  }
  return 0;
}

void add_commonroad(CLI::App& convert, int& status) {
  CLI::App* const format = convert.add_subcommand(
      "commonroad", "Convert a scenario of CommonRoad, or a result into a solution of it.");
  const auto arguments = std::make_shared<CommonRoadArguments>();
  arguments->general.vehicle.clear();
  format->add_option("SCENARIO", arguments->one.file, "Scenario (XML); - is standard input")
      ->required();
  format
      ->add_option("--problem", arguments->one.problem,
                   "Planning problem, if the scenario has several")
      ->type_name("ID");
  CLI::Option* const vehicle =
      format
          ->add_option("--vehicle", arguments->general.vehicle,
                       "Vehicle of the catalogue or file; default: CommonRoad's vehicle 2")
          ->type_name("NAME");
  add_rules(*format, arguments->one.rules);
  format
      ->add_option("--solution", arguments->solution,
                   "Write this result (JSON or binary) as a solution (XML)")
      ->type_name("RESULT")
      ->excludes(vehicle);
  add_output(*format, std::shared_ptr<ConvertArguments>(arguments, &arguments->general));
  format->callback([arguments, &status] {
    const std::string& name = arguments->general.vehicle;
    if (!name.empty()) arguments->one.vehicle = vehicle_of(name);
    if (!arguments->solution.empty()) {
      status = write_solution(*arguments);
      return;
    }
    const RoadScenario made = read_commonroad(arguments->one);
    write_with_notes(made.file, made.notes, arguments->general);
  });
}

}  // namespace

void add_convert(CLI::App& vandplan, int& status) {
  CLI::App* const convert =
      vandplan.add_subcommand("convert", "Convert other formats into scenarios or vehicles.");
  convert->require_subcommand(0, 1);
  convert->callback([convert] {
    if (!convert->get_subcommands().empty()) return;
    throw InputError("convert",
                     "a format is missing, expected geojson, lanelet2, opendrive, commonroad, "
                     "tpcap, movingai, dynobench or footprint");
  });
  add_geojson(*convert);
  add_roads(*convert, "lanelet2", "Convert a map of Lanelet2 (.osm).", read_lanelet2);
  add_roads(*convert, "opendrive", "Convert a map of OpenDRIVE (.xodr).", read_opendrive);
  add_commonroad(*convert, status);
  add_tpcap(*convert);
  add_movingai(*convert);
  add_dynobench(*convert);
  add_footprint(*convert);
}

}  // namespace vandplan::app
