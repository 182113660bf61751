// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Who beats its Euclid twin when all scenarios of a region are taken together?

#include <string>
#include <vector>

#include "evaluation/summary.h"

namespace vandplan::evaluation {

/// A planner against its Euclid twin in the cost at the end, pair by pair.
struct Pooled {
  std::string planner;
  PlannerProperties properties;
  int runs = 0;
  int solved = 0;
  int twin_runs = 0;
  int twin_solved = 0;
  int pairs = 0;
  int cheaper = 0;            ///< of the pairs
  int dearer = 0;             ///< of the pairs; the others are equal
  double ratio = 1.0;         ///< of the costs, median over the pairs
  double exact_solves = 0.0;  ///< for one iteration, median over the scenarios
  /// By the sign test on the pairs that differ; holds for all planners of one setting together.
  PairedComparison::Verdict verdict = PairedComparison::Verdict::no_difference;
};

/// For every planner with a Euclid twin, in order of appearance.
[[nodiscard]] std::vector<Pooled> pooled(const Summary& summary, Region region);

}  // namespace vandplan::evaluation
