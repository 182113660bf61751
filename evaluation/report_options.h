// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Which options did the runs of a report have?

#include <string>
#include <utility>
#include <vector>

#include "evaluation/run_record.h"

namespace vandplan::evaluation {

/// Options of the runs of a comparison, without seed, region and profile. Values are JSON.
struct ReportOptions {
  /// Options that are equal for all planners that have them. Values that differ between vehicles
  /// are joined in one text: "2.5 or 5, by the vehicle".
  std::vector<std::pair<std::string, std::string>> shared;
  /// Option that differs between planners: one value, and the planners with that value.
  struct Own {
    std::string name;
    std::string value;
    std::vector<std::string> planners;
  };
  std::vector<Own> differing;
};

[[nodiscard]] ReportOptions options_of(const std::vector<RunRecord>& runs);

/// Options of a run as text, without seed, region and profile. A report contains only runs with
/// equal options.
struct ComparableOptions {
  std::string of_planner;  ///< options that are equal in all runs of a planner
  std::string of_vehicle;  ///< options that are equal in all runs of a planner with equal vehicles
};

[[nodiscard]] ComparableOptions comparable_options(const PlanOptions& options);

}  // namespace vandplan::evaluation
