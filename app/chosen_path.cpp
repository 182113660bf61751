// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "chosen_path.h"

#include <fmt/format.h>

#include <utility>

#include "commands.h"
#include "endings.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/judge.h"
#include "wording.h"

namespace vandplan::app {
namespace {

/// Number of a goal in a row: `asked`, or else the furthest goal with a path, or else 0.
std::size_t goal_of(const ScenarioFile& file, const std::vector<ResultRecord>& records,
                    std::optional<std::size_t> asked) {
  if (asked && *asked >= records.size()) {
    throw InputError("--goal", fmt::format("is {}, expected 0 to {}", *asked, records.size() - 1));
  }
  if (asked) return *asked;
  std::size_t best = 0;
  for (std::size_t i = 1; i < records.size(); ++i) {
    const auto reach = [&](std::size_t goal) {
      return records[goal].result.path ? file.row[goal].distance : -1.0;
    };
    if (reach(i) > reach(best)) best = i;
  }
  return best;
}

Choice chosen_pair(const ScenarioProblems& read, ResultReader& reader, std::size_t number) {
  const Problem& pattern = read.problems.front();
  while (const std::optional<PairRecord> pair = reader.next()) {
    if (pair->pair != number) continue;
    Scenario scenario = scenario_at(read.file, 0);
    scenario.start = pair->poses.start;
    scenario.goal = pair->poses.goal;
    return {std::move(scenario), with_poses(pattern, pair->poses.start, pair->poses.goal),
            pair->record, fmt::format("{} pair {}", read.file.scenario.name, number)};
  }
  throw InputError("--pair", fmt::format("there is no pair {}", number));
}

Choice chosen(const ScenarioProblems& read, const PathArguments& arguments) {
  ResultReader reader(arguments.result, read.file);
  if (reader.has_pairs()) {
    if (arguments.goal) throw InputError("--goal", "the results are for pairs, expected --pair N");
    if (!arguments.pair)
      throw InputError(arguments.result, "holds many results, expected --pair N");
    return chosen_pair(read, reader, *arguments.pair);
  }
  if (arguments.pair)
    throw InputError("--pair", "is for files with many results, this one holds one");
  if (arguments.goal && !read.file.is_row()) {
    throw InputError("--goal", "the scenario has one goal, not a row of them");
  }
  std::vector<ResultRecord> records = reader.all();
  const std::size_t i = goal_of(read.file, records, arguments.goal);
  std::string label = read.file.scenario.name;
  if (read.file.is_row()) label += fmt::format(" goals[{}]", i);
  return {scenario_at(read.file, i), read.problems[i], std::move(records[i]), std::move(label)};
}

}  // namespace

void expect_drive_output(const std::string& output, const FileKind& kind, bool json) {
  if (json && output == "-") {
    throw InputError("--json", "does not go with --output -, both would print");
  }
  expect_ending(output, kind);
  expect_writable(output);
}

void add_choice(CLI::App& command, PathArguments& arguments) {
  command
      .add_option("--goal", arguments.goal,
                  "Goal of a row, from 0; default: the furthest with a path")
      ->type_name("N");
  command.add_option("--pair", arguments.pair, "Pair of many results, from 1")->type_name("N");
}

Choice chosen_path(const PathArguments& arguments) {
  const ScenarioProblems read = read_problems(arguments.scenario);
  warn(read.file.warnings);
  return chosen(read, arguments);
}

std::string reason_not_to_drive(const Choice& choice) {
  const std::optional<Path>& path = choice.record.result.path;
  if (!path) return no_path_text(choice.record.result);
  const PathCheck verdict = check_path(choice.problem, *path, choice.record.claims);
  return verdict.valid ? "" : "invalid: " + verdict.reason;
}

int refuse(const Choice& choice, const std::string& reason, bool json) {
  if (json) {
    print({{"scenario", choice.record.scenario}, {"reason", reason}});
  } else {
    fmt::print("{}: {}\n", printable(choice.label), reason);
  }
  return exit_status::failed;
}

}  // namespace vandplan::app
