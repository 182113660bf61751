// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What came out of a run, in Python?

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "bindings/python/core/scenario.h"
#include "vandplan/result_file.h"

namespace vandplan::python {

/// A result with the scenario, planner and options that it belongs to.
struct RunResult {
  CheckedScenario scenario;
  std::shared_ptr<const Planner> planner;  ///< null if it was read from a file or a pickle
  ResultRecord record;
  pybind11::object known_options = pybind11::none();  ///< a dict without the planner, or None
};

/// Options that were in force, a dict by name; None if they are not known.
[[nodiscard]] pybind11::object result_options(const RunResult& result);

/// Lets results be pickled and copied.
void pickle_result(pybind11::class_<RunResult>& result);

/// What a result says about its path, as its file would.
[[nodiscard]] PathClaims claims_of(const RunResult& result);

/// The path of a result or of a drive, or a path itself. Throws InputError naming "path" where
/// there is none.
[[nodiscard]] const Path& path_from(const pybind11::handle& given);

}  // namespace vandplan::python
