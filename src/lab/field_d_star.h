// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Plans by a route of any direction for a disc, which the vehicle then drives along.

#include "vandplan/planner.h"

namespace vandplan::field_d_star {

/// Name, properties, options and function: docs/algorithms/field_d_star.md.
[[nodiscard]] Planner planner();

}  // namespace vandplan::field_d_star
