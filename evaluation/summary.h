// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do the runs of a comparison show?
//
// Unsolved runs have infinite cost and infinite time of first solution. Costs of a row of goals
// count per metre of the goal's distance, so that goals can be taken together.

#include <optional>
#include <string>
#include <vector>

#include "evaluation/run_record.h"
#include "evaluation/statistics.h"
#include "vandplan/planner.h"
#include "vandplan/scenario_file.h"

namespace vandplan::evaluation {

/// Confidence of every interval; that of comparisons holds for all scenarios together.
inline constexpr double confidence = 0.95;

/// One goal of a row.
struct GoalSummary {
  double distance = 0.0;  ///< [m]
  int runs = 0;
  int solved = 0;
  double cost = 0.0;  ///< median at the end
};

/// A curve over the times of the comparison.
struct CurvePoint {
  MedianEstimate cost;
  double solved = 0.0;  ///< share
  Interval solved_interval;
};

/// Where the time goes, as shares of all; from profiled runs.
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
  int rejected = 0;  ///< by the judge
  int no_path = 0;   ///< runs that proved that there is none: an answer, too
  Interval solved_interval;
  MedianEstimate first_time;  ///< of the first solution [s]
  MedianEstimate cost_at_10ms;
  MedianEstimate cost_at_100ms;
  MedianEstimate cost_at_end;
  int full = 0;                   ///< runs whose tree was full
  MedianEstimate cost_when_full;  ///< of these runs, at the end; nothing when there are none
  double time_total = 0.0;        ///< median [s]
  double nodes = 0.0;             ///< median
  double iterations = 0.0;        ///< median
  double exact_solves = 0.0;      ///< median
  std::optional<PhaseShares> phases;
  std::vector<double> cost_quantiles;  ///< at the end: 0, 25, 50, 75, 100 %
  std::vector<CurvePoint> curve;
  std::vector<GoalSummary> goals;  ///< of a row
  /// The largest distance reached in more than half of its runs; 0 if none. [m]
  double furthest = 0.0;
  /// Which run found the least cost (of a row: at the furthest goal), and which is the middle one
  /// by cost, if it is solved: indices into the runs.
  std::optional<std::size_t> best;
  std::optional<std::size_t> typical;
};

/// A planner against the one that differs from it in ranking by Euclid only, pair by pair.
struct TwinComparison {
  std::string planner;
  PlannerProperties properties;  ///< of the planner
  std::string twin;
  PairedComparison first_time;
  PairedComparison time_total;
  PairedComparison cost;
  std::vector<double> cost_ratios = {};  ///< of each pair; 1 if both are unsolved
};

struct ScenarioSummary {
  std::size_t scenario = 0;
  Region region = Region::bounds;
  std::vector<MethodSummary> methods;
  std::vector<TwinComparison> twins;
};

struct Summary {
  std::vector<double> times;               ///< of the curves [s]
  std::vector<ScenarioSummary> scenarios;  ///< region by region
};

/// The runs must be of one environment and, planner by planner, but for seed, region and profiling
/// of equal options. The planners are shown in the order in which they are given; those of all runs
/// must be among them.
[[nodiscard]] Summary summarize(const std::vector<ScenarioFile>& scenarios,
                                const std::vector<Planner>& planners,
                                const std::vector<RunRecord>& runs);

/// Time of the first solution [s], and the cost at a time; infinite if there is none.
[[nodiscard]] double first_solution_time(const RunRecord& run) noexcept;
[[nodiscard]] double cost_at(const RunRecord& run, double time) noexcept;
[[nodiscard]] double final_cost(const RunRecord& run) noexcept;

}  // namespace vandplan::evaluation
