// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Python propose paths while the default planner runs?

#include <pybind11/pybind11.h>

#include "vandplan/planner.h"

namespace vandplan::python {

/// Function of a planner with sources. Its Python functions cannot be pickled.
struct SourcesFunction {
  PlannerFunction function;
  PlannerAnswer operator()(const Task& task, const PlanOptions& options) const {
    return function(task, options);
  }
};

/// Adds `with_sources` to the module.
void bind_path_source(pybind11::module_& module);

}  // namespace vandplan::python
