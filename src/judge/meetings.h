// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Who is met on a drive, in the eyes of the judge?
//
// Method and proof: docs/algorithms/moving.md.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "judge/clearance.h"
#include "judge/track.h"
#include "vandplan/moving.h"

namespace vandplan::judge {

/// Where a body of the vehicle is at a time, and for how long what is said of its speed holds.
struct Moment {
  Position position;
  Real speed = 0;  ///< of the rear axle of the vehicle until `until`, at most [m/s]
  Real until = 0;  ///< a later time [s]
};

/// The vehicle on its drive, or its trailer.
struct Driver {
  Outline body;
  Real swing = 1;                       ///< no point of it moves further for each metre driven [m]
  std::function<Moment(Real t)> where;  ///< at any time from 0 on
};

/// The one who comes nearest first below what is to be kept.
struct Encounter {
  std::size_t obstacle = 0;
  Real t = 0;           ///< [s]
  double distance = 0;  ///< [m]
};

/// How near a body comes to what moves.
struct Company {
  double clearance = 0.0;  ///< least, too large by 1 mm and a twentieth at most [m]; or infinity
  std::optional<Encounter> too_near;  ///< the first one nearer than `kept`, or that touches
};

/// Looks wherever the distance may have become less by a millimetre than what is kept, or by that
/// and a twentieth than the least one known, from time 0 until all is at rest for ever. `end`: the
/// vehicle drives no longer [s].
[[nodiscard]] Company company_on(const Driver& driver, std::span<const MovingObstacle> moving,
                                 Real end, double kept);

}  // namespace vandplan::judge
