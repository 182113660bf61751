// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_turn.h"

#include <algorithm>
#include <cmath>

#include "base/trigonometry.h"
#include "path/clothoid.h"

namespace vandplan::steering {
namespace {

constexpr double series_reach = 3;  // radians; beyond, terms cancel
constexpr std::size_t series_terms = 14;

/// 1 / ((2n)! (4n + 1)) and 1 / ((2n + 1)! (4n + 3)) with alternating signs: the integral of
/// exp(i a t^2) for t from 0 to 1 is the sum of a^2n times the first plus i a^(2n + 1) the second.
struct Series {
  std::array<double, series_terms> re{}, im{};
};

constexpr Series fresnel_series() {
  Series series;
  double factorial = 1;  // of 2n
  for (std::size_t n = 0; n < series_terms; ++n) {
    const double sign = n % 2 == 0 ? 1 : -1;
    const double k = static_cast<double>(n);
    series.re[n] = sign / factorial / (4 * k + 1);
    series.im[n] = sign / (factorial * (2 * k + 1)) / (4 * k + 3);
    factorial *= (2 * k + 1) * (2 * k + 2);
  }
  return series;
}

constexpr Series series = fresnel_series();

/// Sine and cosine, fast where the angle is small, as it is on clothoids.
inline base::SinCos sin_cos_of_ramp(double angle) {
  if (!(std::abs(angle) <= 0.3)) return base::sin_cos(angle);
  const double z = angle * angle;
  const double sin =
      angle - angle * z *
                  (1.0 / 6 -
                   z * (1.0 / 120 - z * (1.0 / 5040 - z * (1.0 / 362880 - z * (1.0 / 39916800)))));
  const double cos =
      1 - z * (1.0 / 2 -
               z * (1.0 / 24 -
                    z * (1.0 / 720 - z * (1.0 / 40320 - z * (1.0 / 3628800 - z / 479001600)))));
  return {sin, cos};
}

/// How many terms of the series reach the last bit for angles up to `angle`.
constexpr std::size_t terms_for(double angle) {
  return angle < 0.1 ? 5 : angle < 0.5 ? 7 : angle < 1.3 ? 9 : series_terms;
}

}  // namespace

SharpTurns::SharpTurns(double sharpness) noexcept
    : sharpness_(sharpness), ramp_(1 / sharpness), full_(clothoid(ramp_)) {
  const auto [sin, cos] = base::sin_cos(ramp_ / 2);
  centre_x_ = full_.x - sin;
  centre_y_ = full_.y + cos;
  reach_ = std::sqrt(centre_x_ * centre_x_ + centre_y_ * centre_y_);
  skew_ = base::atan_2(centre_x_, centre_y_);
}

SharpTurns::SharpTurns(const std::array<double, 8>& c) noexcept
    : sharpness_(c[0]),
      ramp_(c[1]),
      full_{c[2], c[3]},
      centre_x_(c[4]),
      centre_y_(c[5]),
      reach_(c[6]),
      skew_(c[7]) {}

std::array<double, 8> SharpTurns::constants() const noexcept {
  return {sharpness_, ramp_, full_.x, full_.y, centre_x_, centre_y_, reach_, skew_};
}

SharpTurns::Point SharpTurns::clothoid(double length) const noexcept {
  const double angle = sharpness_ * length * length / 2;
  if (!(angle <= series_reach)) {
    const path::Displacement end = path::along_clothoid({0.0, length, sharpness_});
    return {end.x, end.y};
  }
  const double square = angle * angle;
  std::size_t n = terms_for(angle);
  double re = 0, im = 0;
  while (n-- > 0) {
    re = re * square + series.re[n];
    im = im * square + series.im[n];
  }
  return {length * re, length * angle * im};
}

Turned SharpTurns::rolling(double length) const noexcept {
  if (length >= 2 * ramp_) {
    // From the centre of the circle to either end.
    const double angle = length - ramp_;
    const auto [sin, cos] = base::sin_cos(angle);
    const double dx = -cos * centre_x_ - sin * centre_y_;
    const double dy = -sin * centre_x_ + cos * centre_y_;
    return {centre_x_ - dx, centre_y_ - dy, dy, -dx, angle, 1, sin, cos};
  }
  const double half = length / 2;
  const Point end = clothoid(half);
  const double angle = sharpness_ * half * half / 2;  // of either half
  const auto [sin, cos] = sin_cos_of_ramp(angle);
  const double along = end.x * cos + end.y * sin;
  const double across = end.y * cos - end.x * sin;
  const double slope = 1 + sharpness_ * half * across;  // of 2 * along by the length
  const double bend = sharpness_ * half / 2;            // of the angle of half of it
  return {2 * along * cos,
          2 * along * sin,
          slope * cos - 2 * along * sin * bend,
          slope * sin + 2 * along * cos * bend,
          2 * angle,
          2 * bend,
          2 * sin * cos,
          1 - 2 * sin * sin};
}

Turned SharpTurns::to_stop(double length) const noexcept {
  if (length >= ramp_) {
    const double angle = length - ramp_ / 2;
    const auto [sin, cos] = base::sin_cos(angle);
    return {centre_x_ + sin, centre_y_ - cos, cos, sin, angle, 1, sin, cos};
  }
  Point end = clothoid(std::abs(length));
  if (length < 0) end = {-end.x, -end.y};
  const double angle = sharpness_ * length * length / 2;
  const auto [sin, cos] = sin_cos_of_ramp(angle);
  return {end.x, end.y, cos, sin, angle, sharpness_ * length, sin, cos};
}

Turned SharpTurns::from_stop(double length) const noexcept {
  // The way back of `to_stop`.
  Turned t = to_stop(length);
  const double sin = t.slope_y, cos = t.slope_x;
  const double x = cos * t.x + sin * t.y;
  const double y = sin * t.x - cos * t.y;
  t.x = x;
  t.y = y;
  t.slope_x = 1 - t.angle_slope * y;
  t.slope_y = t.angle_slope * x;
  return t;
}

Turned SharpTurns::turn(double length, Ends ends) const noexcept {
  if (ends == Ends::stands_before) return from_stop(length);
  if (ends == Ends::stands_after) return to_stop(length);
  const double size = std::abs(length);
  Turned t;
  if (ends == Ends::rolling) {
    t = rolling(size);
  } else {
    const auto [sin, cos] = base::sin_cos(size / 2);
    const double whole = 2 * sin * cos, rest = 2 * sin * sin;
    t = {whole, rest, 1 - rest, whole, size, 1, whole, 1 - rest};
  }
  if (length < 0) {  // left in reverse: x and angle change sign, y does not
    t.x = -t.x;
    t.angle = -t.angle;
    t.sin = -t.sin;
    t.slope_y = -t.slope_y;
  }
  return t;
}

double SharpTurns::length_of(double angle, Ends ends) const noexcept {
  const double ramps = ends == Ends::rolling ? 2 : ends == Ends::stands_at_both ? 0 : 1;
  if (angle >= ramps * ramp_ / 2) return angle + ramps * ramp_ / 2;
  return std::sqrt(2 * ramps * angle * ramp_);
}

double SharpTurns::peak(double length, Ends ends) const noexcept {
  if (ends == Ends::stands_at_both) return 1;
  return std::min(1.0, sharpness_ * (ends == Ends::rolling ? length / 2 : length));
}

}  // namespace vandplan::steering
