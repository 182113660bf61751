// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/reasons.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluation/methods.h"
#include "vandplan/tables.h"

namespace vandplan::evaluation {
namespace {

constexpr int number_of_tables = 4;

// Strategies with a Euclid twin, in order of appearance.
std::vector<std::string> strategies_of(const Summary& summary) {
  std::vector<std::string> found;
  for (const ScenarioSummary& scenario : summary.scenarios) {
    for (const TwinComparison& twins : scenario.twins) {
      if (std::ranges::find(found, twins.properties.strategy) == found.end())
        found.push_back(twins.properties.strategy);
    }
  }
  return found;
}

const MethodSummary* method_of(const ScenarioSummary& scenario, const std::string& planner) {
  const auto found = std::ranges::find(scenario.methods, planner, &MethodSummary::planner);
  return found == scenario.methods.end() ? nullptr : &*found;
}

// Figures of tables and of Euclid, over all scenarios of a region and all tables of a strategy.
struct Effect {
  int pairs = 0, better = 0, worse = 0;
  int runs = 0, solved = 0, twin_runs = 0, twin_solved = 0;
  std::vector<double> slower;                 // time of an iteration, relative to Euclid
  std::vector<double> ranking, twin_ranking;  // shares of ranking in the time
  std::vector<double> solves, twin_solves;    // exact lengths per iteration
};

void add(const MethodSummary& method, const MethodSummary& twin, Effect& effect) {
  effect.runs += method.runs;
  effect.solved += method.solved;
  effect.twin_runs += twin.runs;
  effect.twin_solved += twin.solved;
  if (method.phases && twin.phases) {
    effect.ranking.push_back(method.phases->ranking);
    effect.twin_ranking.push_back(twin.phases->ranking);
  }
  if (method.iterations == 0.0 || twin.iterations == 0.0) return;
  const double time = method.time_total / method.iterations;
  const double twin_time = twin.time_total / twin.iterations;
  if (twin_time > 0.0 && std::isfinite(twin_time)) effect.slower.push_back(time / twin_time);
  effect.solves.push_back(method.exact_solves / method.iterations);
  effect.twin_solves.push_back(twin.exact_solves / twin.iterations);
}

void add(const ScenarioSummary& scenario, const TwinComparison& twins, Effect& effect) {
  effect.pairs += twins.cost.pairs;
  for (const double ratio : twins.cost_ratios) {
    effect.better += ratio < 1.0;
    effect.worse += ratio > 1.0;
  }
  add(*method_of(scenario, twins.planner), *method_of(scenario, twins.twin), effect);
}

Effect effect_of(const Summary& summary, const Circumstances& where, const std::string& strategy) {
  Effect effect;
  for (const ScenarioSummary& scenario : summary.scenarios) {
    if (scenario.region != where.region) continue;
    for (const TwinComparison& twins : scenario.twins) {
      const bool counts = is_table_under(twins.properties, where.setting) &&
                          twins.properties.strategy == strategy && twins.cost.pairs != 0;
      if (counts) add(scenario, twins, effect);
    }
  }
  return effect;
}

double middle(std::vector<double> values) {
  std::ranges::sort(values);
  return quantile(values, 0.5);
}

// One sentence for each strategy that was run, after its name.
template <class Sentence>
std::string for_each_strategy(const Summary& summary, const Circumstances& where,
                              Sentence sentence) {
  std::string text;
  for (const std::string& strategy : strategies_of(summary)) {
    const Effect effect = effect_of(summary, where, strategy);
    if (effect.pairs == 0) continue;
    text += (text.empty() ? "" : " ") + upper(strategy) + ": " + sentence(effect) + ".";
  }
  return text;
}

double percent(int part, int whole) { return 100.0 * part / whole; }

double share_within(double extent, double side) {
  const double outside = std::max(0.0, 1.0 - extent / side);
  return 1.0 - outside * outside;
}

}  // namespace

double table_coverage(const Problem& problem, Region region, int number) {
  const HeuristicTableOptions table = thesis_table_options(number);
  const double radius = problem.vehicle().min_turning_radius;
  const double extent = table.extent * radius / table.turning_radius;
  const Bounds box = sampling_region(problem.task(), region);
  return share_within(extent, box.x_max - box.x_min) * share_within(extent, box.y_max - box.y_min);
}

std::string reason_for_paths(const Summary& summary, const std::vector<ScenarioFile>& scenarios,
                             const Circumstances& where) {
  std::vector<double> least, most;
  for (const ScenarioSummary& scenario : summary.scenarios) {
    if (scenario.region != where.region) continue;
    const Problem problem = make_problem(scenario_at(scenarios[scenario.scenario], 0));
    std::vector<double> shares;
    for (int number = 1; number <= number_of_tables; ++number)
      shares.push_back(table_coverage(problem, where.region, number));
    least.push_back(std::ranges::min(shares));
    most.push_back(std::ranges::max(shares));
  }
  const std::string counts = for_each_strategy(summary, where, [](const Effect& effect) {
    return fmt::format(
        "of {} pairs {:.0f} % end better, {:.0f} % worse, {:.0f} % with exactly the cost of Euclid",
        effect.pairs, percent(effect.better, effect.pairs), percent(effect.worse, effect.pairs),
        percent(effect.pairs - effect.better - effect.worse, effect.pairs));
  });
  return counts + fmt::format(
                      " The tables have entries for {:.2g} to {:.2g} % of the pairs of samples"
                      " (median scenario) and are Euclid for the others.",
                      100.0 * middle(least), 100.0 * middle(most));
}

std::string reason_for_times(const Summary& summary, const Circumstances& where) {
  return for_each_strategy(summary, where, [](const Effect& effect) {
    std::string text;
    if (!effect.slower.empty()) {
      text = fmt::format(
          "an iteration takes {:.2f} times as long as with Euclid and solves {:.1f} exact lengths"
          " instead of {:.1f}",
          middle(effect.slower), middle(effect.solves), middle(effect.twin_solves));
    }
    if (!effect.ranking.empty()) {
      text += fmt::format("{}ranking is {:.0f} % of the time instead of {:.0f} %",
                          text.empty() ? "" : "; ", 100.0 * middle(effect.ranking),
                          100.0 * middle(effect.twin_ranking));
    }
    return text;
  });
}

std::string reason_for_gains(const Summary& summary, const Circumstances& where) {
  return for_each_strategy(summary, where, [](const Effect& effect) {
    return fmt::format("{:.0f} % of the runs are solved with a table, {:.0f} % with Euclid",
                       percent(effect.solved, effect.runs),
                       percent(effect.twin_solved, effect.twin_runs));
  });
}

}  // namespace vandplan::evaluation
