// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// May a path of continuous steering be driven, and does it lead where it should?

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "support/draws.h"
#include "support/leads.h"
#include "support/pair_cases.h"
#include "vandplan/steering.h"

namespace vandplan {

/// A steering value and two poses with curvatures that it takes.
struct ContinuousCase {
  ContinuousSteering steering;
  DrawnPair pair;
  ContinuousQuery query;
};

inline std::string as_code(const ContinuousCase& c) {
  const auto& s = c.steering;
  return (s.continuity() == Continuity::throughout ? "throughout " : "between stops ") +
         braced({s.radius(), s.curvature_rate()}) + " " + as_code(c.pair) + " curvatures " +
         braced({c.query.start_curvature, c.query.goal_curvature}) +
         (c.query.start_stands ? " stands" : " rolls") +
         (c.query.goal_stands ? ", stands" : ", rolls");
}

/// Whether the segments lead from pose to pose within the limits, without a jump where none may be.
inline testing::AssertionResult is_drivable(const Piece& piece, const ContinuousCase& c) {
  const double most = (1 + 1e-11) / c.steering.radius();
  const double rate = (1 + 1e-11) * c.steering.curvature_rate();
  const double smooth = 1e-10 / c.steering.radius();
  const bool throughout = c.steering.continuity() == Continuity::throughout;
  const bool rolls_first = throughout || !c.query.start_stands;
  const bool rolls_last = throughout || !c.query.goal_stands;
  const auto wrong = [&](const char* what) {
    return testing::AssertionFailure() << what << " " << as_code(piece.view());
  };
  Pose end = c.pair.from;
  double curvature = rolls_first ? c.query.start_curvature : c.query.goal_curvature;
  double gear = 0, sum = 0;
  for (const Segment& s : piece.view()) {
    const double last = s.curvature + s.curvature_rate * std::abs(s.length);
    if (!(std::abs(s.length) > 0)) return wrong("a segment of no length");
    if (!(std::abs(s.curvature) <= most && std::abs(last) <= most)) return wrong("too sharp");
    if (!(std::abs(s.curvature_rate) <= rate)) return wrong("too sudden");
    const bool rolls = gear == 0 ? rolls_first : throughout || gear * s.length > 0;
    if (rolls && std::abs(s.curvature - curvature) > smooth) return wrong("jumps");
    end = advance(end, s);
    curvature = last;
    gear = s.length;
    sum += std::abs(s.length);
  }
  if (rolls_last && std::abs(curvature - c.query.goal_curvature) > smooth) {
    return wrong("does not end with the curvature wanted");
  }
  if (std::abs(sum - piece.length) > 1e-10 * (c.steering.radius() + sum)) return wrong("length");
  const Pose& to = c.pair.to;
  const double turn = std::remainder(end.heading - to.heading, 2 * std::numbers::pi);
  if (std::abs(end.x - to.x) <= 1e-9 && std::abs(end.y - to.y) <= 1e-9 && std::abs(turn) <= 1e-9) {
    return testing::AssertionSuccess();
  }
  return wrong("leads elsewhere") << " to " << as_code(end);
}

/// Steering of any kind, from clothoids of centimetres to some that wind by more than half a turn.
inline ContinuousSteering any_steering(double radius, Rng& rng) {
  const double ramp = chance(0.1, rng) ? any_size(1, 10, rng) : any_size(1e-3, 1, rng);
  return {radius, 1 / (ramp * radius * radius),
          chance(0.5, rng) ? Continuity::throughout : Continuity::between_stops};
}

inline double any_curvature(double radius, Rng& rng) {
  const double kind = uniform01(rng);
  if (kind < 0.3) return 0;
  if (kind < 0.5) return any_sign(1 / radius, rng);
  return uniform(-1, 1, rng) / radius;
}

constexpr double law_radius = 7;

inline ContinuousCase any_case(Rng& rng) {
  const ContinuousSteering steering = any_steering(law_radius, rng);
  ContinuousCase c{steering, any_pair(law_radius, rng), {}};
  const bool between_stops = steering.continuity() == Continuity::between_stops;
  if (between_stops) {
    c.query.start_stands = chance(0.5, rng);
    c.query.goal_stands = chance(0.5, rng);
  }
  if (chance(between_stops ? 0.2 : 0.5, rng)) {
    c.query.start_curvature = any_curvature(law_radius, rng);
    c.query.goal_curvature = any_curvature(law_radius, rng);
  }
  return c;
}

/// Calls `law` for `n` cases, a hundred to each case of `for_each_case`.
template <typename Law>
void for_each_continuous_case(std::uint64_t seed, int n, Law law) {
  for_each_case(seed, n / 100, [&](Rng& rng) {
    for (int i = 0; i < 100; ++i) law(any_case(rng), rng);
  });
}

}  // namespace vandplan
