// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/report.h"

#include <fmt/format.h>

#include <map>
#include <string_view>
#include <utility>

#include "vandplan/input_error.h"

namespace vandplan {
namespace {

// The options that all runs of a comparison share.
std::string shared_options(PlanOptions options) {
  options.region = Region::bounds;
  options.profile = false;
  return options_to_json(options);
}

// Which scenario a file holds now: index in the store by file.
using Current = std::map<std::string, std::size_t>;

// The runs to tell of: of one program and machine, of equal options, of files as they are now.
struct Choice {
  std::size_t environment = 0;
  PlanOptions options;
  Current known = {};  // of other files the last run had what they hold
};

Current current_of(const Report& report, const Choice& choice) {
  Current current;
  for (const RunRecord& run : report.runs) current[report.files[run.scenario].file] = run.scenario;
  for (const auto& [file, scenario] : choice.known) current[file] = scenario;
  return current;
}

Report make_report(Store& store, std::vector<RunRecord> runs, const Choice& choice) {
  Report report;
  report.environment = store.environments().at(choice.environment);
  report.options = choice.options;
  report.files = store.scenarios();
  for (const StoredScenario& file : report.files) report.scenarios.push_back(scenario_of(file));
  report.sessions = store.sessions();
  std::erase_if(report.sessions,
                [&](const Session& session) { return session.environment != choice.environment; });
  report.runs = std::move(runs);
  const std::size_t all = report.runs.size();
  const std::string shared = shared_options(choice.options);
  std::erase_if(report.runs, [&](const RunRecord& run) {
    return run.environment != choice.environment || shared_options(run.options) != shared;
  });
  const Current current = current_of(report, choice);
  std::erase_if(report.runs, [&](const RunRecord& run) {
    return current.at(report.files[run.scenario].file) != run.scenario;
  });
  report.left_out = static_cast<int>(all - report.runs.size());
  if (report.runs.empty()) throw InputError("report", "there is no run to tell of");
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
  const Choice choice{runs.back().environment, runs.back().options};
  return make_report(store, std::move(runs), choice);
}

Report make_report(Store& store, const Campaign& campaign) {
  Choice choice{store.index_of(this_environment()), campaign.options};
  for (const auto& [scenario, file] : campaign.scenarios)
    choice.known[file] = store.index_of(stored(scenario, file));
  return make_report(store, store.runs(), choice);
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
