// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How good is each estimate in each search, and do the runs confirm the literature's claims?

#include <string>
#include <vector>

#include "evaluation/summary.h"

namespace vandplan::evaluation {

/// One search with one estimate, over all scenarios of a region. Costs are relative to the least
/// cost of any run to the same goal. Unsolved runs count as infinite.
struct MatrixCell {
  std::string planner;
  std::string search;
  std::string estimate;
  int runs = 0;
  int solved = 0;
  Interval solved_interval = {};
  MedianEstimate first_time = {};  ///< time of the first path [s]
  MedianEstimate first_work = {};  ///< iterations until the first path: expansions or samples
  MedianEstimate cost_at_10ms = {}, cost_at_100ms = {}, cost_at_1s = {};
};

/// Cells of a region, in the order of the planners. Empty unless a search was run with more than
/// one estimate.
[[nodiscard]] std::vector<MatrixCell> search_matrix(const std::vector<Planner>& planners,
                                                    const std::vector<RunRecord>& runs,
                                                    Region region);

/// A claim of the literature about two planners, and the results of the pairs of runs in a region.
struct LiteratureFinding {
  Region region = Region::bounds;
  std::string claim;    ///< claim and its source
  std::string planner;  ///< planner that is claimed to be better
  std::string rival;
  PairedComparison first_time = {};  ///< time of the first path: planner over rival
  PairedComparison first_work = {};
  PairedComparison cost = {};
  int solved = 0;  ///< solved runs of the planner
  int rival_solved = 0;
};

/// Findings on all claims whose two planners took part.
[[nodiscard]] std::vector<LiteratureFinding> literature_findings(
    const std::vector<Planner>& planners, const std::vector<RunRecord>& runs);

}  // namespace vandplan::evaluation
