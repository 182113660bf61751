// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a vehicle where its drive has it?

#include "replanning/timed_path.h"
#include "vandplan/replanner.h"

namespace vandplan::replanning {

/// Hitch angle with which a rig is planned for [rad]. An angle up to 10 degrees beyond the limit is
/// the limit: measurements err. One further beyond stays.
[[nodiscard]] double planned_hitch_angle(const Vehicle& vehicle, double hitch_angle);

/// Whether a rig is folded beyond its limit, so that no drive begins there.
[[nodiscard]] bool is_folded_up(const Vehicle& vehicle, double hitch_angle);

/// Measured motion in the frame with that origin. Without a measured hitch angle it has that of
/// `planned`.
[[nodiscard]] RigMotion measured_motion(const Vehicle& vehicle, const VehicleState& state,
                                        const RigMotion& planned, const Point& origin);

/// Whether a vehicle is further from the planned motion than 0.5 m, 0.5 m/s or 10 degrees of the
/// heading or the hitch angle.
[[nodiscard]] bool is_off(const RigMotion& measured, const RigMotion& planned);

}  // namespace vandplan::replanning
