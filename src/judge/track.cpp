// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/track.h"

#include <algorithm>
#include <cmath>

namespace vandplan::judge {

namespace {

/// An angle as a number of quarter turns plus a rest. The rest is at most slightly more than an
/// eighth of a turn.
struct Quarters {
  double count = 0;
  Real left = 0;
};

/// Splits an angle. A quarter turn is the sum of two numbers; the first has so few digits that its
/// multiples are exact.
Quarters quarters_in(Real angle) {
  constexpr auto first = static_cast<Real>(1.57079637050628662109375L);
  constexpr auto second = static_cast<Real>(-4.371139000186242830836024856e-8L);
  const double count = std::nearbyint(static_cast<double>(angle) * (2 / std::numbers::pi));
  return {count, angle - count * first - count * second};
}

struct HeadingIntegral {
  Real x = 0;
  Real y = 0;
};

Direction turned(const Direction& from, const Direction& by) {
  return {from.cos * by.cos - from.sin * by.sin, from.sin * by.cos + from.cos * by.sin};
}

/// Placement on a circle: after a turn by 2a, the chord has length 2 sin(a) / curvature and points
/// along heading + a.
Placement after_arc(const Stretch& stretch, Real t) {
  const Real way = stretch.direction * t;
  const Real a = stretch.curvature * way / 2;
  const auto& [x, y, heading] = stretch.start;
  const Direction half = direction_of(a);
  const Real chord = a == 0 ? way : way * (half.sin / a);
  const Direction along = turned(stretch.ahead, half);
  return {{x + chord * along.cos, y + chord * along.sin, heading + 2 * a}, turned(along, half)};
}

/// Displacement of a vehicle after `t` metres, in the frame of its start. It turns by `turn` v +
/// `growth` v^2 / 2 within v metres. The power series of exp(i (turn v + growth v^2 / 2)) is
/// integrated term by term.
HeadingIntegral series(Real turn, Real growth, Real t) {
  constexpr int terms = 40;
  const Real first = turn * t;
  const Real second = growth * t * t;
  // Term n of the integrand is c_n (v / t)^n, and (n + 1) c_(n+1) = i (first c_n + second c_(n-1)).
  HeadingIntegral last;
  HeadingIntegral term{1, 0};
  HeadingIntegral sum = term;
  for (int n = 0; n < terms; ++n) {
    const HeadingIntegral next{-(first * term.y + second * last.y) / (n + 1),
                               (first * term.x + second * last.x) / (n + 1)};
    sum = {sum.x + next.x / (n + 2), sum.y + next.y / (n + 2)};
    last = term;
    term = next;
  }
  return {t * sum.x, t * sum.y};
}

Placement after_clothoid(const Stretch& stretch, Real t) {
  const auto& [x, y, heading] = stretch.start;
  const Real d = stretch.direction;
  const HeadingIntegral way = series(d * stretch.curvature, d * stretch.rate, t);
  const auto& [cos, sin] = stretch.ahead;
  const Real turn = d * t * (stretch.curvature + stretch.rate * t / 2);
  return {
      {x + d * (way.x * cos - way.y * sin), y + d * (way.x * sin + way.y * cos), heading + turn},
      turned(stretch.ahead, direction_of(turn))};
}

}  // namespace

// Angles are reduced first, because library functions are several times slower beyond an eighth of
// a turn.
Direction direction_of(Real angle) {
  if (angle == 0) return {};
  constexpr double most_quarters = 1e8;
  const auto [count, left] = quarters_in(angle);
  if (!(std::abs(count) < most_quarters)) return {std::cos(angle), std::sin(angle)};
  const Real cos = std::cos(left);
  const Real sin = std::sin(left);
  switch (static_cast<long long>(count) & 3) {
    case 0:
      return {cos, sin};
    case 1:
      return {-sin, cos};
    case 2:
      return {-cos, -sin};
    default:
      return {sin, -cos};
  }
}

Placement placement_after(const Stretch& stretch, Real t) {
  return stretch.rate == 0 ? after_arc(stretch, t) : after_clothoid(stretch, t);
}

Real steepest(const Stretch& stretch) {
  return std::max(std::abs(stretch.curvature), std::abs(curvature_at(stretch, stretch.length)));
}

// On each stretch, length * (|curvature| + sqrt |rate|) is at most 1/2 (docs/proofs/judge.md).
Real stretches_of(const Segment& segment) {
  if (segment.curvature_rate == 0) return 1;
  const Real length = std::abs(static_cast<Real>(segment.length));
  const Real rate = segment.curvature_rate;
  const Real first = segment.curvature;
  const Real most = std::max(std::abs(first), std::abs(first + rate * length));
  return std::max<Real>(1, std::ceil(2 * length * (most + std::sqrt(std::abs(rate)))));
}

Track integrate(const Path& path) {
  Track track;
  track.end = {path.start.x, path.start.y, path.start.heading};
  for (const Segment& segment : path.segments) {
    if (segment.length == 0) continue;
    const Real direction = segment.length > 0 ? 1 : -1;
    if (!track.stretches.empty() && track.stretches.back().direction != direction) {
      ++track.gear_changes;
    }
    if (!track.stretches.empty()) {
      const Stretch& last = track.stretches.back();
      track.curvature_change += std::abs(segment.curvature - curvature_at(last, last.length));
    }
    const Real length = std::abs(static_cast<Real>(segment.length));
    const Real rate = segment.curvature_rate;
    const Real count = stretches_of(segment);
    const Real part = length / count;
    for (Real i = 0; i < count; ++i) {
      const Real curvature = segment.curvature + rate * i * part;
      track.stretches.push_back(
          {track.end, curvature, direction, part, track.length + i * part, rate, i == 0});
      track.end = after(track.stretches.back(), part);
    }
    track.length += length;
    track.curvature_change += std::abs(rate) * length;
    if (direction < 0) track.reverse_length += length;
  }
  if (track.stretches.empty()) track.stretches.push_back({track.end, 0, 1, 0, 0});
  return track;
}

PathPoint point_at(const Track& track, const Place& place) {
  const Stretch& stretch = track.stretches[place.stretch];
  const Position position = after(stretch, place.t);
  return {.s = static_cast<double>(stretch.s + place.t),
          .pose = {static_cast<double>(position.x), static_cast<double>(position.y),
                   static_cast<double>(std::remainder(position.heading, full_turn))},
          .curvature = static_cast<double>(curvature_at(stretch, place.t)),
          .gear = stretch.direction > 0 ? Gear::forward : Gear::reverse};
}

}  // namespace vandplan::judge
