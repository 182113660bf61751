// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a function of Python become a planner?

#include <pybind11/pybind11.h>

#include <memory>

#include "vandplan/planner.h"

namespace vandplan::python {

/// A planner that calls the function, without options of its own; its name is the function's.
[[nodiscard]] std::shared_ptr<const Planner> own_planner(const pybind11::function& function);

/// A function of Python that any thread may copy or let go: the last one takes Python's lock.
[[nodiscard]] std::shared_ptr<const pybind11::function> kept(const pybind11::function& function);

/// A function of Python as a planner's: takes Python's lock whenever it is called, copied or let
/// go, so that any thread may do so.
[[nodiscard]] PlannerFunction planner_function(const pybind11::function& function);

}  // namespace vandplan::python
