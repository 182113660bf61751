// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan smooth: which path near this one can the wheels follow?
#include "vandplan/smooth.h"

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

/// What smoothing makes of a result; without a path that stays as it is.
ResultRecord smoothed(const Problem& problem, ResultRecord record, SmoothMethod method,
                      PlanOptions options) {
  const std::optional<Path> path = record.result.path;
  if (!path) return record;
  const Planner planner = smoother(*path, method);
  record.planner = planner.name;
  record.options = complete(planner, options, problem.vehicle());
  record.result = plan(problem, planner, options);
  record.claims = {};
  return record;
}

void print_smoothed(const ScenarioFile& file, const std::vector<ResultRecord>& before,
                    const std::vector<ResultRecord>& after) {
  fmt::print("{}, {}\n", printable(file.scenario.name), after.front().planner);
  for (std::size_t i = 0; i < after.size(); ++i) {
    const PlanResult& result = after[i].result;
    if (after[i].distance) fmt::print("{:7.6g} m: ", *after[i].distance);
    if (!before[i].result.path || !result.path) {
      fmt::print("{}\n", no_path_text(result));
      continue;
    }
    const double length = vandplan::length(*before[i].result.path);
    fmt::print("smoothed: {}, {:+.2f} %; {} iterations, {}\n", path_text(*result.check),
               100 * (result.check->length / length - 1), result.iterations,
               seconds_text(result.time_total));
  }
}

int run(const SmoothArguments& arguments) {
  const SmoothMethod method = smooth_method_named(arguments.method);
  const Planner any = smoother({}, method);  // its options do not depend on the path
  (void)complete(any, options_for(any, {}, arguments.options));
  const std::atomic<bool>* const stop = stop_on_signal();
  if (arguments.output) {
    expect_ending(*arguments.output, result_file);
    expect_writable(*arguments.output);
  }
  if (!arguments.picture.file.empty()) expect_picture(arguments.picture.file);
  const ScenarioProblems read = read_problems(arguments.scenario);
  warn(read.file.warnings);
  PlanOptions options = options_for(any, read.file.options, arguments.options);
  const auto says_so = [](const auto& setting) { return setting.name == "steering"; };
  const auto types_so = [](const TypedOption& typed) { return typed.option == "steering"; };
  if (std::ranges::none_of(read.file.options, says_so) &&
      std::ranges::none_of(arguments.options, types_so)) {
    options.steering = Steering::continuous_between_stops;  // what smoothing is for
  }
  options.budget.stop = stop;
  expect_one_path(arguments.picture, read.file);
  ResultReader reader(arguments.result, read.file);
  if (reader.has_pairs()) {
    throw InputError(arguments.result, "holds results of many pairs, expected one result");
  }
  const std::vector<ResultRecord> before = reader.all();
  std::vector<ResultRecord> after;
  for (std::size_t i = 0; i < before.size(); ++i) {
    after.push_back(smoothed(read.problems[i], before[i], method, options));
  }
  if (arguments.output) write_results(*arguments.output, read.file, after);
  if (!arguments.picture.file.empty()) write_picture(arguments.picture, read.file, after);
  if (arguments.json) {
    write_results("-", read.file, after);
  } else {
    print_smoothed(read.file, before, after);
  }
  const bool all = std::ranges::equal(before, after, [](const auto& a, const auto& b) {
    return a.result.path.has_value() == b.result.path.has_value();
  });
  return all ? exit_status::done : exit_status::failed;
}

}  // namespace

void add_smooth(CLI::App& vandplan, int& status) {
  CLI::App* const command = vandplan.add_subcommand(
      "smooth",
      "Make the path of a result one that the wheels can follow: clothoids where the curvature\n"
      "jumps, along the same way, checked like any path. It is never worse than a path that can\n"
      "be followed already.");
  const auto arguments = std::make_shared<SmoothArguments>();
  add_scenario_and_result(*command, arguments->scenario, arguments->result);
  command
      ->add_option(
          "--method", arguments->method,
          "clothoids: at joints, and a moment of shortening; optimised: all of it is made\n"
          "cheaper for as long as the budget lasts")
      ->type_name("NAME")
      ->capture_default_str();
  add_option_flags(*command, arguments->options);
  command->add_option("--output", arguments->output, "Write the result here (JSON)")
      ->type_name("FILE");
  add_picture(*command, arguments->picture);
  command->add_flag("--json", arguments->json, "Print one JSON object instead of a summary");
  command->footer(
      "Keys of --set are those of `vandplan plan` for all planners; steering says where the\n"
      "curvature may jump. Exit status: 0 done, 1 no such path was found, 2 bad input or usage.");
  command->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace vandplan::app
