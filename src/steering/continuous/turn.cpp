// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous/turn.h"

#include <algorithm>
#include <cmath>

#include "base/trigonometry.h"
#include "path/clothoid.h"

namespace vandplan::steering::continuous {
namespace {

constexpr double series_reach = 3;  // [rad]; beyond it, terms of the series cancel
constexpr std::size_t series_terms = 14;
constexpr double small_square = 0.3 * 0.3;  // [rad^2]; up to it, seven terms reach the last bit

using Coefficients = std::array<double, series_terms>;

/// Power series in a of the integral of exp(i a t^2) for t from 0 to 1, with alternating signs.
/// re: 1 / ((2n)! (4n + 1)), the factors of a^2n.
/// im: 1 / ((2n + 1)! (4n + 3)), the factors of a^(2n + 1).
struct ClothoidSeries {
  Coefficients re{}, im{};
};

constexpr ClothoidSeries clothoid_series() {
  ClothoidSeries series;
  double factorial = 1;  // (2n)!
  for (std::size_t n = 0; n < series_terms; ++n) {
    const double sign = n % 2 == 0 ? 1 : -1;
    const double k = static_cast<double>(n);
    series.re[n] = sign / factorial / (4 * k + 1);
    series.im[n] = sign / (factorial * (2 * k + 1)) / (4 * k + 3);
    factorial *= (2 * k + 1) * (2 * k + 2);
  }
  return series;
}

/// Power series in a^2 of the chord of two clothoids of length 1/2 that turn by a each. The chord
/// is the integral of cos(a (1 - t^2)) for t from 0 to 1. `chord`: factors w(2n) / (2n)! of a^2n
/// with alternating signs, w(m) the integral of (1 - t^2)^m. `slope`: the derivative of the chord
/// by its length, where a is as the square of the length.
struct ChordSeries {
  Coefficients chord{}, slope{};
};

constexpr ChordSeries chord_series() {
  ChordSeries series;
  double weight = 1;  // w(2n) / (2n)!
  for (std::size_t n = 0; n < series_terms; ++n) {
    const double k = static_cast<double>(n);
    series.chord[n] = n % 2 == 0 ? weight : -weight;
    series.slope[n] = (4 * k + 1) * series.chord[n];
    weight *= 4 / ((4 * k + 3) * (4 * k + 5));
  }
  return series;
}

/// The first seven terms of a series in z, the square of a small angle. The order of operations
/// keeps chains of dependent ones short.
double small_sum(const Coefficients& c, double z) {
  const double z2 = z * z;
  return (c[0] + z * c[1]) + z2 * ((c[2] + z * c[3]) + z2 * ((c[4] + z * c[5]) + z2 * c[6]));
}

/// The sum of a series in the square of an angle up to `series_reach`.
double sum_of(const Coefficients& c, double z) {
  if (z <= small_square) return small_sum(c, z);
  double sum = 0;
  for (std::size_t n = series_terms; n-- > 0;) sum = sum * z + c[n];
  return sum;
}

constexpr Coefficients sine = {1, -1.0 / 6, 1.0 / 120, -1.0 / 5040, 1.0 / 362880, -1.0 / 39916800,
                               0};
constexpr Coefficients cosine = {1,           -1.0 / 2,       1.0 / 24,       -1.0 / 720,
                                 1.0 / 40320, -1.0 / 3628800, 1.0 / 479001600};
constexpr ClothoidSeries clothoids = clothoid_series();
constexpr ChordSeries chords = chord_series();

/// Some series, whose first seven terms are summed side by side.
template <std::size_t n>
struct SmallSeries {
  double terms[7][n];

  constexpr explicit SmallSeries(const std::array<const Coefficients*, n>& series) : terms{} {
    for (std::size_t i = 0; i < 7; ++i) {
      for (std::size_t j = 0; j < n; ++j) terms[i][j] = (*series[j])[i];
    }
  }

  /// `small_sum` of each series; compilers turn the loop into vector code.
  [[nodiscard]] std::array<double, n> sums(double z) const {
    std::array<double, n> all;
    const double z2 = z * z;
    const auto& c = terms;
    for (std::size_t j = 0; j < n; ++j) {
      all[j] = (c[0][j] + z * c[1][j]) +
               z2 * ((c[2][j] + z * c[3][j]) + z2 * ((c[4][j] + z * c[5][j]) + z2 * c[6][j]));
    }
    return all;
  }
};

constexpr SmallSeries<4> small_turn_series({&chords.chord, &chords.slope, &sine, &cosine});

/// Sine and cosine, fast where the angle is small, as it is on clothoids.
inline base::SinCos sin_cos_of_ramp(double angle) {
  const double z = angle * angle;
  if (!(z <= small_square)) return base::sin_cos(angle);
  return {angle * small_sum(sine, z), small_sum(cosine, z)};
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
  return {length * sum_of(clothoids.re, square), length * angle * sum_of(clothoids.im, square)};
}

[[gnu::always_inline]] inline SharpTurns::Chord SharpTurns::chord(
    double length, double half_angle, const base::SinCos& half) const noexcept {
  const double square = half_angle * half_angle;
  if (square <= series_reach * series_reach) {
    return {length * sum_of(chords.chord, square), sum_of(chords.slope, square)};
  }
  const Point end = clothoid(length / 2);
  const double across = end.y * half.cos - end.x * half.sin;
  return {2 * (end.x * half.cos + end.y * half.sin), 1 + sharpness_ * length / 2 * across};
}

[[gnu::always_inline]] inline Turned SharpTurns::rolling(double length) const noexcept {
  if (length >= 2 * ramp_) {
    // (dx, dy): from the end of the turn to the centre of its circle.
    const double angle = length - ramp_;
    const auto [sin, cos] = base::sin_cos(angle);
    const double dx = -cos * centre_x_ - sin * centre_y_;
    const double dy = -sin * centre_x_ + cos * centre_y_;
    return {centre_x_ - dx, centre_y_ - dy, dy, -dx, angle, 1, sin, cos};
  }
  const double bend = sharpness_ / 4 * length;            // derivative of `angle` by the length
  const double angle = sharpness_ / 8 * length * length;  // angle of either half of the turn
  base::SinCos half;
  Chord along;
  if (const double square = angle * angle; square <= small_square) {
    const auto [share, slope, sin, cos] = small_turn_series.sums(square);
    along = {length * share, slope};
    half = {angle * sin, cos};
  } else {
    half = base::sin_cos(angle);
    along = chord(length, angle, half);
  }
  const auto [chord_length, slope] = along;
  const auto [sin, cos] = half;
  return {chord_length * cos,
          chord_length * sin,
          slope * cos - chord_length * sin * bend,
          slope * sin + chord_length * cos * bend,
          2 * angle,
          2 * bend,
          2 * sin * cos,
          1 - 2 * sin * sin};
}

[[gnu::always_inline]] inline Turned SharpTurns::to_stop(double length) const noexcept {
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

Turned Turned::reversed() const noexcept {
  const double back_x = slope_x * x + slope_y * y;
  const double back_y = slope_y * x - slope_x * y;
  return {back_x, back_y, 1 - angle_slope * back_y, angle_slope * back_x, angle, angle_slope,
          sin,    cos};
}

Turned SharpTurns::turn(double length, TurnEnds ends) const noexcept {
  if (ends == TurnEnds::stands_before) return to_stop(length).reversed();
  if (ends == TurnEnds::stands_after) return to_stop(length);
  const double size = std::abs(length);
  Turned t;
  if (ends == TurnEnds::rolling) {
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

double SharpTurns::length_of(double angle, TurnEnds ends) const noexcept {
  static constexpr double ramps_of[] = {2, 1, 1, 0};
  const double ramps = ramps_of[static_cast<std::size_t>(ends)];
  const double either[] = {std::sqrt(2 * ramps * angle * ramp_), angle + ramps * ramp_ / 2};
  return either[angle >= ramps * ramp_ / 2 ? 1 : 0];  // a table: branches would be mispredicted
}

double SharpTurns::peak(double length, TurnEnds ends) const noexcept {
  if (ends == TurnEnds::stands_at_both) return 1;
  return std::min(1.0, sharpness_ * (ends == TurnEnds::rolling ? length / 2 : length));
}

}  // namespace vandplan::steering::continuous
