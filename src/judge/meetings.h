// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which moving obstacles does a drive meet, in the eyes of the judge?
//
// Method: docs/algorithms/moving.md; proof: docs/proofs/moving.md.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "judge/clearance.h"
#include "judge/track.h"
#include "vandplan/motion.h"

namespace vandplan::judge {

/// State of a body at a time, with a bound of its speed for some time.
struct Moment {
  Position position;
  Real speed = 0;  ///< largest speed of the vehicle's rear axle before `until` [m/s]
  Real until = 0;  ///< end of the span in which `speed` holds; later than now [s]
};

/// Vehicle or trailer on a drive.
struct Driver {
  Outline body;
  Real swing = 1;  ///< upper bound of the motion of any point of the body per metre driven
  std::function<Moment(Real t)> where;  ///< state of the body at time t >= 0 [s]
};

/// First approach of a moving obstacle that is nearer than required.
struct Encounter {
  std::size_t obstacle = 0;
  Real t = 0;           ///< time of the approach [s]
  double distance = 0;  ///< distance at that time [m]
};

/// How near a body comes to moving obstacles.
struct Company {
  /// Least clearance [m]; at most 1 mm plus a twentieth too large; infinity without obstacles.
  double clearance = 0.0;
  std::optional<Encounter> too_near;  ///< first approach nearer than `kept`, or first contact
};

/// How near a body comes to moving obstacles, from time 0 until everything is at rest for ever.
/// Time steps are so short that no distance falls unseen below `kept` [m] by more than 1 mm. The
/// least known distance may be missed by 1 mm plus a twentieth. The vehicle stands from `end` on
/// [s].
[[nodiscard]] Company company_on(const Driver& driver, std::span<const MovingObstacle> moving,
                                 Real end, double kept);

}  // namespace vandplan::judge
