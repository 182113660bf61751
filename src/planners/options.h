// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which options does a planner honour, and what is in force?
//
// Most of that is public: planner.h.

#include "vandplan/planner.h"

namespace vandplan::planning {

/// Throws InputError that names the planners that plan among what moves.
[[noreturn]] void refuse_moving(const Planner& planner);

}  // namespace vandplan::planning
