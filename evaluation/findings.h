// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which planner wins, and which claims of the thesis do the runs confirm?

#include <string>
#include <vector>

#include "evaluation/summary.h"

namespace vandplan::evaluation {

/// How the methods of the thesis treat the goal.
enum class GoalSetting {
  sampled,  ///< as printed in the thesis: the goal is a sample like others, drawn now and then
  tried,    ///< the goal is tried from every new node
};

/// Name of a setting: "as printed" or "goal tried".
[[nodiscard]] const char* name_of(GoalSetting setting) noexcept;

/// Circumstances under which a claim is judged.
struct Circumstances {
  Region region = Region::bounds;
  GoalSetting setting = GoalSetting::sampled;
  bool operator==(const Circumstances&) const = default;
};

/// Whether a planner ranks nodes by a table of the thesis and treats the goal as in `setting`.
[[nodiscard]] bool is_table_under(const PlannerProperties& properties,
                                  GoalSetting setting) noexcept;

/// In how many scenarios a planner beats its Euclid twin (`euclid_twin`).
struct Tally {
  std::string planner;
  PlannerProperties properties;
  int better = 0;
  int worse = 0;
  int no_difference = 0;
  int nothing_searched = 0;  ///< scenarios whose paths were found without a search
};

/// Tallies of all planners with a Euclid twin, in order of appearance.
[[nodiscard]] std::vector<Tally> tally(const Summary& summary, Region region,
                                       PairedComparison TwinComparison::*measure);

/// A claim of the thesis about its tables, and the result under some circumstances.
struct Finding {
  Circumstances where;
  std::string claim;
  bool holds = false;
  std::string found;
  std::string why = {};  ///< explanation from the runs, in sentences
};

/// Findings on three claims under all circumstances that were run, the printed setting first. The
/// claims are: better paths in six of nine scenarios, up to 20 % less time, up to 90 % better
/// paths. Empty if no table was run beside its Euclid twin.
[[nodiscard]] std::vector<Finding> findings(const Summary& summary,
                                            const std::vector<ScenarioFile>& scenarios);

/// One sentence for each claim: where it holds.
[[nodiscard]] std::vector<std::string> verdicts(const std::vector<Finding>& findings);

/// Short summary for a region: which planner ends with the best paths, and what the thesis' tables
/// gain over Euclid in each setting. Empty if the region was not run.
[[nodiscard]] std::string headline(const Summary& summary,
                                   const std::vector<ScenarioFile>& scenarios, Region region);

/// Text of a ratio as a change: "-12 %", "+3.4 %", "x 8.1", "from unsolved to solved".
[[nodiscard]] std::string change_text(double ratio);

}  // namespace vandplan::evaluation
