// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does an exact length ever lie outside its bounds?

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "support/cases.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan {

/// Two poses and a turning radius.
struct BoundCase {
  Pose from, to;
  double radius;
};

/// False, with the case as C++, if the exact length lies outside.
inline bool expect_inside(const BoundCase& c) {
  const double length = reeds_shepp_length(c.from, c.to, c.radius);
  const auto [low, high] = length_bounds(c.from, c.to, c.radius);
  if (low <= length && length <= high) return true;
  ADD_FAILURE() << "expect_inside({" << as_code(c.from) << ", " << as_code(c.to) << ", "
                << as_code(c.radius) << "}): " << as_code(length) << " is not in "
                << braced({low, high});
  return false;
}

/// A pair at any distance, every power of ten from a millimetre to 1000 radii as likely as the
/// next; one in four with headings that almost agree or almost oppose.
inline BoundCase any_bound_case(Rng& rng) {
  constexpr double pi = std::numbers::pi;
  const double radius = uniform(0.5, 20.0, rng);
  const double distance = radius * std::pow(10.0, uniform(-3.0, 3.0, rng));
  const double bearing = uniform(-pi, pi, rng);
  const Pose from{uniform(-200.0, 200.0, rng), uniform(-200.0, 200.0, rng), uniform(-pi, pi, rng)};
  Pose to{from.x + distance * std::cos(bearing), from.y + distance * std::sin(bearing),
          uniform(-pi, pi, rng)};
  if (uniform01(rng) < 0.25) {
    const double turn = std::pow(10.0, uniform(-8.0, 0.0, rng));
    to.heading = from.heading + (uniform01(rng) < 0.5 ? turn : pi - turn);
  }
  return {from, to, radius};
}

/// `n` pairs, fewer under sanitizers; stops at the first one that is outside.
inline void expect_all_inside(std::uint64_t seed, int n) {
  Rng rng(seed);
  for (int i = 0; i < cases(n); ++i) {
    if (!expect_inside(any_bound_case(rng))) return;
  }
}

}  // namespace vandplan
