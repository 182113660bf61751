// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/pooled.h"

#include <algorithm>
#include <map>

namespace vandplan::evaluation {
namespace {

// Values of a planner, collected over scenarios.
struct Gathered {
  std::vector<double> ratios;
  std::vector<double> exact_solves;
};

const MethodSummary& method_named(const ScenarioSummary& scenario, const std::string& planner) {
  return *std::ranges::find(scenario.methods, planner, &MethodSummary::planner);
}

void add(const ScenarioSummary& scenario, const TwinComparison& twins, Pooled& pooled,
         Gathered& gathered) {
  const MethodSummary& method = method_named(scenario, twins.planner);
  const MethodSummary& twin = method_named(scenario, twins.twin);
  pooled.runs += method.runs;
  pooled.solved += method.solved;
  pooled.twin_runs += twin.runs;
  pooled.twin_solved += twin.solved;
  if (method.iterations > 0.0)
    gathered.exact_solves.push_back(method.exact_solves / method.iterations);
  gathered.ratios.insert(gathered.ratios.end(), twins.cost_ratios.begin(), twins.cost_ratios.end());
}

void conclude(Gathered gathered, double level, Pooled& pooled) {
  std::ranges::sort(gathered.ratios);
  pooled.pairs = static_cast<int>(gathered.ratios.size());
  pooled.cheaper = static_cast<int>(
      std::ranges::count_if(gathered.ratios, [](double ratio) { return ratio < 1.0; }));
  pooled.dearer = static_cast<int>(
      std::ranges::count_if(gathered.ratios, [](double ratio) { return ratio > 1.0; }));
  pooled.ratio = quantile(gathered.ratios, 0.5);
  std::ranges::sort(gathered.exact_solves);
  if (!gathered.exact_solves.empty()) pooled.exact_solves = quantile(gathered.exact_solves, 0.5);
  const int differ = pooled.cheaper + pooled.dearer;
  if (differ == 0) return;
  const Interval share = share_interval(pooled.cheaper, differ, level);
  if (share.low > 0.5) pooled.verdict = PairedComparison::Verdict::smaller;
  if (share.high < 0.5) pooled.verdict = PairedComparison::Verdict::larger;
}

}  // namespace

std::vector<Pooled> pooled(const Summary& summary, Region region) {
  std::vector<Pooled> found;
  std::map<std::string, Gathered> gathered;
  for (const ScenarioSummary& scenario : summary.scenarios) {
    if (scenario.region != region) continue;
    for (const TwinComparison& twins : scenario.twins) {
      if (twins.cost_ratios.empty()) continue;
      auto same = std::ranges::find(found, twins.planner, &Pooled::planner);
      if (same == found.end()) same = found.insert(same, Pooled{twins.planner, twins.properties});
      add(scenario, twins, *same, gathered[twins.planner]);
    }
  }
  for (Pooled& planner : found) {
    const auto alike = std::ranges::count_if(found, [&](const Pooled& other) {
      return other.properties.tries_goal == planner.properties.tries_goal;
    });
    const double level = 1.0 - (1.0 - confidence) / static_cast<double>(alike);
    conclude(gathered[planner.planner], level, planner);
  }
  return found;
}

}  // namespace vandplan::evaluation
