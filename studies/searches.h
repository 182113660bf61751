// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// In which order do planners search the ground?

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "studies/study_files.h"
#include "vandplan/planner.h"

namespace vandplan::studies {

struct SearchesOptions {
  std::int64_t iterations = 1000;  ///< iterations of each run; their meaning depends on the planner
  std::uint64_t seed = 1;
};

/// Scenario that all planners search.
struct SearchedScenario {
  std::string name;
  Scenario scenario;
};

/// Run of one planner in one scenario.
struct Searched {
  std::size_t scenario = 0;  ///< index of the scenario in the study's list
  std::string planner;
  PlanResult result;
};

struct SearchesStudy {
  SearchesOptions options = {};
  std::vector<SearchedScenario> scenarios = {};
  std::vector<Searched> runs = {};  ///< runs planner by planner, each in all scenarios
};

/// Scenarios of the thesis: H shape, and cage to cage.
[[nodiscard]] std::vector<SearchedScenario> searched_scenarios();

/// Planners that are drawn: those of the library's group "family", and two to compare them with.
[[nodiscard]] std::vector<Planner> searching_planners();

[[nodiscard]] SearchesStudy study_searches(const SearchesOptions& options);

[[nodiscard]] StudyFiles files_of(const SearchesStudy& study);

}  // namespace vandplan::studies
