// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How fast may a vehicle be at each place of a path, whatever it does elsewhere?
//
// Speeds are kept squared: under constant acceleration their square is a line over the distance.

#include <span>
#include <vector>

#include "vandplan/speed.h"

namespace vandplan::speed {

/// A part of the path on which the square of the largest speed is a line.
struct Cap {
  double begin = 0.0;                        ///< driven distance [m]
  double end = 0.0;                          ///< > begin
  double first = 0.0;                        ///< largest speed^2 at `begin` [m^2/s^2]
  double last = 0.0;                         ///< and at `end`
  SpeedBound bound = SpeedBound::max_speed;  ///< where it comes from

  [[nodiscard]] double slope() const noexcept { return (last - first) / (end - begin); }
};

/// Adds the caps of a segment that begins `s` metres from the start: never above a limit, and at
/// most 0.1 % below in speed^2 wherever that can matter.
void add_caps(const Segment& segment, double s, const Vehicle& vehicle, std::vector<Cap>& caps);

}  // namespace vandplan::speed
