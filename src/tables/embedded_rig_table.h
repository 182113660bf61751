// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Of which rig is the table that is computed while the library is built?

#include "vandplan/vehicle.h"

namespace vandplan::tables {

/// What steering needs to know of the catalogue's `tractor-semitrailer`.
[[nodiscard]] inline Vehicle rig_of_table() {
  Vehicle vehicle;
  vehicle.min_turning_radius = 5.871749125558551;
  vehicle.hitch = 0.6;
  vehicle.max_hitch_angle = 1.2;
  vehicle.trailer = Trailer{.wheelbase = 7.7};
  return vehicle;
}

}  // namespace vandplan::tables
