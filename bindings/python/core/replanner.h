// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do replanners and drives with replanning share in Python?

#include <pybind11/pybind11.h>

#include <memory>

#include "bindings/python/core/scenario.h"
#include "bindings/python/core/site.h"
#include "vandplan/replanner.h"

namespace vandplan::python {

/// Moves the keywords of replanning from `keywords` to `options`. Returns the table of the site.
std::shared_ptr<SharedSiteTable> take_replan_options(pybind11::dict& keywords,
                                                     ReplanOptions& options);

/// Options of the plans; all keywords left over are options of the default planner.
[[nodiscard]] PlanOptions replanned_options(pybind11::dict& keywords,
                                            const CheckedScenario& scenario);

/// Action as a dict of t, steering_angle, v and a.
[[nodiscard]] pybind11::dict action_dict(const Action& action);

}  // namespace vandplan::python
