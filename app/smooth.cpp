// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan smooth: which path near this one is cheaper, and can be followed by the wheels?
#include "vandplan/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "commands.h"
#include "endings.h"
#include "interrupt.h"
#include "option_flags.h"
#include "pictures.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/result_file.h"
#include "wording.h"

namespace vandplan::app {
namespace {

struct SmoothArguments {
  std::string scenario;
  std::string result;
  std::string method = "optimised";
  std::vector<TypedOption> options;
  std::optional<std::string> output;
  PictureWish picture;
  bool json = false;
};

/// A result before and after smoothing.
struct Run {
  ResultRecord before;
  ResultRecord after;  ///< result after smoothing; equals `before` without a path
  Smoothed smoothed = {};
};

/// Options for smoothing a result. Throws InputError naming a typed option that is wrong, or the
/// file of the result.
PlanOptions options_of(const SmoothArguments& arguments, const ScenarioFile& scenario,
                       const ResultRecord& record) {
  PlanOptions options;
  try {
    options = smooth_options(scenario.options, stored_options(record));
  } catch (const InputError& error) {
    throw InputError(arguments.result,
                     fmt::format("options.{}: {}", error.where(), error.problem()));
  }
  set_typed(options, smoother({}, {}), arguments.options);
  return options;
}

Run smoothed(const Problem& problem, const ResultRecord& record, SmoothMethod method,
             const PlanOptions& options) {
  Run run{record, record};
  if (!record.result.path) return run;
  run.smoothed = smooth(problem, *record.result.path, method, options);
  run.after.planner = smoother({}, method).name;
  run.after.options = run.smoothed.options;
  run.after.result = run.smoothed.result;
  run.after.claims = {};
  run.after.stated = {};
  return run;
}

/// "71.230 m before": cost of the given path under the same options, and its fault if it is not
/// allowed.
std::string before_text(const Smoothed& smoothed) {
  const bool is_time = smoothed.options.cost.measure == CostMeasure::time;
  std::string text = is_time ? seconds_text(smoothed.given_cost) : metres_text(smoothed.given_cost);
  text += " before";
  if (smoothed.given_fault.empty()) return text;
  return fmt::format("{} (not allowed: {})", text, printable(smoothed.given_fault));
}

std::string outcome_of(const Run& run, const Problem& problem) {
  const PlanResult& result = run.after.result;
  if (!run.before.result.path || !result.path) return no_path_text(result);
  const std::string path = fmt::format("{}, {}", path_text(*result.check),
                                       cost_text(result.cost, run.after.options.cost, problem));
  const std::string work =
      fmt::format("{} iterations, {}", result.iterations, seconds_text(result.time_total));
  if (run.smoothed.is_given) {
    return fmt::format("no better path found, the path is unchanged: {}; {}", path, work);
  }
  return fmt::format("smoothed: {}, {}; {}", path, before_text(run.smoothed), work);
}

void print_summary(const ScenarioProblems& read, const std::vector<Run>& runs) {
  fmt::print("{}, {}\n", printable(read.file.scenario.name), runs.front().after.planner);
  for (const Run& run : runs) {
    if (run.after.distance) fmt::print("{:7.6g} m: ", *run.after.distance);
    fmt::print("{}\n", outcome_of(run, read.problems.front()));
  }
}

int run(const SmoothArguments& arguments) {
  const SmoothMethod method = smooth_method_named(arguments.method);
  PlanOptions typed;
  set_typed(typed, smoother({}, method), arguments.options);
  (void)complete(smoother({}, method), typed);
  const std::stop_token stop = stop_on_signal();
  if (arguments.output) {
    expect_ending(*arguments.output, result_file);
    expect_writable(*arguments.output);
  }
  if (!arguments.picture.file.empty()) expect_picture(arguments.picture.file);
  const ScenarioProblems read = read_problems(arguments.scenario);
  warn(read.file.warnings);
  expect_one_path(arguments.picture, read.file);
  if (arguments.output) expect_format(*arguments.output, read.file);
  ResultReader reader(arguments.result, read.file);
  if (reader.has_pairs()) {
    throw InputError(arguments.result, "holds results of many pairs, expected one result");
  }
  std::vector<Run> runs;
  for (const ResultRecord& record : reader.all()) {
    PlanOptions options = options_of(arguments, read.file, record);
    options.budget.stop = stop;
    runs.push_back(smoothed(read.problems[runs.size()], record, method, options));
  }
  std::vector<ResultRecord> after;
  std::ranges::transform(runs, std::back_inserter(after), &Run::after);
  if (arguments.output) write_results(*arguments.output, read.file, after);
  if (!arguments.picture.file.empty()) write_picture(arguments.picture, read.file, after);
  if (arguments.json) {
    write_results("-", read.file, after);
  } else {
    print_summary(read, runs);
  }
  const bool all = std::ranges::all_of(runs, [](const Run& run) {
    return run.before.result.path.has_value() == run.after.result.path.has_value();
  });
  return all ? exit_status::done : exit_status::failed;
}

}  // namespace

void add_smooth(CLI::App& vandplan, int& status) {
  CLI::App* const command = vandplan.add_subcommand(
      "smooth", "Make a path cheaper, without jumps of the curvature between stops.");
  const auto arguments = std::make_shared<SmoothArguments>();
  add_scenario_and_result(*command, arguments->scenario, arguments->result);
  command
      ->add_option("--method", arguments->method,
                   "clothoids: smooth the joints, shorten briefly;\n"
                   "optimised: use the whole budget")
      ->type_name("NAME")
      ->capture_default_str();
  add_option_flags(*command, arguments->options);
  command
      ->add_option("--output", arguments->output,
                   "Result (JSON; .vpr: binary; .geojson: the path on a map)")
      ->type_name("FILE");
  add_picture(*command, arguments->picture);
  command->add_flag("--json", arguments->json, "Print JSON");
  command->footer(
      "Keys of --set: those of `vandplan plan` for all planners, and min_stroke. Options come "
      "from\n"
      "the command line, else from the result (but for its budget), else from the scenario.\n"
      "Exit status: 0 done, 1 no such path found, 2 bad input.");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan::app
