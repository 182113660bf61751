// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan draw: what does a scenario or a result look like?
#include <fmt/format.h>

#include <memory>

#include "commands.h"
#include "pictures.h"
#include "vandplan/input_error.h"
#include "wording.h"

namespace vandplan::app {
namespace {

struct DrawArguments {
  std::string scenario;
  std::optional<std::string> result;
  std::optional<std::size_t> pair;
  std::string output;
  bool curvature_strip = false;
  bool plays = false;
  bool json = false;
};

/// Draws. Returns what was drawn of a file with many pairs, such as "48 pairs (others: --pair N)";
/// empty for other files.
std::string drawn(const DrawArguments& arguments, const ScenarioFile& scenario) {
  const PictureWish wish{arguments.output, arguments.curvature_strip, arguments.plays};
  if (!arguments.result) {
    write_picture(wish, scenario, std::vector<ResultRecord>{});
    return "";
  }
  ResultReader reader(*arguments.result, scenario);
  if (!reader.has_pairs()) {
    if (arguments.pair)
      throw InputError("--pair", "is for files with many results, this one holds one");
    write_picture(wish, scenario, reader.all());
    return "";
  }
  const DrawnPairs pairs = write_picture(wish, scenario, reader, arguments.pair);
  if (arguments.pair) return fmt::format("pair {}", *arguments.pair);
  return fmt::format("{} pairs{}", pairs.drawn, pairs.is_all ? "" : " (others: --pair N)");
}

void run(const DrawArguments& arguments) {
  expect_picture(arguments.output);
  const ScenarioFile scenario = read_scenario_file(arguments.scenario);
  warn(scenario.warnings);
  const std::string& name = scenario.scenario.name;
  const std::string what = drawn(arguments, scenario);
  if (arguments.json) {
    nlohmann::ordered_json json = {{"scenario", name}, {"output", arguments.output}};
    if (!what.empty()) json["drawn"] = what;
    print(json);
  } else {
    fmt::print("{}: {}drawn to {}\n", printable(name), what.empty() ? "" : what + " ",
               printable(arguments.output));
  }
}

}  // namespace

void add_draw(CLI::App& vandplan, int&) {
  CLI::App* const command = vandplan.add_subcommand("draw", "Draw a scenario, or a result.");
  command->footer(
      "A result adds the footprints along its path, and the search tree if it was kept\n"
      "(plan --set keep_tree=true). Many results (plan --poses) become a sheet of pictures.");
  const auto arguments = std::make_shared<DrawArguments>();
  add_scenario(*command, arguments->scenario);
  command->add_option("RESULT", arguments->result, "Result (JSON, JSON Lines or binary)");
  command->add_option("--pair", arguments->pair, "Draw only this pair, from 1")
      ->type_name("N")
      ->needs("RESULT");
  command->add_option("-o,--output", arguments->output, "Picture (.svg, .png or .pdf)")
      ->type_name("FILE")
      ->required();
  command
      ->add_flag("--curvature-strip", arguments->curvature_strip,
                 "Plot the curvature below the picture")
      ->needs("RESULT");
  command
      ->add_flag("--play", arguments->plays,
                 "Animate the picture (.svg, for browsers); a path without times is\n"
                 "driven as fast as the vehicle can")
      ->needs("RESULT");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace vandplan::app
