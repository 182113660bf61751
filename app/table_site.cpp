// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan table site: what does driving cost from everywhere on a site?
#include "table_site.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "commands.h"
#include "interrupt.h"
#include "option_flags.h"
#include "progress_bar.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/site_table.h"
#include "wording.h"

namespace vandplan::app {
namespace {

struct SiteArguments {
  std::string scenario;
  std::optional<std::string> goals;
  std::vector<TypedOption> options;
  SiteTableOptions table;
  int jobs = 0;  // goals at once; 0: one per processor
  std::string output;
  bool json = false;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Throws InputError if goals of a row have obstacles of their own: a table is of one world.
void expect_one_world(const SiteArguments& arguments, const std::vector<RowGoal>& row) {
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (row[i].obstacles == row.front().obstacles) continue;
    throw InputError(arguments.scenario,
                     fmt::format("goals[{}] has other obstacles than goals[0], expected the same, "
                                 "as a table is of one world, or --goals FILE.csv",
                                 i));
  }
}

/// Goals of the table: of the file, or of the scenario. Throws InputError if a goal is a set of
/// infinitely many, or goals have obstacles of their own.
Poses goals_of(const SiteArguments& arguments, const ScenarioProblems& read,
               const PlanOptions& options) {
  if (arguments.goals) return poses_in(*arguments.goals);
  expect_one_world(arguments, read.file.row);
  Poses goals;
  for (const Problem& problem : read.problems) {
    SiteGoals more;
    try {
      more = site_goals(problem, options);
    } catch (const InputError& error) {
      throw InputError(arguments.scenario, error.problem() + ": --goals FILE.csv");
    }
    goals.poses.insert(goals.poses.end(), more.poses.begin(), more.poses.end());
    if (more.left_out > 0) {
      warn({fmt::format("{}: {} of its goals are not free and left out", arguments.scenario,
                        more.left_out)});
    }
  }
  return goals;
}

/// The table; none if it was stopped. What is wrong with a flag or a goal names the flag or file.
std::optional<SiteTable> made(const SiteArguments& arguments, const Problem& problem,
                              const Poses& goals, const PlanOptions& options,
                              const SiteTableOptions& table) {
  try {
    return make_site_table(problem, goals.poses, options, table);
  } catch (const InputError& error) {
    const std::string& where = error.where();
    if (where == "headings" || where == "cell") throw InputError("--" + where, error.problem());
    if (arguments.goals) throw named_by_line(error, "goals", *arguments.goals, goals);
    throw InputError(arguments.scenario, where + ": " + error.problem());
  }
}

int make(const SiteArguments& arguments) {
  expect_writable(arguments.output);
  const std::stop_token stop = stop_on_signal();
  const ScenarioProblems read = read_problems(arguments.scenario);
  warn(read.file.warnings);
  const Problem& problem = read.problems.front();
  const PlanOptions options = site_options(read, arguments.options);
  const Poses goals = goals_of(arguments, read, options);
  SiteTableOptions wanted = arguments.table;
  wanted.threads = threads_of(arguments.jobs);
  wanted.stop = stop;
  wanted.starts = {problem.start()};
  const auto begin = std::chrono::steady_clock::now();
  std::optional<ProgressBar> bar;
  const std::size_t count = goals.poses.size();
  if (count > 1 && !arguments.json) bar.emplace();
  wanted.progress = [&](std::size_t done) {
    if (!bar) return;
    bar->show({.total = static_cast<int>(count),
               .done = static_cast<int>(done),
               .elapsed = seconds_since(begin)});
  };
  const std::optional<SiteTable> table = made(arguments, problem, goals, options, wanted);
  bar.reset();
  if (!table) throw InputError("table site", "was stopped, nothing is written");
  const std::string_view bytes = site_table_to_bytes(*table);
  write_file(arguments.output, bytes);
  if (arguments.output == "-") return exit_status::done;
  const double time = seconds_since(begin);
  if (arguments.json) {
    print(
        {{"output", arguments.output}, {"time", time}, {"goals", count}, {"bytes", bytes.size()}});
  } else {
    fmt::print("{}: costs to {} goal{}, {} bytes, made in {:.3f} s\n", printable(arguments.output),
               count, count == 1 ? "" : "s", bytes.size(), time);
  }
  return exit_status::done;
}

}  // namespace

PlanOptions site_options(const ScenarioProblems& read, const std::vector<TypedOption>& typed) {
  const Planner& planner = default_planner();
  for (const TypedOption& given : typed) {
    const std::string fault(fault_of_site_option(given.option));
    if (!fault.empty()) throw InputError(given.typed, fault);
  }
  return complete(planner, options_for(planner, read.file.options, typed),
                  read.problems.front().vehicle());
}

Poses poses_in(const std::string& file) {
  Poses read = read_poses(file);
  warn(read.warnings);
  return read;
}

InputError named_by_line(const InputError& error, const std::string& list, const std::string& file,
                         const Poses& poses) {
  for (std::size_t i = 0; i < poses.lines.size(); ++i) {
    if (error.where() != fmt::format("{}[{}]", list, i)) continue;
    return {line_of_file(file, poses.lines[i]), error.problem()};
  }
  return error;
}

int threads_of(int jobs) {
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(jobs > 0 ? jobs : processors, 1, 256);
}

void print_site_table(const std::string& file, bool json) {
  const SiteTable table = read_site_table(file);
  const Bounds box = table.bounds();
  const std::size_t bytes = site_table_to_bytes(table).size();
  if (!json) {
    fmt::print(
        "{}: costs of driving to {} goal{}, {} bytes, checksum is correct\n"
        "  places          x {:.1f} to {:.1f} m, y {:.1f} to {:.1f} m, cells of {:.3f} m\n"
        "  headings        {} per turn\n",
        printable(file), table.goals().size(), table.goals().size() == 1 ? "" : "s", bytes,
        box.x_min, box.x_max, box.y_min, box.y_max, table.cell(), table.headings());
    for (const Pose& goal : table.goals()) {
      fmt::print("  goal            {:.3f}, {:.3f}, {:.4f}\n", goal.x, goal.y, goal.heading);
    }
    return;
  }
  auto goals = nlohmann::ordered_json::array();
  for (const Pose& goal : table.goals()) goals.push_back({goal.x, goal.y, goal.heading});
  print({{"table", file},
         {"goals", goals},
         {"bounds", {box.x_min, box.x_max, box.y_min, box.y_max}},
         {"cell", table.cell()},
         {"headings", table.headings()},
         {"bytes", bytes}});
}

Planner naming_site(Planner planner, const std::string& file) {
  const std::string name = file == "-" ? "standard input" : file;
  planner.function = [plan = planner.function, name](const Task& task, const PlanOptions& options) {
    try {
      return plan(task, options);
    } catch (const InputError& error) {
      if (error.where() != "site") throw;
      throw InputError(name, error.problem());
    }
  };
  return planner;
}

void add_site_settings(CLI::App& command, std::vector<TypedOption>& options) {
  const auto add = [&options](const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) options.push_back(typed_setting(setting));
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--set", add, "Set an option: prices, gears, margin; see `vandplan plan --help`")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_jobs(CLI::App& command, int& jobs, const char* about) {
  command.add_option("--jobs", jobs, about)
      ->type_name("N")
      ->check(CLI::Range(0, 256).description(""))
      ->capture_default_str();
}

void add_table_site(CLI::App& table, int& status) {
  CLI::App* const command = table.add_subcommand(
      "site", "Compute what driving costs from everywhere on a site to its goals.");
  const auto arguments = std::make_shared<SiteArguments>();
  add_scenario(*command, arguments->scenario);
  command
      ->add_option("--goals", arguments->goals,
                   "Goals (CSV: x, y, heading); default: those of the scenario")
      ->type_name("FILE");
  add_site_settings(*command, arguments->options);
  command->add_option("--headings", arguments->table.headings, "Headings of a full turn, 8 to 256")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--cell", arguments->table.cell,
                   "Side of a cell of places [turning radii], 0.01 to 1")
      ->type_name("X")
      ->capture_default_str();
  add_jobs(*command, arguments->jobs, "Goals at once; 0: one per processor; up to 256");
  command->add_option("-o,--output", arguments->output, "Table (.vst)")
      ->type_name("FILE")
      ->required();
  command->add_flag("--json", arguments->json, "Print JSON");
  command->callback([arguments, &status] { status = make(*arguments); });
}

}  // namespace vandplan::app
