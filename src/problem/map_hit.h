// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cell of the map does a standing vehicle hit?

#include <optional>
#include <string>

#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan::problem {

/// A blocked cell that a vehicle hits.
struct CellHit {
  std::string
      text;      ///< "occupied at x = 3.25, y = 4.75"; or "unknown", "beyond the edge of the map"
  Point middle;  ///< middle of the cell, in the scenario's frame [m]
};

/// The blocked cell under the vehicle or its trailer whose middle is nearest to the rear axle.
/// `state` is in the scenario's frame. None if the vehicle hits no cell.
[[nodiscard]] std::optional<CellHit> map_hit(const Problem& problem, const State& state);

}  // namespace vandplan::problem
