// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How sharply does the vehicle of a test turn?

#include "vandplan/vehicle.h"

namespace vandplan {

/// Smallest turning radius of the default vehicle [m].
inline constexpr double default_radius = Vehicle{}.min_turning_radius;

}  // namespace vandplan
