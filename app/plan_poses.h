// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are many starts and goals planned in one world?

#include <optional>
#include <string>

#include "vandplan/evaluation.h"
#include "vandplan/files.h"
#include "vandplan/planner.h"

namespace vandplan::app {

/// Arguments of `plan --poses`.
struct PosesJob {
  std::string poses;                  ///< file of starts and goals
  std::optional<std::string> site;    ///< file of the table of the site in the options
  std::optional<std::string> output;  ///< file of the results (JSON Lines or binary)
  int jobs = 1;                       ///< pairs planned at once; >= 1
  /// Part of the pairs that is planned, chosen by a hash of start and goal. None: all pairs.
  std::optional<evaluation::Shard> shard;
  bool json = false;  ///< whether results are printed instead of a summary
};

/// Plans all pairs in the world of a scenario. Prints a line for each pair, numbered as in the
/// file and in this order, then totals. Returns the exit status: 0 if all pairs are solved.
[[nodiscard]] int plan_poses(const ScenarioProblems& read, const Planner& planner,
                             const PlanOptions& options, const PosesJob& job);

}  // namespace vandplan::app
