// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Who wins, and what of the thesis' headline claims do the runs show?

#include <string>
#include <vector>

#include "evaluation/summary.h"

namespace vandplan::evaluation {

/// How the methods of the thesis treat the goal.
enum class GoalSetting {
  sampled,  ///< as the thesis prints it: the goal is a sample like others, drawn now and then
  tried,    ///< the goal is tried from every new node
};

/// "as printed" or "goal tried".
[[nodiscard]] const char* name_of(GoalSetting setting) noexcept;

/// Under what a claim is judged.
struct Circumstances {
  Region region = Region::bounds;
  GoalSetting setting = GoalSetting::sampled;
  bool operator==(const Circumstances&) const = default;
};

/// Whether a planner ranks by a table of the thesis and treats the goal so.
[[nodiscard]] bool is_table_under(const PlannerProperties& properties,
                                  GoalSetting setting) noexcept;

/// In how many scenarios a planner beats the one that ranks by Euclid.
struct Tally {
  std::string planner;
  PlannerProperties properties;
  int better = 0;
  int worse = 0;
  int no_difference = 0;
  int nothing_searched = 0;  ///< scenarios that say nothing about what ranks the nodes
};

/// For every planner that has a Euclid twin, in order of appearance.
[[nodiscard]] std::vector<Tally> tally(const Summary& summary, Region region,
                                       PairedComparison TwinComparison::*measure);

/// A claim of the thesis about its tables, and what was found under some circumstances.
struct Finding {
  Circumstances where;
  std::string claim;
  bool holds = false;
  std::string found;
  std::string why = {};  ///< sentences, from the runs
};

/// Three claims under all circumstances that were run, the printed setting first: better in six of
/// nine scenarios, up to 20 % less time, up to 90 % better paths. Nothing where no table was run
/// beside its Euclid twin.
[[nodiscard]] std::vector<Finding> findings(const Summary& summary,
                                            const std::vector<ScenarioFile>& scenarios);

/// Where each claim holds: one sentence a claim.
[[nodiscard]] std::vector<std::string> verdicts(const std::vector<Finding>& findings);

/// The shortest answer for a region in short sentences: who ends with the best paths, and what the
/// thesis' tables gain over Euclid in each setting. Empty if the region was not run.
[[nodiscard]] std::string headline(const Summary& summary,
                                   const std::vector<ScenarioFile>& scenarios, Region region);

/// A ratio as a change, "-12 %", "+3.4 %", "x 8.1", "from unsolved to solved".
[[nodiscard]] std::string change_text(double ratio);

}  // namespace vandplan::evaluation
