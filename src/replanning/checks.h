// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is what a caller gives to a replanner of any use?
//
// All functions throw InputError naming what is wrong.

#include "vandplan/replanner.h"

namespace vandplan::replanning {

void check_options(const ReplanOptions& options);
/// Checks that the replanner honours everything that the vehicle has.
void check_vehicle_of(const Scenario& scenario);
/// Checks a measured state of the vehicle of a problem on its way to the goal.
void check_state(const VehicleState& state, const Problem& problem);
void check_limit(const TickLimit& limit);

}  // namespace vandplan::replanning
