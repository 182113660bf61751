// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Under which options were the runs of a report made?

#include <string>
#include <utility>
#include <vector>

#include "evaluation/run_record.h"

namespace vandplan::evaluation {

/// The options of the runs of a comparison, but for seed, region and profile. Values are JSON.
struct ReportOptions {
  /// Options that are the same for every planner that has them. Values that differ between vehicles
  /// are joined in one text, "2.5 or 5, by the vehicle".
  std::vector<std::pair<std::string, std::string>> shared;
  /// The others: a value, and the planners that have it.
  struct Own {
    std::string name;
    std::string value;
    std::vector<std::string> planners;
  };
  std::vector<Own> differing;
};

[[nodiscard]] ReportOptions options_of(const std::vector<RunRecord>& runs);

/// The options of a run, but for seed, region and profile, as text: only runs with equal options
/// are told of together.
struct ComparableOptions {
  std::string of_planner;  ///< equal in all runs of a planner
  std::string of_vehicle;  ///< equal in all runs of a planner with equal vehicles
};

[[nodiscard]] ComparableOptions comparable_options(const PlanOptions& options);

}  // namespace vandplan::evaluation
