// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are many starts and goals planned in one world?

#include <optional>
#include <string>

#include "vandplan/evaluation.h"
#include "vandplan/planner.h"
#include "vandplan/scenario_file.h"

namespace vandplan::app {

struct PosesJob {
  std::string poses;                  ///< file of starts and goals
  std::optional<std::string> output;  ///< for the results (JSON Lines)
  int jobs = 1;                       ///< plans at a time; >= 1
  /// Only those pairs that fall into it, by a hash of start and goal.
  std::optional<evaluation::Shard> shard;
  bool json = false;  ///< print the results instead of a summary
};

/// Plans all pairs in the world of a scenario, prints a line for each, in their order and with its
/// number among all of them, and how many there were. Returns the exit status: 0 if all of them are
/// solved.
[[nodiscard]] int plan_poses(const ScenarioProblems& read, const Planner& planner,
                             const PlanOptions& options, const PosesJob& job);

}  // namespace vandplan::app
