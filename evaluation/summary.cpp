// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace vandplan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int curve_points = 60;

using Runs = std::vector<const RunRecord*>;

template <typename Value>
std::vector<double> values_of(const Runs& runs, Value value) {
  std::vector<double> values;
  for (const RunRecord* run : runs) values.push_back(value(*run));
  return values;
}

template <typename Value>
double plain_median(const Runs& runs, Value value) {
  return median_of(values_of(runs, value), confidence).median;
}

int count_solved(const Runs& runs) {
  return static_cast<int>(std::ranges::count_if(
      runs, [](const RunRecord* run) { return run->result.path.has_value(); }));
}

// By what a cost is divided: the distance of a goal in a row.
class CostUnit {
 public:
  explicit CostUnit(const Scenario& scenario) : scenario_(scenario) {}
  double operator()(const RunRecord& run) const {
    return scenario_.goals_are_a_row ? scenario_.goals[run.goal].distance.value_or(1.0) : 1.0;
  }

 private:
  const Scenario& scenario_;
};

// Shares of the time of all profiled runs together.
std::optional<PhaseShares> phases_of(const Runs& profiled) {
  double total = 0.0;
  PhaseShares shares;
  for (const RunRecord* run : profiled) {
    total += run->result.time_total;
    shares.ranking += run->result.time_ranking;
    shares.steering += run->result.time_steering;
    shares.checking += run->result.time_checking;
  }
  if (total <= 0.0) return std::nullopt;
  return PhaseShares{shares.ranking / total, shares.steering / total, shares.checking / total};
}

std::vector<CurvePoint> curve_of(const Runs& runs, const CostUnit& unit,
                                 const std::vector<double>& times) {
  std::vector<CurvePoint> curve;
  const auto count = static_cast<int>(runs.size());
  for (const double time : times) {
    const std::vector<double> costs =
        values_of(runs, [&](const RunRecord& run) { return cost_at(run, time) / unit(run); });
    const auto solved =
        static_cast<int>(std::ranges::count_if(costs, [](double cost) { return cost < infinity; }));
    curve.push_back({median_of(costs, confidence), static_cast<double>(solved) / count,
                     share_interval(solved, count, confidence)});
  }
  return curve;
}

std::vector<GoalSummary> goals_of(const Runs& runs, const Scenario& scenario) {
  std::vector<GoalSummary> goals;
  if (!scenario.goals_are_a_row) return goals;
  for (std::size_t i = 0; i < scenario.goals.size(); ++i) {
    Runs of_goal;
    std::ranges::copy_if(runs, std::back_inserter(of_goal),
                         [&](const RunRecord* run) { return run->goal == i; });
    if (of_goal.empty()) continue;
    goals.push_back({scenario.goals[i].distance.value_or(0.0), static_cast<int>(of_goal.size()),
                     count_solved(of_goal), plain_median(of_goal, final_cost)});
  }
  return goals;
}

double furthest_of(const std::vector<GoalSummary>& goals) {
  double furthest = 0.0;
  for (const GoalSummary& goal : goals)
    if (2 * goal.solved > goal.runs) furthest = std::max(furthest, goal.distance);
  return furthest;
}

// The best and the middle run; of a row, among those to its furthest goal.
void pick_examples(Runs runs, const Scenario& scenario, const RunRecord* first,
                   MethodSummary& summary) {
  if (scenario.goals_are_a_row)
    std::erase_if(runs, [&](const RunRecord* run) {
      return scenario.goals[run->goal].distance.value_or(0.0) != summary.furthest;
    });
  if (runs.empty()) return;
  std::ranges::stable_sort(runs, {}, [](const RunRecord* run) { return final_cost(*run); });
  const RunRecord* const middle = runs[runs.size() / 2];
  if (runs.front()->result.path) summary.best = static_cast<std::size_t>(runs.front() - first);
  if (middle->result.path) summary.typical = static_cast<std::size_t>(middle - first);
}

MethodSummary summarize_method(const Runs& runs, const Runs& profiled, const Scenario& scenario,
                               const std::vector<double>& times) {
  const CostUnit unit(scenario);
  const auto cost_after = [&](double time) {
    return median_of(
        values_of(runs, [&](const RunRecord& run) { return cost_at(run, time) / unit(run); }),
        confidence);
  };
  std::vector<double> costs =
      values_of(runs, [&](const RunRecord& run) { return final_cost(run) / unit(run); });
  Runs full;
  std::ranges::copy_if(runs, std::back_inserter(full), [](const RunRecord* run) {
    return run->result.nodes >= run->options.max_nodes;
  });
  MethodSummary summary;
  summary.planner = runs.front()->planner;
  summary.runs = static_cast<int>(runs.size());
  summary.solved = count_solved(runs);
  summary.solved_interval = share_interval(summary.solved, summary.runs, confidence);
  summary.first_time = median_of(values_of(runs, first_solution_time), confidence);
  summary.cost_at_10ms = cost_after(0.01);
  summary.cost_at_100ms = cost_after(0.1);
  summary.cost_at_end = median_of(costs, confidence);
  summary.full = static_cast<int>(full.size());
  if (!full.empty())
    summary.cost_when_full = median_of(
        values_of(full, [&](const RunRecord& run) { return final_cost(run) / unit(run); }),
        confidence);
  summary.time_total =
      plain_median(runs, [](const RunRecord& run) { return run.result.time_total; });
  summary.nodes = plain_median(
      runs, [](const RunRecord& run) { return static_cast<double>(run.result.nodes); });
  summary.iterations = plain_median(
      runs, [](const RunRecord& run) { return static_cast<double>(run.result.iterations); });
  summary.exact_solves = plain_median(
      runs, [](const RunRecord& run) { return static_cast<double>(run.result.exact_solves); });
  summary.phases = phases_of(profiled);
  std::ranges::sort(costs);
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    summary.cost_quantiles.push_back(quantile(costs, share));
  summary.curve = curve_of(runs, unit, times);
  summary.goals = goals_of(runs, scenario);
  summary.furthest = furthest_of(summary.goals);
  return summary;
}

// Pairs of runs of the same goal and seed.
TwinComparison compare_twins(const std::string& planner, const Runs& runs, const std::string& twin,
                             const Runs& twin_runs, double level) {
  std::map<std::pair<std::size_t, std::uint64_t>, const RunRecord*> by_seed;
  for (const RunRecord* run : twin_runs) by_seed[{run->goal, run->options.seed}] = run;
  Runs first, second;
  for (const RunRecord* run : runs) {
    const auto found = by_seed.find({run->goal, run->options.seed});
    if (found == by_seed.end()) continue;
    first.push_back(run);
    second.push_back(found->second);
  }
  const auto compare = [&](auto value) {
    return compare_pairs(values_of(first, value), values_of(second, value), level);
  };
  TwinComparison twins{planner, twin, compare(first_solution_time),
                       compare([](const RunRecord& run) { return run.result.time_total; }),
                       compare(final_cost)};
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double cost = final_cost(*first[i]), twin_cost = final_cost(*second[i]);
    twins.cost_ratios.push_back(cost == twin_cost ? 1.0 : cost / twin_cost);
  }
  return twins;
}

// Runs by scenario, region and planner.
struct Group {
  Runs timed;
  Runs profiled;
};
using Groups = std::map<std::pair<std::size_t, Region>, std::map<std::string, Group>>;

Groups grouped(const std::vector<RunRecord>& runs) {
  Groups groups;
  for (const RunRecord& run : runs) {
    Group& group = groups[{run.scenario, run.options.region}][run.planner];
    (run.options.profile ? group.profiled : group.timed).push_back(&run);
  }
  return groups;
}

// In the order of the documentation; planners that are not documented come last.
std::vector<std::string> ordered(const std::map<std::string, Group>& groups) {
  std::vector<std::string> names;
  for (const PlannerInfo& planner : planners())
    if (groups.contains(std::string(planner.name))) names.emplace_back(planner.name);
  for (const auto& [name, group] : groups)
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

// From a thousandth of the longest run to all of it, evenly on a logarithmic scale.
std::vector<double> curve_times(const std::vector<RunRecord>& runs) {
  double last = 0.0;
  for (const RunRecord& run : runs)
    last = std::max(last, run.options.time_limit.value_or(run.result.time_total));
  std::vector<double> times;
  for (int i = 1; i <= curve_points; ++i)
    times.push_back(last * std::pow(10.0, 3.0 * i / curve_points - 3.0));
  return times;
}

}  // namespace

Summary summarize(const std::vector<Scenario>& scenarios, const std::vector<RunRecord>& runs) {
  Summary summary{curve_times(runs), {}};
  const Groups groups = grouped(runs);
  const double level = 1.0 - (1.0 - confidence) / static_cast<double>(scenarios.size());
  for (const auto& [key, methods] : groups) {
    ScenarioSummary found{key.first, key.second, {}, {}};
    for (const std::string& name : ordered(methods)) {
      const Group& group = methods.at(name);
      if (group.timed.empty()) continue;
      MethodSummary method =
          summarize_method(group.timed, group.profiled, scenarios[key.first], summary.times);
      pick_examples(group.timed, scenarios[key.first], runs.data(), method);
      found.methods.push_back(std::move(method));
      const std::optional<std::string> twin = euclid_twin(name);
      if (twin && methods.contains(*twin))
        found.twins.push_back(
            compare_twins(name, group.timed, *twin, methods.at(*twin).timed, level));
    }
    summary.scenarios.push_back(std::move(found));
  }
  std::ranges::stable_sort(summary.scenarios, {}, &ScenarioSummary::region);
  return summary;
}

std::optional<std::string> euclid_twin(const std::string& planner) {
  for (const std::string strategy : {"rrt-bsc-", "rrt-opt-"})
    if (planner.starts_with(strategy) && planner != strategy + "euc") return strategy + "euc";
  return std::nullopt;
}

double first_solution_time(const RunRecord& run) noexcept {
  return run.result.anytime.empty() ? infinity : run.result.anytime.front().time;
}

double cost_at(const RunRecord& run, double time) noexcept {
  double cost = infinity;
  for (const CostSample& sample : run.result.anytime)
    if (sample.time <= time) cost = sample.cost;
  return cost;
}

double final_cost(const RunRecord& run) noexcept {
  return run.result.path ? run.result.cost : infinity;
}

}  // namespace vandplan
