// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Python see a table of a site?

#include <pybind11/pybind11.h>

#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan::python {

/// Planner function that begins with the way of a table.
struct SiteFunction {
  SiteTable table;
  PlannerFunction function;
  PlannerAnswer operator()(const Task& task, const PlanOptions& options) const {
    return function(task, options);
  }
};

/// The planner of `with_site`, with a `SiteFunction`.
[[nodiscard]] Planner site_planner(const SiteTable& table);

}  // namespace vandplan::python
