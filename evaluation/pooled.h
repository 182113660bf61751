// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Which planners beat their Euclid twins over all scenarios of a region together?

#include <string>
#include <vector>

#include "evaluation/summary.h"

namespace vandplan::evaluation {

/// A planner against its Euclid twin: cost at the end, pair by pair.
struct Pooled {
  std::string planner;
  PlannerProperties properties;
  int runs = 0;
  int solved = 0;
  int twin_runs = 0;
  int twin_solved = 0;
  int pairs = 0;
  int cheaper = 0;     ///< number of pairs in which the planner is cheaper
  int dearer = 0;      ///< number of pairs in which the planner is dearer; other pairs are equal
  double ratio = 1.0;  ///< cost over that of the twin, median over the pairs
  double exact_solves = 0.0;  ///< exact lengths per iteration, median over the scenarios
  /// Verdict of the sign test on the pairs that differ. All verdicts of one setting hold together.
  PairedComparison::Verdict verdict = PairedComparison::Verdict::no_difference;
};

/// Comparisons of all planners with a Euclid twin, in order of appearance.
[[nodiscard]] std::vector<Pooled> pooled(const Summary& summary, Region region);

}  // namespace vandplan::evaluation
