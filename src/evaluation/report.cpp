// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/report.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "vandplan/input_error.h"
#include "vandplan/io.h"

namespace vandplan {
namespace {

// The options that all runs of a comparison share.
std::string shared_options(PlanOptions options) {
  options.region = Region::bounds;
  options.profile = false;
  return options_to_json(options);
}

Report make_report(Store& store, std::vector<RunRecord> runs, std::size_t environment,
                   const PlanOptions& options) {
  Report report;
  report.environment = store.environments().at(environment);
  report.options = options;
  report.files = store.scenarios();
  for (const StoredScenario& file : report.files)
    report.scenarios.push_back(scenario_from_yaml(file.yaml, file.name));
  report.sessions = store.sessions();
  std::erase_if(report.sessions,
                [&](const Session& session) { return session.environment != environment; });
  const std::string shared = shared_options(options);
  report.left_out = static_cast<int>(std::erase_if(runs, [&](const RunRecord& run) {
    return run.environment != environment || shared_options(run.options) != shared;
  }));
  if (runs.empty()) throw InputError("report", "there is no run to tell of");
  report.runs = std::move(runs);
  report.summary = summarize(report.scenarios, report.runs);
  report.findings = findings(report.summary, report.scenarios);
  return report;
}

// How an option is set on the command line, up to its value.
std::string flag_of(std::string_view option) {
  if (option == "seed") return " --seed ";
  if (option == "region") return " --region ";
  if (option == "max_iterations") return " --max-iterations ";
  if (option == "max_nodes") return " --max-nodes ";
  return fmt::format(" --set {}=", option);
}

}  // namespace

Report make_report(Store& store) {
  std::vector<RunRecord> runs = store.runs();
  if (runs.empty()) throw InputError("report", "there is no run to tell of");
  const std::size_t environment = runs.back().environment;
  const PlanOptions options = runs.back().options;
  return make_report(store, std::move(runs), environment, options);
}

Report make_report(Store& store, const Environment& environment, const PlanOptions& options) {
  return make_report(store, store.runs(), store.index_of(environment), options);
}

// A run that was cut by the clock made a number of iterations: with that as its limit it is the
// same run.
std::string reproduce_command(const Report& report, const RunRecord& run) {
  PlanOptions shown = run.options;
  shown.time_limit.reset();
  shown.max_iterations = run.result.iterations;
  shown.profile = false;
  std::string command =
      fmt::format("vandplan plan {} --planner {}", report.files[run.scenario].file, run.planner);
  const PlanOptions defaults;
  for (const OptionInfo& option : option_table()) {
    std::string value = option.get(shown);
    if (value == option.get(defaults) && option.name != "seed") continue;
    std::erase(value, '"');
    command += flag_of(option.name) + value;
  }
  return command;
}

}  // namespace vandplan
