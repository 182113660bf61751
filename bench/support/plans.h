// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do benchmarks set options of plans, and read what plans cost?

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "vandplan/planner.h"

namespace vandplan {

/// Time or cost of what did not happen.
inline constexpr double never = std::numeric_limits<double>::infinity();

/// Sets what "name=value" says. False if it says no such thing; throws InputError for a bad value.
inline bool set_option(PlanOptions& options, std::string_view text) {
  const std::size_t equals = text.find('=');
  const CommonOption* const option = find_common_option(text.substr(0, equals));
  if (equals == std::string_view::npos || option == nullptr) return false;
  option->set(options, text.substr(equals + 1));
  return true;
}

/// Cost of the best path at `time` [s]; `never` while there was none.
inline double cost_at(const PlanResult& result, double time) {
  double cost = never;
  for (const CostSample& sample : result.anytime) {
    if (sample.time <= time) cost = sample.cost;
  }
  return cost;
}

/// The value that a share of the others, 0 to 1, does not exceed; `never` without values.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return never;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace vandplan
