// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long does the fastest drive along a path take, in the eyes of the judge?

#include <vector>

#include "judge/track.h"
#include "judge/zone_prices.h"
#include "vandplan/vehicle.h"

namespace vandplan::judge {

/// Duration of the fastest drive without jerk limit [s], with a relative error of about 1e-4. It
/// samples many places of every stretch; the square of the speed is linear between them.
/// `start_curvature` is the curvature of the wheels before the drive [1/m]. `parts`: limits of
/// zones. `stops`: places in order at which the vehicle stands besides.
[[nodiscard]] double drive_time(const Track& track, const Vehicle& vehicle, double start_curvature,
                                const std::vector<PricedPart>& parts = {},
                                const std::vector<Place>& stops = {});

}  // namespace vandplan::judge
