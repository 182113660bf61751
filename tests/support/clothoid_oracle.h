// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where does a segment whose curvature changes end?
//
// Slow and obvious: the heading in closed form, the position as the sum of many small steps along
// it, in extended precision.

#include <algorithm>
#include <cmath>

#include "support/draws.h"
#include "vandplan/path.h"
#include "vandplan/random.h"

namespace vandplan {

/// A position and a heading that is not wrapped.
struct SlowPose {
  long double x, y, heading;
};

/// In steps on which the heading turns by at most 1/32, each by three Gauss nodes: with that the
/// error is below 1e-15 of the length.
inline SlowPose slow_advance(const Pose& pose, const Segment& segment) {
  using Real = long double;
  const Real gear = segment.length < 0 ? -1 : 1;
  const Real length = std::abs(static_cast<Real>(segment.length));
  const Real first = segment.curvature;
  const Real rate = segment.curvature_rate;
  const auto heading = [&](Real t) { return pose.heading + gear * t * (first + rate * t / 2); };
  const Real steepest = std::max(std::abs(first), std::abs(first + rate * length));
  const auto steps = static_cast<long>(32 * length * (steepest + std::sqrt(std::abs(rate)))) + 1;
  const Real node = std::sqrt(Real{3} / 5);
  Real x = 0;
  Real y = 0;
  for (long i = 0; i < steps; ++i) {
    const Real half = length / static_cast<Real>(steps) / 2;
    const Real middle = (2 * static_cast<Real>(i) + 1) * half;
    for (const auto& [place, weight] : {std::pair<Real, Real>{-node, 5}, {0, 8}, {node, 5}}) {
      x += gear * weight / 9 * half * std::cos(heading(middle + place * half));
      y += gear * weight / 9 * half * std::sin(heading(middle + place * half));
    }
  }
  return {pose.x + x, pose.y + y, heading(length)};
}

/// Of any scale, through an inflection or not, with tiny and huge rates; its curvature times its
/// length is below about `most_turn`.
inline Segment any_clothoid(double most_turn, Rng& rng) {
  const double length = any_size(1e-3, 300, rng);
  const double turn = any_size(1e-3, most_turn, rng);
  const double least = chance(0.1, rng) ? 1e-300 : 1e-4;
  Segment segment{.length = any_sign(length, rng)};
  if (!chance(0.1, rng)) segment.curvature = any_sign(turn / length * uniform01(rng), rng);
  segment.curvature_rate = any_sign(turn / length / length * any_size(least, 2, rng), rng);
  return segment;
}

/// What vehicles drive: curvatures up to 0.25, mostly from one to another within metres.
inline Segment drivable_clothoid(Rng& rng) {
  const double first = chance(0.3, rng) ? 0 : uniform(-0.25, 0.25, rng);
  const double last = chance(0.3, rng) ? 0.25 : uniform(-0.25, 0.25, rng);
  const double length = any_size(0.05, 12, rng);
  return {first, any_sign(length, rng), (last - first) / length};
}

}  // namespace vandplan
