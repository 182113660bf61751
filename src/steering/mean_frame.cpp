// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/mean_frame.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "base/trigonometry.h"

namespace vandplan::steering {

MeanHeading mean_heading(double from, double to) noexcept {
  constexpr double two_pi = 2 * std::numbers::pi;
  constexpr double round = 0x1.8p52;  // adding it rounds to a whole number
  const double difference = to - from;
  const double shifted = difference * (1 / two_pi) + round;
  const double turns = shifted - round;
  double turn = difference - turns * two_pi;
  if (turns != 0.0 &&
      std::abs(turn) <= std::numeric_limits<double>::epsilon() * (std::abs(from) + std::abs(to))) {
    turn = 0.0;  // what rounding left of whole turns
  }
  // An odd number of whole turns between the headings leaves their mean pointing backwards.
  const bool odd = (std::bit_cast<std::uint64_t>(shifted) & 1) != 0;
  return {(to + from) / 2, turn / 2, odd};
}

MeanFrame mean_frame(const Pose& from, const Pose& to, double radius, const MeanHeading& heading,
                     const base::SinCos& mean) noexcept {
  const auto [sin, cos] = mean;
  const double scale = heading.is_backwards ? -radius : radius;
  const double dx = (to.x - from.x) / scale;
  const double dy = (to.y - from.y) / scale;
  return {dx * cos + dy * sin, dy * cos - dx * sin, heading.half_turn};
}

MeanFrame mean_frame(const Pose& from, const Pose& to, double radius) noexcept {
  const MeanHeading heading = mean_heading(from.heading, to.heading);
  return mean_frame(from, to, radius, heading, base::sin_cos(heading.mean));
}

}  // namespace vandplan::steering
