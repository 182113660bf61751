// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long does the fastest drive along a path take, in the eyes of the judge?

#include "judge/track.h"
#include "vandplan/vehicle.h"

namespace vandplan::judge {

/// That time without a limit of jerk [s], about 1e-4 of it too large or small: looked at in many
/// places of every stretch, the speed changing evenly in between. `start_curvature` is that of the
/// wheels before the drive [1/m].
[[nodiscard]] double drive_time(const Track& track, const Vehicle& vehicle, double start_curvature);

}  // namespace vandplan::judge
