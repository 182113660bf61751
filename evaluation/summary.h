// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do the runs of a comparison show?
//
// Unsolved runs have infinite cost and an infinite time of the first solution. Costs of a row of
// goals are per metre of the goal's distance, so that goals can be pooled.

#include <optional>
#include <string>
#include <vector>

#include "evaluation/run_record.h"
#include "evaluation/statistics.h"
#include "vandplan/files.h"
#include "vandplan/planner.h"

namespace vandplan::evaluation {

/// Confidence of every interval; for verdicts of comparisons it holds over all scenarios together.
inline constexpr double confidence = 0.95;

/// One planner's runs to one goal of a row.
struct GoalSummary {
  double distance = 0.0;  ///< distance of the goal from the start [m]
  int runs = 0;
  int solved = 0;
  double cost = 0.0;  ///< median cost at the end, not divided by the distance
};

/// Point of a curve over the times of a comparison.
struct CurvePoint {
  MedianEstimate cost;
  double solved = 0.0;  ///< share of runs that are solved
  Interval solved_interval;
};

/// Shares of the phases in the total time of profiled runs.
struct PhaseShares {
  double ranking = 0.0;
  double steering = 0.0;
  double checking = 0.0;
};

/// One planner on one scenario in one region.
struct MethodSummary {
  std::string planner;
  PlannerProperties properties;
  int runs = 0;
  int solved = 0;
  int rejected = 0;  ///< runs whose path the judge rejected
  int no_path = 0;   ///< runs that proved that no path exists
  Interval solved_interval;
  MedianEstimate first_time;  ///< time of the first solution [s]
  MedianEstimate cost_at_10ms;
  MedianEstimate cost_at_100ms;
  MedianEstimate cost_at_end;
  int full = 0;  ///< runs whose tree was full
  /// Cost at the end of runs whose tree was full; meaningless if `full` is 0.
  MedianEstimate cost_when_full;
  double time_total = 0.0;    ///< median of the total time [s]
  double nodes = 0.0;         ///< median of the nodes
  double iterations = 0.0;    ///< median of the iterations
  double exact_solves = 0.0;  ///< median of the exact lengths that were computed
  std::optional<PhaseShares> phases;
  std::vector<double> cost_quantiles;  ///< quantiles of the cost at the end: 0, 25, 50, 75, 100 %
  std::vector<CurvePoint> curve;
  std::vector<GoalSummary> goals;  ///< goals of a row; empty without a row
  /// Largest distance of a goal that more than half of its runs reached [m]; 0 if there is none.
  double furthest = 0.0;
  /// Indices of the run with the least cost and of the run with the median cost, if solved. With a
  /// row of goals they are runs to the furthest goal.
  std::optional<std::size_t> best;
  std::optional<std::size_t> typical;
};

/// A planner against its Euclid twin, pair by pair.
struct TwinComparison {
  std::string planner;
  PlannerProperties properties;  ///< properties of the planner
  std::string twin;
  PairedComparison first_time;
  PairedComparison time_total;
  PairedComparison cost;
  /// Ratio of the costs of each pair; 1 if both are unsolved.
  std::vector<double> cost_ratios = {};
};

struct ScenarioSummary {
  std::size_t scenario = 0;
  Region region = Region::bounds;
  std::vector<MethodSummary> methods;
  std::vector<TwinComparison> twins;
};

struct Summary {
  std::vector<double> times;               ///< times of the curves [s]
  std::vector<ScenarioSummary> scenarios;  ///< summaries of the scenarios, region by region
};

/// Summary of runs. They must have one environment and, for each planner, options that are equal
/// but for seed, region and profiling. `planners` gives the order and must contain the planners of
/// all runs.
[[nodiscard]] Summary summarize(const std::vector<ScenarioFile>& scenarios,
                                const std::vector<Planner>& planners,
                                const std::vector<RunRecord>& runs);

/// Time of the first solution [s]; infinite if there is none. Cost at a time, and at the end;
/// infinite if there is no path.
[[nodiscard]] double first_solution_time(const RunRecord& run) noexcept;
[[nodiscard]] double cost_at(const RunRecord& run, double time) noexcept;
[[nodiscard]] double final_cost(const RunRecord& run) noexcept;

}  // namespace vandplan::evaluation
