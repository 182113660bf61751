// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Between which poses are steering functions tested and timed?

#include <cmath>
#include <numbers>

#include "vandplan/path.h"
#include "vandplan/random.h"

namespace vandplan {

struct DrawnPair {
  Pose from;
  Pose to;
};

/// The second pose within `reach` of the first, which is anywhere.
inline DrawnPair near_pair(double reach, Rng& rng) {
  const Pose from = uniform_pose({-1000, 1000, -1000, 1000}, rng);
  Pose to = uniform_pose({-reach, reach, -reach, reach}, rng);
  to.x += from.x;
  to.y += from.y;
  return {from, to};
}

/// Whole metres and eighths of a turn, so that arcs vanish and words meet.
inline DrawnPair grid_pair(Rng& rng) {
  const auto whole = [&](int limit) {
    return static_cast<double>(static_cast<int>(rng() % (2 * static_cast<unsigned>(limit) + 1)) -
                               limit);
  };
  const double eighth = std::numbers::pi / 4;
  const Pose from{whole(10), whole(10), whole(4) * eighth};
  return {from, {whole(10), whole(10), whole(4) * eighth}};
}

/// The second pose at the end of a few turns and lines, many of them quarter turns: the ends of
/// words that lack a part lie on the border of other words.
inline DrawnPair border_pair(double radius, Rng& rng) {
  const double quarter = radius * std::numbers::pi / 2;
  const Pose from = uniform_pose({-100, 100, -100, 100}, rng);
  Pose to = from;
  const auto count = 1 + rng() % 4;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double curvature = (static_cast<double>(rng() % 3) - 1) / radius;
    const double length = rng() % 2 == 0 ? quarter : uniform(0, quarter, rng);
    to = advance(to, {curvature, rng() % 2 == 0 ? length : -length});
  }
  return {from, to};
}

/// Offsets from 2^-30 to 1, each of its own size.
inline DrawnPair tiny_pair(Rng& rng) {
  const Pose from{0, 0, uniform(-std::numbers::pi, std::numbers::pi, rng)};
  const auto offset = [&] {
    // One after the other: compilers draw two arguments in an order of their own.
    const int halvings = static_cast<int>(rng() % 31);
    return std::ldexp(uniform(-1, 1, rng), -halvings);
  };
  return {from, {offset(), offset(), from.heading + offset()}};
}

/// One of the above.
inline DrawnPair any_pair(double radius, Rng& rng) {
  switch (rng() % 5) {
    case 0:
      return near_pair(10, rng);
    case 1:
      return near_pair(200, rng);
    case 2:
      return grid_pair(rng);
    case 3:
      return border_pair(radius, rng);
    default:
      return tiny_pair(rng);
  }
}

}  // namespace vandplan
