// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan plan: which path solves a scenario?
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "commands.h"
#include "endings.h"
#include "interrupt.h"
#include "option_flags.h"
#include "pictures.h"
#include "plan_poses.h"
#include "recordings.h"
#include "table_site.h"
#include "table_source.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/recording.h"
#include "vandplan/result_file.h"
#include "wording.h"

namespace vandplan::app {
namespace {

struct PlanArguments {
  std::string scenario;
  std::string planner{default_planner().name};
  std::vector<TypedOption> options;
  std::optional<std::string> table;
  std::optional<std::string> primitives;
  std::optional<std::string> site;
  std::optional<std::string> output;
  std::optional<std::string> recording;
  PictureWish picture;
  std::optional<std::string> poses;
  std::optional<evaluation::Shard> shard;
  int jobs = 0;  // pairs planned at once; 0: one per processor
  bool json = false;
};

std::vector<ResultRecord> plan_goals(const ScenarioProblems& read, const Planner& planner,
                                     const PlanOptions& options) {
  std::vector<ResultRecord> records;
  for (std::size_t i = 0; i < read.problems.size(); ++i) {
    ResultRecord record;
    record.scenario = read.file.scenario.name;
    record.planner = planner.name;
    record.options = options;
    if (read.file.is_row()) record.distance = read.file.row[i].distance;
    record.result = plan(read.problems[i], planner, options);
    records.push_back(std::move(record));
  }
  return records;
}

/// ", proven: at most 12.3 % above the optimum"; empty where nothing is proven.
std::string proof_text(const PlanResult& result) {
  constexpr double weak = 0.25;  // gap above which the bound counts as weak
  if (!result.lower_bound) return "";
  const double gap = result.cost / *result.lower_bound - 1;
  return fmt::format(", proven: at most {:.1f} % above the optimum{}", 100 * gap,
                     gap > weak ? " (the bound is weak)" : "");
}

/// " to any_of[2] (45.00, 20.00, 1.571)": the goal of a set; empty for a goal that is one pose.
std::string goal_text(const PlanResult& result, const Scenario& scenario) {
  if (!result.goal) return "";
  const auto& [index, pose] = *result.goal;
  const bool is_one_of_many = scenario.goal_set.size() > 1;
  return fmt::format(" to {}({:.2f}, {:.2f}, {:.3f})",
                     is_one_of_many ? fmt::format("any_of[{}] ", index) : "", pose.x, pose.y,
                     pose.heading);
}

std::string outcome_of(const ResultRecord& record, const ScenarioProblems& read) {
  const PlanResult& result = record.result;
  if (!result.path) return no_path_text(result);
  const std::string cost = result.drive_check ? drive_text(result.drive_check)
                                              : ", " + cost_text(result.cost, record.options.cost,
                                                                 read.problems.front());
  return fmt::format("solved{}: {}{}{}, first path after {}", goal_text(result, read.file.scenario),
                     path_text(*result.check), cost, proof_text(result),
                     seconds_text(result.anytime.front().time));
}

void print_summary(const ScenarioProblems& read, const std::vector<ResultRecord>& records) {
  const ResultRecord& any = records.front();
  fmt::print("{}, {}, seed {}\n", printable(read.file.scenario.name), any.planner,
             any.options.budget.seed);
  for (const ResultRecord& record : records) {
    const PlanResult& result = record.result;
    if (record.distance) fmt::print("{:7.6g} m: ", *record.distance);
    fmt::print("{}; {} iterations, {} nodes, {}\n", outcome_of(record, read), result.iterations,
               counter(result, "nodes"), seconds_text(result.time_total));
  }
  if (!read.file.is_row()) return;
  const std::optional<double> furthest = furthest_reached(records);
  fmt::print("furthest: {}\n", furthest ? fmt::format("{:.6g} m", *furthest) : "none");
}

/// Throws InputError for files that cannot be written, before time is spent on planning.
void check_outputs(const PlanArguments& arguments) {
  if (arguments.output && arguments.poses) expect_ending(*arguments.output, result_lines_file);
  if (arguments.output && !arguments.poses) expect_ending(*arguments.output, result_file);
  if (arguments.output) expect_writable(*arguments.output);
  if (!arguments.picture.file.empty()) expect_picture(arguments.picture.file);
  if (arguments.recording) expect_recording(*arguments.recording);
}

/// Throws InputError for outputs that do not go with the scenario.
void check_outputs(const PlanArguments& arguments, const ScenarioFile& file) {
  expect_one_path(arguments.picture, file);
  if (arguments.output) expect_format(*arguments.output, file);
  if (arguments.recording && file.is_row()) {
    throw InputError("--record", "is for one path, the scenario has a row of goals");
  }
}

void warn_of_ignored(const ScenarioFile& file, const Planner& planner) {
  for (std::size_t i = 0; i < file.options.size(); ++i) {
    if (honours(planner, file.options[i].name)) continue;
    warn({fmt::format("{}: {} does not honour it", file.option_places[i], planner.name)});
  }
}

/// The error, with its place in the scenario file if it is about an option from there.
InputError with_place(const InputError& error, const ScenarioFile& file) {
  const auto found = std::ranges::find(file.options, error.where(), &Setting::name);
  if (found == file.options.end()) return error;
  return {file.option_places[static_cast<std::size_t>(found - file.options.begin())],
          error.problem()};
}

int run(const PlanArguments& arguments) {
  const Planner named = planner_named(arguments.planner);
  const Planner planner = arguments.site ? naming_site(named, *arguments.site) : named;
  const std::shared_ptr<const HeuristicTable> table = table_of_user(arguments.table);
  const std::shared_ptr<const search::Primitives> primitives =
      arguments.primitives ? read_primitives(*arguments.primitives) : nullptr;
  const std::shared_ptr<const SiteTable> site =
      arguments.site ? std::make_shared<const SiteTable>(read_site_table(*arguments.site))
                     : nullptr;
  const auto options_with = [&](const ScenarioFile& file) {
    try {
      PlanOptions options = options_for(planner, file.options, arguments.options);
      options.table = table;
      options.primitives = primitives;
      options.site = site;
      return complete(planner, options, file.scenario.vehicle);
    } catch (const InputError& error) {
      throw with_place(error, file);
    }
  };
  (void)options_with({});  // finds wrong options before a long read
  const std::stop_token stop = stop_on_signal();
  check_outputs(arguments);
  const ScenarioProblems read = read_problems(arguments.scenario);
  PlanOptions options = options_with(read.file);
  options.budget.stop = stop;
  check_outputs(arguments, read.file);
  warn(read.file.warnings);
  warn_of_ignored(read.file, planner);
  if (arguments.poses) {
    const auto processors = static_cast<int>(std::thread::hardware_concurrency());
    const int jobs = arguments.jobs > 0 ? arguments.jobs : std::max(1, processors);
    return plan_poses(read, planner, options,
                      {*arguments.poses, arguments.site, arguments.output, jobs, arguments.shard,
                       arguments.json});
  }
  const std::vector<ResultRecord> records = plan_goals(read, planner, options);
  if (arguments.output) write_results(*arguments.output, read.file, records);
  if (!arguments.picture.file.empty()) write_picture(arguments.picture, read.file, records);
  if (arguments.recording) {
    record(*arguments.recording,
           {.scenario = &read.file.scenario, .plan = &records.front().result});
  }
  if (arguments.json) {
    write_results("-", read.file, records);
  } else {
    print_summary(read, records);
  }
  const bool solved = std::any_of(records.begin(), records.end(), [](const ResultRecord& record) {
    return record.result.status == PlanStatus::solved;
  });
  return solved ? exit_status::done : exit_status::failed;
}

// ---- the command line ----

constexpr const char* examples_of_use =
    "Examples:\n"
    "  vandplan plan yard.yaml --draw yard.png\n"
    "  vandplan plan yard.yaml --max-iterations 20000 --seed 1 --output r.json\n"
    "  vandplan plan yard.yaml --set margin=0.3 --set style=shortest\n";

std::string help_on_keys() {
  return "Keys of --set, with their defaults:\n" + help_on_common_options() +
         help_on_options_of(default_planner()) +
         fmt::format(
             "A driver's prices are for a turning radius of 7 m. Below that, gear_change_cost "
             "and\n"
             "clearance_distance shrink in proportion, curvature_change_cost with the square.\n"
             "Prices that are set stay as they are. Keys that the planner does not use are "
             "refused;\n"
             "other planners: vandplan planners --options. Without a limit a run takes {} s per "
             "goal.\n"
             "Ctrl-C ends it with the best path so far.\n"
             "Exit status: 0 solved (a row: at least one goal; --poses: all), 1 no path, 2 bad "
             "input.",
             default_time_limit);
}

}  // namespace

void add_plan(CLI::App& vandplan, int& status) {
  const std::string about = "Plan a path for a scenario.";
  CLI::App* const command = vandplan.add_subcommand("plan", about);
  // Examples are added for the command's own help: the list of all commands has no room for them.
  command->preparse_callback(
      [command, about](std::size_t) { command->description(about + "\n\n" + examples_of_use); });
  const auto arguments = std::make_shared<PlanArguments>();
  add_scenario(*command, arguments->scenario);
  command->add_option("--planner", arguments->planner, "Planner, see `vandplan planners`")
      ->type_name("NAME")
      ->capture_default_str();
  command
      ->add_option("--site", arguments->site,
                   "Table of the site, see `vandplan table site`: begin with its way, or\n"
                   "look up its costs for estimate=site")
      ->type_name("FILE");
  add_option_flags(*command, arguments->options);
  add_table_flag(*command, arguments->table);
  command
      ->add_option("--primitives", arguments->primitives,
                   "Primitives of lattice planners: Nav2 (.json) or SBPL (.mprim)")
      ->type_name("FILE");
  command
      ->add_option("--output", arguments->output,
                   "Result (JSON; .vpr: binary; .geojson: the path on a map)")
      ->type_name("FILE");
  add_picture(*command, arguments->picture);
  add_record(*command, arguments->recording,
             "Recording of the run and the planned drive (.mcap), for Foxglove\nor Lichtblick");
  command
      ->add_option("--poses", arguments->poses,
                   "Plan many pairs of start and goal (CSV: x, y, heading of both);\n"
                   "--output then writes one result per line (JSON Lines) or .vpr")
      ->type_name("FILE")
      ->excludes("--draw", "--record");
  command
      ->add_option("--jobs", arguments->jobs,
                   "Pairs planned at once; 0: one per processor; up to 1024")
      ->type_name("N")
      ->check(CLI::Range(0, 1024).description(""))
      ->needs("--poses")
      ->capture_default_str();
  const auto set_shard = [arguments](const std::string& text) {
    arguments->shard = shard_in(text);
  };
  command
      ->add_option_function<std::string>("--shard", set_shard, "Plan only part I of N of the pairs")
      ->type_name("I/N")
      ->needs("--poses");
  command->add_flag("--json", arguments->json, "Print JSON");
  command->footer(help_on_keys());
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan::app
