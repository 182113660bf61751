// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is an estimate worth in each search, and what do the runs say to the claims about it?

#include <string>
#include <vector>

#include "evaluation/summary.h"

namespace vandplan::evaluation {

/// One search with one estimate, all scenarios of a region together. Costs are over the least one
/// that any run of the comparison found to the same goal; unsolved runs count as infinite.
struct MatrixCell {
  std::string planner;
  std::string search;
  std::string estimate;
  int runs = 0;
  int solved = 0;
  Interval solved_interval = {};
  MedianEstimate first_time = {};  ///< of the first path [s]
  MedianEstimate first_work = {};  ///< iterations until the first path: expansions or samples
  MedianEstimate cost_at_10ms = {}, cost_at_100ms = {}, cost_at_1s = {};
};

/// The cells of a region in the order of the planners; empty unless some search was run with more
/// than one estimate.
[[nodiscard]] std::vector<MatrixCell> search_matrix(const std::vector<Planner>& planners,
                                                    const std::vector<RunRecord>& runs,
                                                    Region region);

/// A claim of the literature about two planners, and what the pairs of runs of a region say.
struct LiteratureFinding {
  Region region = Region::bounds;
  std::string claim;    ///< with its source
  std::string planner;  ///< that is said to be better
  std::string rival;
  PairedComparison first_time = {};  ///< of the planner over its rival's
  PairedComparison first_work = {};
  PairedComparison cost = {};
  int solved = 0;  ///< runs of the planner
  int rival_solved = 0;
};

/// The claims whose planners both took part.
[[nodiscard]] std::vector<LiteratureFinding> literature_findings(
    const std::vector<Planner>& planners, const std::vector<RunRecord>& runs);

}  // namespace vandplan::evaluation
