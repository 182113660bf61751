// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which rig is the table computed for while the library is built?

#include "vandplan/vehicle.h"

namespace vandplan::tables {

/// Dimensions of the catalogue's `tractor-semitrailer`, as far as steering uses them [m, rad].
[[nodiscard]] inline Vehicle rig_of_table() {
  Vehicle vehicle;
  vehicle.min_turning_radius = 5.871749125558551;
  vehicle.hitch = 0.6;
  vehicle.max_hitch_angle = 1.2;
  vehicle.trailer = Trailer{.wheelbase = 7.7};
  return vehicle;
}

}  // namespace vandplan::tables
