// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Who wins, and what of the thesis' headline claims do the runs show?

#include <string>
#include <vector>

#include "evaluation/summary.h"

namespace vandplan {

/// In how many scenarios a planner beats the one that ranks by Euclid.
struct Tally {
  std::string planner;
  int better = 0;
  int worse = 0;
  int no_difference = 0;
};

/// For every planner that has a Euclid twin, in order of appearance.
[[nodiscard]] std::vector<Tally> tally(const Summary& summary, Region region,
                                       PairedComparison TwinComparison::*measure);

/// A claim of the thesis about its table, and what was found in one region.
struct Finding {
  Region region = Region::bounds;
  std::string claim;
  bool holds = false;
  std::string found;
  std::string why = {};  ///< sentences, from the runs
};

/// Three claims in each region that was run: better in six of nine scenarios, up to 20 % less
/// time, up to 90 % better paths. Nothing where no table was run beside its Euclid twin.
[[nodiscard]] std::vector<Finding> findings(const Summary& summary,
                                            const std::vector<Scenario>& scenarios);

/// The shortest answer for a region, one or two sentences: who ends with the best paths, and how
/// often the thesis' tables beat Euclid. Empty if the region was not run.
[[nodiscard]] std::string headline(const Summary& summary, Region region);

/// A ratio as a change, "-12 %", "+3.4 %", "x 8.1", "from unsolved to solved".
[[nodiscard]] std::string change_text(double ratio);

}  // namespace vandplan
