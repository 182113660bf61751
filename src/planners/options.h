// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which options does a planner honour, and what is in force?
//
// Most functions are public: planner.h.

#include "vandplan/planner.h"

namespace vandplan::planning {

/// Throws InputError for a planner that ignores moving obstacles. The text names the planners that
/// honour them.
[[noreturn]] void refuse_moving(const Planner& planner);

/// Throws InputError naming "zones" if a zone asks for gears or directions, and the planner does
/// not know in which gear the vehicle drives.
void expect_gears_in_zones(const Planner& planner, std::span<const Zone> zones);

/// Takes all prices back.
void unset_prices(PlanOptions& options);

}  // namespace vandplan::planning
