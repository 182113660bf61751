// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/exports.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>
#include <utility>

#include "base/escape.h"
#include "evaluation/methods.h"
#include "evaluation/options_json.h"
#include "evaluation/report_json.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

using Json = OrderedJson;

std::string csv_line(const RunRecord& run, const StoredScenario& scenario,
                     const Environment& environment) {
  const PlanResult& result = run.result;
  const auto when_solved = [&](auto value) {
    return result.path ? fmt::format("{}", value) : std::string();
  };
  const auto counted = [&](std::string_view name) {
    const auto found = std::ranges::find(result.counters, name, &Counter::name);
    return found == result.counters.end() ? std::string() : fmt::format("{}", found->value);
  };
  const auto measured = [&](std::string_view name) {
    const auto found = std::ranges::find(result.phases, name, &PhaseTime::name);
    return found == result.phases.end() ? std::string() : fmt::format("{}", found->seconds);
  };
  return fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
      base::csv_cell(scenario.name), run.goal, base::csv_cell(run.planner), name_of(run.region),
      run.seed, name_of(result.status), base::csv_cell(result.reason), when_solved(result.cost),
      when_solved(result.path ? gear_changes(result.path->segments) : 0),
      result.anytime.empty() ? "" : fmt::format("{}", result.anytime.front().time),
      result.time_total, result.iterations, counted("nodes"), counted("exact_solves"),
      counted("edge_checks"), measured("ranking"), measured("steering"), measured("checking"),
      run.jobs, run.started, base::csv_cell(options_to_json(*run.options)),
      base::csv_cell(environment.processor), environment.executable);
}

Json run_json(const RunRecord& run) {
  const PlanResult& result = run.result;
  Json anytime = Json::array();
  for (const CostSample& sample : result.anytime) {
    anytime.push_back(
        {{"time", sample.time}, {"iteration", sample.iteration}, {"cost", sample.cost}});
  }
  Json json = {{"environment", run.environment},
               {"scenario", run.scenario},
               {"goal", run.goal},
               {"planner", run.planner},
               {"region", name_of(run.region)},
               {"options", Json::parse(options_to_json(*run.options))},
               {"seed", run.seed},
               {"jobs", run.jobs},
               {"started", run.started},
               {"status", name_of(result.status)},
               {"iterations", result.iterations},
               {"time", {{"total", result.time_total}}},
               {"anytime", anytime}};
  for (const Counter& counter : result.counters) json[counter.name] = counter.value;
  for (const PhaseTime& phase : result.phases) json["time"][phase.name] = phase.seconds;
  if (!result.reason.empty()) json["reason"] = result.reason;
  if (!result.path) return json;
  const Pose& start = result.path->start;
  Json segments = Json::array();
  for (const Segment& segment : result.path->segments) {
    Json item = {{"curvature", segment.curvature}, {"length", segment.length}};
    if (segment.curvature_rate != 0.0) item["curvature_rate"] = segment.curvature_rate;
    segments.push_back(std::move(item));
  }
  json["cost"] = result.cost;
  json["path"] = {{"start", {{"x", start.x}, {"y", start.y}, {"heading", start.heading}}},
                  {"segments", segments}};
  return json;
}

// ---- OMPL ----

// Tables and columns that ompl_benchmark_statistics.py makes and Planner Arena reads. The first
// twelve columns of experiments are fixed; further columns are parameters of the problem.
constexpr const char* ompl_tables = R"(
CREATE TABLE experiments(
  id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512), totaltime REAL, timelimit REAL,
  memorylimit REAL, runcount INTEGER, version VARCHAR(128), hostname VARCHAR(1024), cpuinfo TEXT,
  date DATETIME, seed INTEGER, setup TEXT, region VARCHAR(16), distance REAL);
CREATE TABLE plannerConfigs(
  id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512) NOT NULL, settings TEXT);
CREATE TABLE enums(
  name VARCHAR(512), value INTEGER, description TEXT, PRIMARY KEY(name, value));
CREATE TABLE runs(
  id INTEGER PRIMARY KEY AUTOINCREMENT, experimentid INTEGER, plannerid INTEGER, time REAL,
  solved BOOLEAN, status ENUM, solution_length REAL, time_of_first_solution REAL,
  gear_changes INTEGER, graph_states INTEGER, iterations INTEGER, random_seed INTEGER,
  FOREIGN KEY(experimentid) REFERENCES experiments(id) ON DELETE CASCADE,
  FOREIGN KEY(plannerid) REFERENCES plannerConfigs(id) ON DELETE CASCADE);
CREATE TABLE progress(
  runid INTEGER, time REAL, best_cost REAL, PRIMARY KEY(runid, time),
  FOREIGN KEY(runid) REFERENCES runs(id) ON DELETE CASCADE);
)";

class OmplWriter {
 public:
  OmplWriter(Database& database, Store& store)
      : database_(database), environments_(store.environments()), files_(store.scenarios()) {
    for (const StoredScenario& file : files_) scenarios_.push_back(scenario_of(file));
    for (const PlanStatus status : plan_statuses()) {
      Statement(database_, "INSERT INTO enums VALUES ('status', ?, ?)")
          .run(static_cast<int>(status), name_of(status));
    }
  }

  void add(const RunRecord& run) {
    const PlanResult& result = run.result;
    std::optional<double> length, first, changes;
    if (result.path) {
      length = result.cost;
      if (!result.anytime.empty()) first = result.anytime.front().time;
      changes = gear_changes(result.path->segments);
    }
    Statement(database_, "INSERT INTO runs VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .run(experiment_of(run), planner_of(run), result.time_total,
             static_cast<int>(result.path.has_value()), static_cast<int>(result.status), length,
             first, changes, counter(result, "nodes"), result.iterations,
             static_cast<std::int64_t>(run.seed));
    const std::int64_t id = database_.last_id();
    Statement insert(database_, "INSERT OR REPLACE INTO progress VALUES (?, ?, ?)");
    for (const CostSample& sample : result.anytime) insert.run(id, sample.time, sample.cost);
  }

 private:
  std::int64_t experiment_of(const RunRecord& run) {
    const auto key = std::tuple(run.environment, run.scenario, run.goal, run.region,
                                run.options->budget.time_limit);
    std::int64_t& id = experiments_[key];
    if (id == 0) {
      const Environment& here = environments_[run.environment];
      const ScenarioFile& scenario = scenarios_[run.scenario];
      std::optional<double> distance;
      if (scenario.is_row()) distance = scenario.row[run.goal].distance;
      Statement(database_,
                "INSERT INTO experiments VALUES"
                " (NULL, ?, NULL, ?, NULL, NULL, ?, '', ?, ?, 0, ?, ?, ?)")
          .run(files_[run.scenario].name, run.options->budget.time_limit,
               "vandplan " + here.version, here.processor, run.started, files_[run.scenario].yaml,
               name_of(run.region), distance);
      id = database_.last_id();
    }
    Statement(database_,
              "UPDATE experiments SET totaltime = ifnull(totaltime, 0) + ?,"
              " runcount = ifnull(runcount, 0) + 1 WHERE id = ?")
        .run(run.result.time_total, id);
    return id;
  }

  std::int64_t planner_of(const RunRecord& run) {
    PlanOptions options = *run.options;
    // The region is a parameter of the experiment, not of the planner.
    if (options.planner.find("region") != nullptr) {
      options.planner.set("region", std::string("bounds"));
    }
    const std::string settings = options_to_json(options);
    std::int64_t& id = planners_[{run.planner, settings}];
    if (id == 0) {
      Statement(database_, "INSERT INTO plannerConfigs VALUES (NULL, ?, ?)")
          .run(run.planner, settings);
      id = database_.last_id();
    }
    return id;
  }

  Database& database_;
  std::vector<Environment> environments_;
  std::vector<StoredScenario> files_;
  std::vector<ScenarioFile> scenarios_;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t, Region, std::optional<double>>,
           std::int64_t>
      experiments_;
  std::map<std::pair<std::string, std::string>, std::int64_t> planners_;
};

/// Copies a file with `FileWriter`, like every file that a user names.
void copy_through(const std::string& from, const std::string& to) {
  std::ifstream input(from, std::ios::binary);
  FileWriter output(to);
  std::string piece(std::size_t{1} << 20, '\0');
  while (input.read(piece.data(), static_cast<std::streamsize>(piece.size())), input.gcount() > 0) {
    output.write(std::string_view(piece).substr(0, static_cast<std::size_t>(input.gcount())));
  }
  if (input.bad()) throw InputError(from, "cannot read");
  output.commit();
}

}  // namespace

std::string runs_to_csv(Store& store) {
  const std::vector<StoredScenario> scenarios = store.scenarios();
  const std::vector<Environment> environments = store.environments();
  std::string csv =
      "scenario,goal,planner,region,seed,status,reason,cost [m],gear changes,time of first "
      "solution [s],"
      "time [s],iterations,nodes,exact solves,edge checks,time ranking [s],time steering [s],"
      "time checking [s],jobs,started,options,processor,executable\n";
  for (const RunRecord& run : store.runs())
    csv += csv_line(run, scenarios.at(run.scenario), environments.at(run.environment));
  return csv;
}

std::string runs_to_json(Store& store) {
  Json environments = Json::array(), scenarios = Json::array(), runs = Json::array();
  for (const Environment& environment : store.environments())
    environments.push_back(environment_json(environment));
  for (const StoredScenario& scenario : store.scenarios()) {
    scenarios.push_back(
        {{"name", scenario.name}, {"file", scenario.file}, {"yaml", scenario.yaml}});
  }
  for (const RunRecord& run : store.runs()) runs.push_back(run_json(run));
  const Json all = {{"format", "vandplan-runs/1"},
                    {"environments", environments},
                    {"scenarios", scenarios},
                    {"runs", runs}};
  return all.dump(1) + "\n";
}

void write_ompl_database(Store& store, const std::string& file) {
  expect_writable(file);
  const std::string unfinished = file + ".new";
  std::filesystem::remove(unfinished);
  {
    Database database(unfinished, Database::Mode::create);
    Transaction transaction(database);
    database.execute(ompl_tables);
    OmplWriter writer(database, store);
    for (const RunRecord& run : store.runs())
      if (!is_profiled(run)) writer.add(run);
    transaction.commit();
  }
  copy_through(unfinished, file);
  std::filesystem::remove(unfinished);
}

}  // namespace vandplan::evaluation
