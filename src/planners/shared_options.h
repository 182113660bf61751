// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which options do several planners have?

#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// "region": where samples are drawn.
[[nodiscard]] OptionInfo region_option();

/// The region that complete options name.
[[nodiscard]] Region region_of(const PlanOptions& options);

}  // namespace vandplan::planning
