// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "tables/embedded_rig_table.h"

#include <algorithm>
#include <numbers>

#include "rig_entries.h"
#include "tables/rig_table.h"
#include "vandplan/input_error.h"
#include "vandplan/tables.h"
#include "vehicle/hitch_motion.h"

namespace vandplan {

RigTable embedded_rig_table(const Vehicle& vehicle) {
  if (!vehicle.trailer) throw InputError("vehicle.trailers", "are missing, expected one");
  const Vehicle made_for = tables::rig_of_table();
  return RigTable(made_for.max_hitch_angle, rig_table::entries)
      .scaled(vehicle.min_turning_radius / made_for.min_turning_radius);
}

double rig_length_bound(const Vehicle& vehicle, const State& from, const State& to) {
  if (!vehicle.trailer) throw InputError("vehicle.trailers", "are missing, expected one");
  const double of_tractor = length_bounds(from.pose, to.pose, vehicle.min_turning_radius).low;
  const vehicle::TrailerAlone trailer = vehicle::trailer_alone(vehicle);
  if (trailer.most_angle >= std::numbers::pi / 2) return of_tractor;
  const double of_trailer =
      length_bounds(trailer_pose(vehicle, from), trailer_pose(vehicle, to), trailer.radius).low;
  return std::max(of_tractor, of_trailer / trailer.most_way);
}

}  // namespace vandplan
