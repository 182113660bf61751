// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan plan: which path solves a scenario?
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <thread>

#include "commands.h"
#include "interrupt.h"
#include "pictures.h"
#include "plan_poses.h"
#include "vandplan/input_error.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

constexpr double default_time = 1.0;  // [s]

struct PlanArguments {
  std::string scenario;
  std::string planner{default_planner().name};
  PlanOptions options;
  std::optional<std::string> output;
  std::optional<std::string> picture;
  std::optional<std::string> poses;
  int jobs = 0;  // as many as there are processors
  bool json = false;
};

/// An option of the planners that has a flag of its own.
struct Flag {
  const char* flag;
  const char* option;
  const char* value;
};

constexpr Flag flags[] = {
    {"--time", "time_limit", "S"},     {"--max-iterations", "max_iterations", "N"},
    {"--max-nodes", "max_nodes", "N"}, {"--seed", "seed", "N"},
    {"--threads", "threads", "N"},     {"--region", "region", "bounds|scene"}};

std::vector<ResultRecord> plan_goals(const Scenario& scenario, const PlannerInfo& planner,
                                     const PlanOptions& options) {
  const std::vector<Problem> problems = make_problems(scenario);
  std::vector<ResultRecord> records;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const Problem& problem = problems[i];
    ResultRecord record;
    record.scenario = scenario.name;
    record.planner = planner.name;
    record.options = options;
    record.distance = scenario.goals[i].distance;
    record.result = plan(problem, planner, options);
    records.push_back(in_scenario(*problem.world, std::move(record)));
  }
  return records;
}

std::string outcome_of(const PlanResult& result) {
  if (!result.path) return fmt::format("no path: {}", name_of(result.status));
  const std::vector<Segment>& segments = result.path->segments;
  const double bound = result.lower_bound;  // 0 if the planner proves none
  const std::string gap =
      bound > 0 ? fmt::format(", gap {:.1f} %", 100 * (result.cost / bound - 1)) : "";
  return fmt::format("solved: length {:.3f} m, gear changes {}{}, first path after {:.4f} s",
                     length(segments), gear_changes(segments), gap, result.anytime.front().time);
}

void print_summary(const Scenario& scenario, const std::vector<ResultRecord>& records) {
  const ResultRecord& any = records.front();
  fmt::print("{}, {}, seed {}\n", scenario.name, any.planner, any.options.seed);
  for (const ResultRecord& record : records) {
    const PlanResult& result = record.result;
    if (record.distance) fmt::print("{:7.6g} m: ", *record.distance);
    fmt::print("{}; {} iterations, {} nodes, {:.3f} s\n", outcome_of(result), result.iterations,
               result.nodes, result.time_total);
  }
  if (!scenario.goals_are_a_row) return;
  const std::optional<double> furthest = furthest_reached(records);
  fmt::print("furthest: {}\n", furthest ? fmt::format("{:.6g} m", *furthest) : "none");
}

int run(const PlanArguments& arguments) {
  const PlannerInfo& planner = planner_named(arguments.planner);
  PlanOptions options = arguments.options;
  if (!options.time_limit && !options.max_iterations) options.time_limit = default_time;
  options.stop = stop_on_signal();
  const Scenario scenario = read_scenario(arguments.scenario);
  if (arguments.poses) {
    const auto processors = static_cast<int>(std::thread::hardware_concurrency());
    const int jobs = arguments.jobs > 0 ? arguments.jobs : std::max(1, processors);
    return plan_poses(scenario, planner, options,
                      {*arguments.poses, arguments.output, jobs, arguments.json});
  }
  // What cannot be written is said before time is spent.
  if (arguments.output) expect_writable(*arguments.output);
  if (arguments.picture) expect_picture(*arguments.picture);

  const std::vector<ResultRecord> records = plan_goals(scenario, planner, options);
  const bool wants_json = arguments.output || arguments.json;
  const std::string json = wants_json ? results_to_json(scenario, records) : "";
  if (arguments.output) write_file(*arguments.output, json);
  if (arguments.picture) write_picture(*arguments.picture, scenario, records);
  if (arguments.json) {
    fmt::print("{}", json);
  } else {
    print_summary(scenario, records);
  }
  const bool solved = std::any_of(records.begin(), records.end(), [](const ResultRecord& record) {
    return record.result.status == PlanStatus::solved;
  });
  return solved ? exit_status::done : exit_status::failed;
}

// ---- the command line ----

/// The default as one types it.
std::string default_of(const OptionInfo& info) {
  std::string text = info.get(PlanOptions{});
  std::erase(text, '"');
  return text;
}

const OptionInfo& info_of(std::string_view name) {
  return *std::find_if(option_table().begin(), option_table().end(),
                       [&](const OptionInfo& info) { return info.name == name; });
}

/// Sets an option; an error names the flag that was typed.
void set_by_flag(PlanOptions& options, const Flag& flag, const std::string& value) {
  try {
    set_option(options, flag.option, value);
    validate(options);
  } catch (const InputError& error) {
    throw InputError(flag.flag, error.problem());
  }
}

void set_by_key(PlanOptions& options, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) {
    throw InputError("--set", "\"" + setting + "\" is not KEY=VALUE");
  }
  set_option(options, setting.substr(0, equals), setting.substr(equals + 1));
  validate(options);
}

std::string help_on_keys() {
  std::string text = "Keys of --set, with their defaults:\n";
  for (const OptionInfo& info : option_table()) {
    const std::string setting = fmt::format("{}={}", info.name, default_of(info));
    text += fmt::format("  {:<28}{}\n", setting, info.summary);
  }
  return text +
         fmt::format(
             "Without a limit of time or iterations a run takes {} s. In a row of goals each\n"
             "goal has the whole budget. Ctrl-C ends the run with the best path so far.\n"
             "Exit status: 0 solved (in a row: a goal at least; with --poses: all), 1 no path,\n"
             "2 bad input or usage.",
             default_time);
}

void add_flags(CLI::App& command, const std::shared_ptr<PlanArguments>& arguments) {
  for (const Flag& flag : flags) {
    const OptionInfo& info = info_of(flag.option);
    const auto set = [arguments, flag](const std::string& value) {
      set_by_flag(arguments->options, flag, value);
    };
    command.add_option_function<std::string>(flag.flag, set, std::string(info.summary))
        ->type_name(flag.value)
        ->default_str(default_of(info));
  }
}

}  // namespace

void add_plan(CLI::App& vandplan, int& status) {
  CLI::App* const command = vandplan.add_subcommand("plan", "Plan a path for a scenario.");
  const auto arguments = std::make_shared<PlanArguments>();
  command->add_option("SCENARIO", arguments->scenario, "Scenario file (YAML), - is standard input")
      ->required();
  command
      ->add_option("--planner", arguments->planner, "One of those that `vandplan planners` lists")
      ->type_name("NAME")
      ->capture_default_str();
  add_flags(*command, arguments);
  command->add_option("--output", arguments->output, "Write the result here (JSON)")
      ->type_name("FILE");
  command->add_option("--draw", arguments->picture, "Draw it here (.svg, .png or .pdf)")
      ->type_name("FILE");
  command
      ->add_option(
          "--poses", arguments->poses,
          "Plan many pairs in this one world: a line x, y, heading, x, y, heading of start\n"
          "and goal each (CSV); --output writes a result a line then (JSON Lines)")
      ->type_name("FILE")
      ->excludes("--draw");
  command
      ->add_option("--jobs", arguments->jobs, "Pairs planned at a time, 0: one for each processor")
      ->type_name("N")
      ->check(CLI::Range(0, 1024))
      ->needs("--poses")
      ->capture_default_str();
  const auto set = [arguments](const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) set_by_key(arguments->options, setting);
  };
  command
      ->add_option_function<std::vector<std::string>>("--set", set,
                                                      "Set any option by its key, see below")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--json", arguments->json, "Print one JSON object instead of a summary");
  command->footer(help_on_keys());
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan
