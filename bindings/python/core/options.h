// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which planner is meant, and how do keywords become its options?

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "vandplan/planner.h"

namespace vandplan::python {

/// What every call that plans takes.
struct RunKeywords {
  std::optional<double> time;  ///< [s]
  std::optional<std::int64_t> max_iterations;
  std::uint64_t seed = 1;
  pybind11::dict options;  ///< any others, by the names of `--set`
};

/// A planner by its name, one of `Planner`, or a function of a task.
[[nodiscard]] std::shared_ptr<const Planner> planner_from(const pybind11::handle& given);

/// Options for a vehicle as the command line makes them: the planner's defaults, then what the
/// scenario wants, then the keywords.
[[nodiscard]] PlanOptions options_for(const Planner& planner, std::span<const Setting> wanted,
                                      const RunKeywords& keywords, const Vehicle& vehicle);

/// Sets keywords above the options that there are.
void set_keywords(PlanOptions& options, const Planner& planner, const RunKeywords& keywords);

/// A value of Python as the text that `--set` takes.
[[nodiscard]] std::string typed(const pybind11::handle& value);

/// Names and values as text; without those that are None.
[[nodiscard]] std::vector<Setting> settings_from(const pybind11::dict& given);

/// Options that are in force, those of all planners and the planner's own.
[[nodiscard]] pybind11::dict dict_of(const Planner& planner, const PlanOptions& options);

/// The value of a planner's own option.
[[nodiscard]] pybind11::object object_of(const OptionValue& value);

}  // namespace vandplan::python
