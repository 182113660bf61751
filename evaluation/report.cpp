// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/escape.h"
#include "evaluation/methods.h"
#include "evaluation/options_json.h"
#include "evaluation/report_json.h"
#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

// Index in the store of the scenario that each file holds now.
using Current = std::map<std::string, std::size_t>;

// Limits of a run: time and iterations.
using Limits = std::pair<std::optional<double>, std::optional<std::int64_t>>;

Limits limits_of(const PlanOptions& options) {
  return {options.budget.time_limit, options.budget.max_iterations};
}

// Choice of the runs of a report: one environment, equal limits, current files.
struct Choice {
  std::size_t environment = 0;
  Limits limits = {};
  std::vector<Planner> planners = {};  // planners whose properties the store does not know
  // Options by planner and stored scenario; by default those of the last run.
  std::map<std::pair<std::string, std::size_t>, ComparableOptions> options = {};
  Current files = {};  // current scenarios of files; other files have that of their last run
};

// Texts of options; options that many runs share are converted once.
class OptionTexts {
 public:
  const ComparableOptions& of(const RunRecord& run) {
    const auto [known, is_new] = known_.try_emplace(run.options.identity());
    if (is_new) known->second = comparable_options(*run.options);
    return known->second;
  }

 private:
  std::map<const void*, ComparableOptions> known_;
};

// Index of the first scenario with an equal vehicle, for each scenario.
std::vector<std::size_t> vehicles_of(const std::vector<ScenarioFile>& scenarios) {
  std::vector<std::size_t> vehicles;
  for (const ScenarioFile& scenario : scenarios) {
    const auto has_same = [&](const ScenarioFile& other) {
      return other.scenario.vehicle == scenario.scenario.vehicle;
    };
    const auto first = std::ranges::find_if(scenarios, has_same);
    vehicles.push_back(static_cast<std::size_t>(first - scenarios.begin()));
  }
  return vehicles;
}

void keep_comparable(const Choice& choice, const std::vector<ScenarioFile>& scenarios,
                     std::vector<RunRecord>& runs) {
  std::erase_if(runs, [&](const RunRecord& run) {
    return run.environment != choice.environment || limits_of(*run.options) != choice.limits;
  });
  const std::vector<std::size_t> vehicles = vehicles_of(scenarios);
  OptionTexts texts;
  std::map<std::string, std::string> of_planner;
  std::map<std::pair<std::string, std::size_t>, std::string> of_vehicle;
  const auto want = [&](const std::string& planner, std::size_t scenario,
                        const ComparableOptions& options) {
    of_planner[planner] = options.of_planner;
    of_vehicle[{planner, vehicles[scenario]}] = options.of_vehicle;
  };
  for (const RunRecord& run : runs) want(run.planner, run.scenario, texts.of(run));
  for (const auto& [key, options] : choice.options) want(key.first, key.second, options);
  std::erase_if(runs, [&](const RunRecord& run) {
    const ComparableOptions& options = texts.of(run);
    return options.of_planner != of_planner.at(run.planner) ||
           options.of_vehicle != of_vehicle.at({run.planner, vehicles[run.scenario]});
  });
}

// Reads the segments of the paths that a report shows.
void read_examples(Store& store, Report& report) {
  for (const ScenarioSummary& scenario : report.summary.scenarios) {
    for (const MethodSummary& method : scenario.methods) {
      for (const std::optional<std::size_t>& example : {method.best, method.typical})
        if (example) store.read_segments(report.runs[*example]);
    }
  }
}

void keep_current(const Choice& choice, const std::vector<StoredScenario>& files,
                  std::vector<RunRecord>& runs) {
  Current current;
  for (const RunRecord& run : runs) current[files[run.scenario].file] = run.scenario;
  for (const auto& [file, scenario] : choice.files) current[file] = scenario;
  std::erase_if(runs, [&](const RunRecord& run) {
    return current.at(files[run.scenario].file) != run.scenario;
  });
}

Report make_report(Store& store, std::vector<RunRecord> runs, const Choice& choice) {
  Report report;
  report.environment = store.environments().at(choice.environment);
  report.files = store.scenarios();
  for (const StoredScenario& file : report.files) report.scenarios.push_back(scenario_of(file));
  report.sessions = store.sessions();
  std::erase_if(report.sessions,
                [&](const Session& session) { return session.environment != choice.environment; });
  report.runs = std::move(runs);
  const std::size_t all = report.runs.size();
  keep_comparable(choice, report.scenarios, report.runs);
  keep_current(choice, report.files, report.runs);
  report.left_out = static_cast<int>(all - report.runs.size());
  if (report.runs.empty()) throw InputError("report", "there is no run to tell of");
  report.planners = planners_of(report.runs, choice.planners);
  report.options = options_of(report.runs);
  report.summary = summarize(report.scenarios, report.planners, report.runs);
  read_examples(store, report);
  report.findings = findings(report.summary, report.scenarios);
  return report;
}

// Text of an option on the command line; `json` is its value.
std::string flag(const std::string& name, const std::string& json) {
  const bool is_word = json.starts_with('"');
  const std::string value = is_word ? OrderedJson::parse(json).get<std::string>() : json;
  if (name == "max_iterations") return " --max-iterations " + value;
  return " --set " + base::shell_word(name + "=" + value);
}

}  // namespace

Report make_report(Store& store) {
  std::vector<RunRecord> runs = store.runs_without_segments();
  if (runs.empty()) throw InputError("report", "there is no run to tell of");
  const Choice choice{runs.back().environment, limits_of(*runs.back().options)};
  return make_report(store, std::move(runs), choice);
}

Report make_report(Store& store, const Campaign& campaign) {
  Choice choice{.environment = store.index_of(this_environment()), .planners = campaign.planners};
  for (const auto& [scenario, file] : campaign.scenarios) {
    const std::size_t index = store.index_of(stored(scenario, file));
    choice.files[file] = index;
    for (const Planner& planner : campaign.planners) {
      const PlanOptions options = options_of(campaign, planner, scenario.scenario.vehicle);
      choice.limits = limits_of(options);
      choice.options[{planner.name, index}] = comparable_options(options);
    }
  }
  return make_report(store, store.runs_without_segments(), choice);
}

// A run that the clock ended is repeated with its number of iterations as the limit.
std::string reproduce_command(const Report& report, const RunRecord& run) {
  PlanOptions shown = *run.options;
  shown.budget.time_limit.reset();
  shown.budget.max_iterations = run.result.iterations;
  const std::optional<Planner> planner = find_planner(run.planner);
  const bool is_ours = planner.has_value();
  PlanOptions usual = is_ours ? complete(*planner) : PlanOptions{};
  usual.budget = {};
  const bool has_prices = is_ours && planner->can(Capability::prices);
  const bool has_style = has_prices && is_length(shown.cost);
  if (has_prices) usual.cost = {};  // prices of a style depend on the vehicle
  if (has_style) {
    usual.cost = shortest_style;
    usual.steering = Steering::reeds_shepp;
  }
  std::map<std::string, std::string> defaults;
  for (const auto& [name, value] : option_values(usual)) defaults[name] = value;
  std::string command = fmt::format(
      "{}{} --planner {} --seed {}", is_ours ? "vandplan plan " : "(your own planner) ",
      base::shell_file(report.files[run.scenario].file), base::shell_word(run.planner), run.seed);
  if (has_style) command += flag("style", "shortest");
  for (const auto& [name, value] : option_values(shown)) {
    const auto standard = defaults.find(name);
    if (name == "profile" || (standard != defaults.end() && standard->second == value)) continue;
    command += flag(name, value);
  }
  return command;
}

}  // namespace vandplan::evaluation
