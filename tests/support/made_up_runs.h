// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Runs and scenarios that nobody had to wait for.

#include <optional>
#include <string>

#include "evaluation/run_record.h"
#include "vandplan/files.h"

namespace vandplan::evaluation {

/// Open ground with one goal, or with a row of goals 20 m, 40 m, ... away.
inline ScenarioFile open_ground(const std::string& name, int goals_in_row = 0) {
  ScenarioFile file;
  file.scenario.name = name;
  file.scenario.bounds = {-200.0, 200.0, -200.0, 200.0};
  file.scenario.start = {10.0, 20.0, 0.5};
  file.scenario.goal = {40.0, 30.0, 1.0};
  for (int i = 1; i <= goals_in_row; ++i)
    file.row.push_back({20.0 * i, {10.0 + 20.0 * i, 20.0, 0.0}, {}});
  if (file.is_row()) file.scenario.goal = file.row.front().goal;
  return file;
}

/// A run that took 0.1 s and found a path of this cost after `time`, or none.
inline RunRecord made_up_run(const std::string& planner, std::uint64_t seed,
                             std::optional<double> cost, double time = 0.001) {
  RunRecord run;
  run.planner = planner;
  run.seed = seed;
  PlanOptions options;
  options.budget.time_limit = 0.1;
  options.planner.set("max_nodes", std::int64_t{5000});
  run.options = options;
  run.started = "2026-11-21T05:16:33Z";
  run.result.status = cost ? PlanStatus::solved : PlanStatus::time_limit;
  run.result.time_total = 0.1;
  run.result.iterations = 1000;
  run.result.counters = {{"nodes", 900}, {"exact_solves", 3000}};
  if (!cost) return run;
  run.result.path = Path{{10.0, 20.0, 0.5}, {{0.0, *cost}}};
  run.result.cost = *cost;
  run.result.anytime = {{time, 10, 2.0 * *cost}, {2.0 * time, 20, *cost}};
  return run;
}

}  // namespace vandplan::evaluation
