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

MeanFrame mean_frame(const Pose& from, const Pose& to, double radius) noexcept {
  constexpr double two_pi = 2 * std::numbers::pi;
  constexpr double round = 0x1.8p52;  // adding it leaves no bits behind the point
  const double difference = to.heading - from.heading;
  const double sum = to.heading + from.heading;
  const double shifted = difference * (1 / two_pi) + round;
  const double turns = shifted - round;
  double turn = difference - turns * two_pi;
  if (turns != 0.0 && std::abs(turn) <= std::numeric_limits<double>::epsilon() *
                                            (std::abs(from.heading) + std::abs(to.heading))) {
    turn = 0.0;  // what rounding left of whole turns
  }
  const auto [sin, cos] = base::sin_cos(sum / 2);
  // An odd number of whole turns between the headings leaves their mean pointing backwards.
  const bool odd = (std::bit_cast<std::uint64_t>(shifted) & 1) != 0;
  const double scale = odd ? -radius : radius;
  const double dx = (to.x - from.x) / scale;
  const double dy = (to.y - from.y) / scale;
  return {dx * cos + dy * sin, dy * cos - dx * sin, turn / 2};
}

}  // namespace vandplan::steering
