// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Between which two numbers does a quantity lie?
//
// Plain double without directed rounding. A proof that uses an interval must leave a margin above
// the rounding error (docs/proofs/bound_table.md).

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/trigonometry.h"

namespace vandplan::tables {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

using base::atan_2, base::sin_cos;

/// Closed interval [low, high]; empty when low > high.
struct Interval {
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] double middle() const { return (low + high) / 2; }
  [[nodiscard]] double width() const { return high - low; }
};

/// Interval that contains one number.
inline Interval point(double value) { return {value, value}; }

inline Interval operator+(Interval a, Interval b) { return {a.low + b.low, a.high + b.high}; }
inline Interval operator-(Interval a, Interval b) { return {a.low - b.high, a.high - b.low}; }
inline Interval operator-(Interval a) { return {-a.high, -a.low}; }
inline Interval operator+(Interval a, double b) { return {a.low + b, a.high + b}; }
inline Interval operator-(Interval a, double b) { return {a.low - b, a.high - b}; }
inline Interval operator+(double a, Interval b) { return {a + b.low, a + b.high}; }
inline Interval operator-(double a, Interval b) { return {a - b.high, a - b.low}; }

inline Interval operator*(Interval a, double b) {
  return b >= 0.0 ? Interval{a.low * b, a.high * b} : Interval{a.high * b, a.low * b};
}

inline Interval operator*(Interval a, Interval b) {
  const auto [low, high] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}

/// 1 / a for a > 0.
inline Interval inverse(Interval a) { return {1 / a.high, 1 / a.low}; }

/// Intersection of two intervals.
inline Interval meet(Interval a, Interval b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// Smallest interval that contains two intervals.
inline Interval hull(Interval a, Interval b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

inline Interval square(Interval a) {
  const double low = a.low * a.low;
  const double high = a.high * a.high;
  return {a.low <= 0.0 && a.high >= 0.0 ? 0.0 : std::min(low, high), std::max(low, high)};
}

/// Square roots of the nonnegative numbers in `a`.
inline Interval square_root(Interval a) {
  return {std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0))};
}

/// Range of an increasing function over `a`.
template <typename Function>
Interval increasing(Interval a, Function f) {
  return {f(a.low), f(a.high)};
}

/// 2 asin(x) for x in [0, 1].
inline double twice_arc_sine(double x) { return 2 * atan_2(x, std::sqrt((1 - x) * (1 + x))); }

inline Interval sine(Interval a) {
  constexpr double pi = std::numbers::pi;
  if (a.width() >= 2 * pi) return {-1.0, 1.0};
  const double s = sin_cos(a.low).sin;
  const double t = sin_cos(a.high).sin;
  Interval range{std::min(s, t), std::max(s, t)};
  const auto contains = [&a](double angle) {  // Whether the angle plus whole turns lies in `a`.
    return a.low <= angle + 2 * pi * std::floor((a.high - angle) / (2 * pi));
  };
  if (contains(pi / 2)) range.high = 1.0;
  if (contains(-pi / 2)) range.low = -1.0;
  return range;
}

inline Interval cosine(Interval a) { return sine(a + std::numbers::pi / 2); }

/// Range of directions [rad] of the points in a box without the origin; continuous across the box.
inline Interval direction(Interval x, Interval y) {
  if (x.low == x.high && y.low == y.high) {
    const double angle = atan_2(y.low, x.low);
    return {angle, angle};
  }
  if (y.low >= 0.0) {
    return {x.high > 0.0 ? atan_2(y.low, x.high) : atan_2(y.high, x.high),
            x.low < 0.0 ? atan_2(y.low, x.low) : atan_2(y.high, x.low)};
  }
  if (y.high <= 0.0) return -direction(x, -y);
  if (x.low > 0.0) return {atan_2(y.low, x.low), atan_2(y.high, x.low)};
  /// Direction of the mirrored box, which crosses the positive x axis.
  const Interval opposite = direction(-x, -y);
  return opposite + std::numbers::pi;
}

inline bool contains_origin(Interval x, Interval y) {
  return x.low <= 0.0 && x.high >= 0.0 && y.low <= 0.0 && y.high >= 0.0;
}

}  // namespace vandplan::tables
