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
#include "vandplan/site_table.h"

namespace vandplan::python {

/// Keywords of every call that plans.
struct RunKeywords {
  std::optional<double> time_limit;  ///< Time limit [s].
  std::optional<std::int64_t> max_iterations;
  std::uint64_t seed = 1;
  pybind11::dict options;  ///< All other keywords, with the names of `--set`.
  std::optional<SiteTable> site = {};
};

/// Planner from a name, a `Planner`, or a function of a task.
[[nodiscard]] std::shared_ptr<const Planner> planner_from(const pybind11::handle& given);

/// Options for a vehicle, as the command line builds them: the planner's defaults, then those of
/// the scenario, then the keywords.
[[nodiscard]] PlanOptions options_for(const Planner& planner, std::span<const Setting> wanted,
                                      const RunKeywords& keywords, const Vehicle& vehicle);

/// Applies keywords on top of existing options.
void set_keywords(PlanOptions& options, const Planner& planner, const RunKeywords& keywords);

/// Python value as the text that `--set` takes.
[[nodiscard]] std::string typed(const pybind11::handle& value);

/// Names and values as text, without values that are None.
[[nodiscard]] std::vector<Setting> settings_from(const pybind11::dict& given);

/// Options in force: those of all planners and the planner's own.
[[nodiscard]] pybind11::dict dict_of(const Planner& planner, const PlanOptions& options);

/// For each option of all planners: its meaning, and the refusal of a wrong value, which names what
/// is right. Types are made of it (make_stub).
[[nodiscard]] pybind11::dict said_of_common_options();

/// Python value of a planner's own option.
[[nodiscard]] pybind11::object object_of(const OptionValue& value);

}  // namespace vandplan::python
