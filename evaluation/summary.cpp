// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "evaluation/methods.h"

namespace vandplan::evaluation {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();
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

// Divisor of a cost: in a row of goals the goal's distance [m], otherwise 1.
class CostUnit {
 public:
  explicit CostUnit(const ScenarioFile& scenario) : scenario_(scenario) {}
  double operator()(const RunRecord& run) const {
    return scenario_.is_row() ? scenario_.row[run.goal].distance : 1.0;
  }

 private:
  const ScenarioFile& scenario_;
};

double phase_time(const PlanResult& result, std::string_view name) {
  const auto found = std::ranges::find(result.phases, name, &PhaseTime::name);
  return found == result.phases.end() ? 0.0 : found->seconds;
}

// Shares of the phases in the total time of all profiled runs; none without a time.
std::optional<PhaseShares> phases_of(const Runs& profiled) {
  double total = 0.0;
  PhaseShares shares;
  for (const RunRecord* run : profiled) {
    total += run->result.time_total;
    shares.ranking += phase_time(run->result, "ranking");
    shares.steering += phase_time(run->result, "steering");
    shares.checking += phase_time(run->result, "checking");
  }
  if (total <= 0.0 || !std::isfinite(total)) return std::nullopt;
  return PhaseShares{shares.ranking / total, shares.steering / total, shares.checking / total};
}

// Whether the tree of a run has as many nodes as its planner allows.
bool is_full(const RunRecord& run) {
  const OptionValue* const limit = run.options->planner.find("max_nodes");
  const auto* const nodes = limit == nullptr ? nullptr : std::get_if<std::int64_t>(limit);
  return nodes != nullptr && counter(run.result, "nodes") >= *nodes;
}

std::vector<CurvePoint> curve_of(const Runs& runs, const CostUnit& unit,
                                 const std::vector<double>& times) {
  std::vector<CurvePoint> curve;
  const auto count = static_cast<int>(runs.size());
  for (const double time : times) {
    const std::vector<double> costs =
        values_of(runs, [&](const RunRecord& run) { return cost_at(run, time) / unit(run); });
    const auto solved = static_cast<int>(
        std::ranges::count_if(costs, [](double cost) { return cost < unreached; }));
    curve.push_back({median_of(costs, confidence), static_cast<double>(solved) / count,
                     share_interval(solved, count, confidence)});
  }
  return curve;
}

std::vector<GoalSummary> goals_of(const Runs& runs, const ScenarioFile& scenario) {
  std::vector<GoalSummary> goals;
  for (std::size_t i = 0; i < scenario.row.size(); ++i) {
    Runs of_goal;
    std::ranges::copy_if(runs, std::back_inserter(of_goal),
                         [&](const RunRecord* run) { return run->goal == i; });
    if (of_goal.empty()) continue;
    goals.push_back({scenario.row[i].distance, static_cast<int>(of_goal.size()),
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

// Picks the best and the median run; with a row of goals among the runs to the furthest goal.
void pick_examples(Runs runs, const ScenarioFile& scenario, const RunRecord* first,
                   MethodSummary& summary) {
  if (scenario.is_row()) {
    std::erase_if(runs, [&](const RunRecord* run) {
      return scenario.row[run->goal].distance != summary.furthest;
    });
  }
  if (runs.empty()) return;
  std::ranges::stable_sort(runs, {}, [](const RunRecord* run) { return final_cost(*run); });
  const RunRecord* const middle = runs[runs.size() / 2];
  if (runs.front()->result.path) summary.best = static_cast<std::size_t>(runs.front() - first);
  if (middle->result.path) summary.typical = static_cast<std::size_t>(middle - first);
}

// Summarizes the costs at 10 ms, at 100 ms, at the end, and of full trees.
void summarize_costs(const Runs& runs, const CostUnit& unit, MethodSummary& summary) {
  const auto cost_after = [&](double time) {
    return median_of(
        values_of(runs, [&](const RunRecord& run) { return cost_at(run, time) / unit(run); }),
        confidence);
  };
  const auto end_cost = [&](const RunRecord& run) { return final_cost(run) / unit(run); };
  summary.cost_at_10ms = cost_after(0.01);
  summary.cost_at_100ms = cost_after(0.1);
  std::vector<double> costs = values_of(runs, end_cost);
  summary.cost_at_end = median_of(costs, confidence);
  std::ranges::sort(costs);
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    summary.cost_quantiles.push_back(quantile(costs, share));
  Runs full;
  std::ranges::copy_if(runs, std::back_inserter(full),
                       [](const RunRecord* run) { return is_full(*run); });
  summary.full = static_cast<int>(full.size());
  if (!full.empty()) summary.cost_when_full = median_of(values_of(full, end_cost), confidence);
}

MethodSummary summarize_method(const Runs& runs, const Runs& profiled, const ScenarioFile& scenario,
                               const std::vector<double>& times) {
  const CostUnit unit(scenario);
  const auto counted = [&](const char* name) {
    return plain_median(runs, [name](const RunRecord& run) {
      return static_cast<double>(counter(run.result, name));
    });
  };
  MethodSummary summary;
  summary.runs = static_cast<int>(runs.size());
  summary.solved = count_solved(runs);
  const auto ended = [&](PlanStatus status) {
    return static_cast<int>(std::ranges::count_if(
        runs, [status](const RunRecord* run) { return run->result.status == status; }));
  };
  summary.rejected = ended(PlanStatus::rejected);
  summary.no_path = ended(PlanStatus::no_path);
  summary.solved_interval = share_interval(summary.solved, summary.runs, confidence);
  summary.first_time = median_of(values_of(runs, first_solution_time), confidence);
  summarize_costs(runs, unit, summary);
  summary.time_total =
      plain_median(runs, [](const RunRecord& run) { return run.result.time_total; });
  summary.nodes = counted("nodes");
  summary.iterations = plain_median(
      runs, [](const RunRecord& run) { return static_cast<double>(run.result.iterations); });
  summary.exact_solves = counted("exact_solves");
  summary.phases = phases_of(profiled);
  summary.curve = curve_of(runs, unit, times);
  summary.goals = goals_of(runs, scenario);
  summary.furthest = furthest_of(summary.goals);
  return summary;
}

// Time from the first iteration to the first path [s]. The time for setting up a ranking is not
// counted.
double search_time(const RunRecord& run) {
  return first_solution_time(run) - phase_time(run.result, "setup");
}

// Runs of a planner and of its twin, in pairs of the same goal and seed.
struct Pairs {
  Runs first;
  Runs second;

  template <typename Holds>
  bool all(Holds holds) const {
    const auto of_run = [&](const RunRecord* run) { return holds(*run); };
    return std::ranges::all_of(first, of_run) && std::ranges::all_of(second, of_run);
  }
};

// Compares times in pairs. Times that differ by less than the set-up time of a run are equal.
template <typename Time>
PairedComparison compare_times(const Pairs& pairs, Time time) {
  std::vector<double> first = values_of(pairs.first, time);
  const std::vector<double> second = values_of(pairs.second, time);
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double set_up = std::max(phase_time(pairs.first[i]->result, "setup"),
                                   phase_time(pairs.second[i]->result, "setup"));
    if (std::abs(first[i] - second[i]) < set_up) first[i] = second[i];
  }
  return compare_pairs(first, second, confidence);
}

// Total time of a run, at most its limit: how late a planner notices the limit says nothing.
double run_time(const RunRecord& run) {
  return std::min(run.result.time_total, run.options->budget.time_limit.value_or(unreached));
}

// Whether the first iteration found a path: no tree had grown, so nothing was ranked.
bool is_found_at_once(const RunRecord& run) {
  return !run.result.anytime.empty() && run.result.anytime.front().iteration <= 1;
}

bool is_never_improved(const RunRecord& run) { return run.result.anytime.size() == 1; }

TwinComparison compare_twins(const Runs& runs, const Runs& twin_runs) {
  std::map<std::pair<std::size_t, std::uint64_t>, const RunRecord*> by_seed;
  for (const RunRecord* run : twin_runs) by_seed[{run->goal, run->seed}] = run;
  Pairs pairs;
  for (const RunRecord* run : runs) {
    const auto found = by_seed.find({run->goal, run->seed});
    if (found == by_seed.end()) continue;
    pairs.first.push_back(run);
    pairs.second.push_back(found->second);
  }
  TwinComparison twins;
  twins.first_time = compare_times(pairs, search_time);
  twins.time_total = compare_times(pairs, run_time);
  twins.cost = compare_pairs(values_of(pairs.first, final_cost),
                             values_of(pairs.second, final_cost), confidence);
  if (!pairs.first.empty() && pairs.all(is_found_at_once)) {
    twins.first_time.verdict = PairedComparison::Verdict::nothing_searched;
    if (pairs.all(is_never_improved))
      twins.cost.verdict = PairedComparison::Verdict::nothing_searched;
  }
  for (std::size_t i = 0; i < pairs.first.size(); ++i) {
    const double cost = final_cost(*pairs.first[i]), twin_cost = final_cost(*pairs.second[i]);
    twins.cost_ratios.push_back(cost == twin_cost ? 1.0 : cost / twin_cost);
  }
  return twins;
}

// Corrects the verdicts so that they hold for all comparisons together.
void judge(std::vector<ScenarioSummary>& scenarios) {
  std::vector<PairedComparison*> all;
  for (ScenarioSummary& scenario : scenarios) {
    for (TwinComparison& twins : scenario.twins)
      all.insert(all.end(), {&twins.cost, &twins.first_time, &twins.time_total});
  }
  judge_together(all, confidence);
}

// Runs of one planner in one scenario and region.
struct Group {
  Runs timed;
  Runs profiled;
};
using Groups = std::map<std::pair<std::size_t, Region>, std::map<std::string, Group>>;

Groups grouped(const std::vector<RunRecord>& runs) {
  Groups groups;
  for (const RunRecord& run : runs) {
    Group& group = groups[{run.scenario, run.region}][run.planner];
    (is_profiled(run) ? group.profiled : group.timed).push_back(&run);
  }
  return groups;
}

// Times of the curves: logarithmically spaced, from a thousandth of the longest run to all of it.
std::vector<double> curve_times(const std::vector<RunRecord>& runs) {
  double last = 0.0;
  for (const RunRecord& run : runs)
    last = std::max(last, run.options->budget.time_limit.value_or(run.result.time_total));
  std::vector<double> times;
  if (!std::isfinite(last)) return times;  // the store has no times
  for (int i = 1; i <= curve_points; ++i)
    times.push_back(last * std::pow(10.0, 3.0 * i / curve_points - 3.0));
  return times;
}

}  // namespace

Summary summarize(const std::vector<ScenarioFile>& scenarios, const std::vector<Planner>& planners,
                  const std::vector<RunRecord>& runs) {
  Summary summary{curve_times(runs), {}};
  for (const auto& [key, methods] : grouped(runs)) {
    const auto& [scenario, region] = key;
    ScenarioSummary found{scenario, region, {}, {}};
    for (const Planner& planner : planners) {
      const auto group = methods.find(planner.name);
      if (group == methods.end() || group->second.timed.empty()) continue;
      const Runs& timed = group->second.timed;
      MethodSummary method =
          summarize_method(timed, group->second.profiled, scenarios[scenario], summary.times);
      method.planner = planner.name;
      method.properties = planner.properties;
      pick_examples(timed, scenarios[scenario], runs.data(), method);
      found.methods.push_back(std::move(method));
      const Planner* const twin = euclid_twin(planner, planners);
      if (twin == nullptr || !methods.contains(twin->name)) continue;
      TwinComparison twins = compare_twins(timed, methods.at(twin->name).timed);
      twins.planner = planner.name;
      twins.properties = planner.properties;
      twins.twin = twin->name;
      found.twins.push_back(std::move(twins));
    }
    summary.scenarios.push_back(std::move(found));
  }
  judge(summary.scenarios);
  std::ranges::stable_sort(summary.scenarios, {}, &ScenarioSummary::region);
  return summary;
}

double first_solution_time(const RunRecord& run) noexcept {
  return run.result.anytime.empty() ? unreached : run.result.anytime.front().time;
}

double cost_at(const RunRecord& run, double time) noexcept {
  double cost = unreached;
  for (const CostSample& sample : run.result.anytime)
    if (sample.time <= time) cost = sample.cost;
  return cost;
}

double final_cost(const RunRecord& run) noexcept {
  return run.result.path ? run.result.cost : unreached;
}

}  // namespace vandplan::evaluation
