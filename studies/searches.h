// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do planners search? Side by side, in the order in which they looked around.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "studies/study_files.h"
#include "vandplan/planner.h"

namespace vandplan::studies {

struct SearchesOptions {
  std::int64_t iterations = 1000;  ///< of each run; what one is differs from planner to planner
  std::uint64_t seed = 1;
};

/// A scenario that is searched.
struct SearchedScenario {
  std::string name;
  Scenario scenario;
};

/// What one planner did in one of them.
struct Searched {
  std::size_t scenario = 0;  ///< position in the study's list
  std::string planner;
  PlanResult result;
};

struct SearchesStudy {
  SearchesOptions options = {};
  std::vector<SearchedScenario> scenarios = {};
  std::vector<Searched> runs = {};  ///< planner by planner, each in all scenarios
};

/// H shape and cage to cage, of the thesis.
[[nodiscard]] std::vector<SearchedScenario> searched_scenarios();

/// The planners of the library that are drawn: those of the group "family", and what to compare
/// them with.
[[nodiscard]] std::vector<Planner> searching_planners();

[[nodiscard]] SearchesStudy study_searches(const SearchesOptions& options);

[[nodiscard]] StudyFiles files_of(const SearchesStudy& study);

}  // namespace vandplan::studies
