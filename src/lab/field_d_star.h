// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Plans a Field D* route for a disc, along which the vehicle then drives.

#include "vandplan/planner.h"

namespace vandplan::field_d_star {

/// The planner "field-d-star". Method: docs/algorithms/field_d_star.md.
[[nodiscard]] Planner planner();

}  // namespace vandplan::field_d_star
