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
  Current current;
};

Report make_report(Store& store, std::vector<RunRecord> runs, const Choice& choice) {
  Report report;
  report.environment = store.environments().at(choice.environment);
  report.options = choice.options;
  report.files = store.scenarios();
  for (const StoredScenario& file : report.files) report.scenarios.push_back(scenario_of(file));
  report.sessions = store.sessions();
  std::erase_if(report.sessions,
                [&](const Session& session) { return session.environment != choice.environment; });
  const std::string shared = shared_options(choice.options);
  report.left_out = static_cast<int>(std::erase_if(runs, [&](const RunRecord& run) {
    return run.environment != choice.environment || shared_options(run.options) != shared ||
           choice.current.at(report.files[run.scenario].file) != run.scenario;
  }));
  if (runs.empty()) throw InputError("report", "there is no run to tell of");
  report.runs = std::move(runs);
  report.summary = summarize(report.scenarios, report.runs);
  report.findings = findings(report.summary, report.scenarios);
  return report;
}

// As far as the runs tell: the last one of each file had what it holds.
Current current_of(Store& store, const std::vector<RunRecord>& runs) {
  const std::vector<StoredScenario> files = store.scenarios();
  Current current;
  for (const RunRecord& run : runs) current[files.at(run.scenario).file] = run.scenario;
  return current;
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
  const Choice choice{runs.back().environment, runs.back().options, current_of(store, runs)};
  return make_report(store, std::move(runs), choice);
}

Report make_report(Store& store, const Campaign& campaign) {
  std::vector<RunRecord> runs = store.runs();
  Choice choice{store.index_of(this_environment()), campaign.options, current_of(store, runs)};
  for (const auto& [scenario, file] : campaign.scenarios)
    choice.current[file] = store.index_of(stored(scenario, file));
  return make_report(store, std::move(runs), choice);
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
