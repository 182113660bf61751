// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which parts does the module consist of? Each function adds one.

#include <pybind11/pybind11.h>

namespace vandplan::python {

void bind_errors(pybind11::module_& module);
void bind_path(pybind11::module_& module);
void bind_lengths(pybind11::module_& module);
void bind_vehicle(pybind11::module_& module);
void bind_grid(pybind11::module_& module);
void bind_goal(pybind11::module_& module);
void bind_zone(pybind11::module_& module);
void bind_mask(pybind11::module_& module);
void bind_scenario(pybind11::module_& module);
void bind_moving(pybind11::module_& module);
void bind_check(pybind11::module_& module);
void bind_result(pybind11::module_& module);
void bind_own_planner(pybind11::module_& module);
void bind_site(pybind11::module_& module);
void bind_planning(pybind11::module_& module);
void bind_speed(pybind11::module_& module);
void bind_driving(pybind11::module_& module);
void bind_replan(pybind11::module_& module);
void bind_live(pybind11::module_& module);
void bind_evaluation(pybind11::module_& module);
/// Adds methods to classes of the other parts.
void bind_protocols(pybind11::module_& module);

/// Rewrites the first lines of all docstrings as signatures. Must be called last.
void sign_all(pybind11::module_& module);

}  // namespace vandplan::python
