// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where does a path hit something, or come too near?

#include <optional>
#include <vector>

#include "judge/body.h"
#include "judge/fault.h"
#include "judge/track.h"
#include "vandplan/plan_options.h"

namespace vandplan::judge {

/// All bodies of a vehicle: tractor and trailer.
using Bodies = std::vector<Body>;

/// First collision along a path. Without one, `least` becomes the clearance [m].
[[nodiscard]] std::optional<Fault> first_collision(const Bodies& bodies, double& least);

/// First place along a path that is nearer to an obstacle than the stated margin, or its ramp,
/// allows.
[[nodiscard]] std::optional<Fault> too_near(const Track& track, const Bodies& bodies,
                                            const ClearanceOptions& stated);

}  // namespace vandplan::judge
