// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Python see the result of a run?

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "bindings/python/core/scenario.h"
#include "vandplan/draw.h"
#include "vandplan/result_file.h"

namespace vandplan::python {

/// Result with its scenario, planner and options; `Result` in Python.
struct RunResult {
  CheckedScenario scenario;
  std::shared_ptr<const Planner> planner;  ///< Null if the result was read from a file or a pickle.
  ResultRecord record;
  /// Options without the planner: a dict or None.
  pybind11::object known_options = pybind11::none();
};

/// Options that were in force, a dict by name; None if they are unknown.
[[nodiscard]] pybind11::object result_options(const RunResult& result);

/// Adds pickling and copying to the class of results.
void pickle_result(pybind11::class_<RunResult>& result);

/// Claims of a result about its path, as its file would state them.
[[nodiscard]] PathClaims claims_of(const RunResult& result);

/// Drawing of a scenario and, unless it is null, a result.
[[nodiscard]] Drawing drawing_of(const CheckedScenario& scenario, const RunResult* result);

/// Path of a result or a drive, or a path itself. Throws InputError naming "path" if there is none.
[[nodiscard]] const Path& path_from(const pybind11::handle& given);

}  // namespace vandplan::python
