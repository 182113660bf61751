// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How fast may a vehicle be at each place of a path, whatever its speed elsewhere?
//
// Speeds are kept squared: under constant acceleration their square is linear in the distance.

#include <cstddef>
#include <span>
#include <vector>

#include "vandplan/motion.h"

namespace vandplan::speed {

/// Part of a path on which the square of the largest speed is linear in the distance.
struct Cap {
  double begin = 0.0;  ///< distance from the start of the path to the begin of the part [m]
  double end = 0.0;  ///< distance from the start of the path to the end of the part [m]; > `begin`
  double first = 0.0;                        ///< largest speed^2 at `begin` [m^2/s^2]
  double last = 0.0;                         ///< largest speed^2 at `end` [m^2/s^2]
  SpeedBound bound = SpeedBound::max_speed;  ///< limit that determines the speed

  [[nodiscard]] double slope() const noexcept { return (last - first) / (end - begin); }
};

/// Appends the caps of a segment that begins `s` metres from the start. They are never above a
/// limit of the vehicle, and at most 0.1 % below it in speed^2 wherever that can matter.
void add_caps(const Segment& segment, double s, const Vehicle& vehicle, std::vector<Cap>& caps);

/// Lowers the caps from number `first` on to the limits of places. Caps count from `origin` metres
/// after the start of the path.
void keep_limits(std::span<const SpeedLimit> limits, double origin, std::size_t first,
                 std::vector<Cap>& caps);

}  // namespace vandplan::speed
