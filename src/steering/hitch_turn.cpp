// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/hitch_turn.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/exponential.h"
#include "base/trigonometry.h"

namespace vandplan::steering {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The natural logarithm of a finite x > 0, within a few units in the last place.
double logarithm(double x) noexcept {
  int exponent = 0;
  double part = std::frexp(x, &exponent);  // in [0.5, 1)
  if (part < std::numbers::sqrt2 / 2) {
    part *= 2;
    --exponent;
  }
  const double z = (part - 1) / (part + 1);  // |z| <= 0.172
  const double square = z * z;
  double sum = 0.0;
  for (int n = 21; n > 1; n -= 2) sum = (sum + 1.0 / n) * square;
  return exponent * std::numbers::ln2 + 2 * z * (1 + sum);
}

}  // namespace

HitchTurn::HitchTurn(double wheelbase, double hitch, double most) noexcept
    : wheelbase_(wheelbase), hitch_(hitch), most_(most) {
  turns_ = {riccati(-1), riccati(0), riccati(1)};
}

HitchTurn::Riccati HitchTurn::riccati(double curvature) const noexcept {
  Riccati r;
  const double lever = hitch_ / wheelbase_;
  r.a = curvature * (1 - lever) / 2;
  r.b = -1 / wheelbase_;
  r.c = curvature * (1 + lever) / 2;
  r.square = r.b * r.b / 4 - r.a * r.c;
  r.root = std::sqrt(std::abs(r.square));
  r.inverse_root = 1 / r.root;
  return r;
}

HitchTurn::After HitchTurn::after(const Riccati& r, double u, double way) noexcept {
  if (r.a == 0) {  // a line
    const double e = base::exponential(r.b * way);
    return {u * e, e};
  }
  const double z = r.root * way;
  double even = 1.0, ratio = way;  // cosh z and sinh(z) / root, or cos z and sin(z) / root
  if (std::abs(z) < 1e-2) {
    const double q = r.square * way * way;
    even = 1 + q / 2 * (1 + q / 12 * (1 + q / 30));
    ratio = way * (1 + q / 6 * (1 + q / 20 * (1 + q / 42)));
  } else if (r.square > 0) {
    const double e = base::exponential(z);
    const double inverse = 1 / e;
    even = (e + inverse) / 2;
    ratio = (e - inverse) / 2 * r.inverse_root;
  } else {
    const auto [sin, cos] = base::sin_cos(z);
    even = cos;
    ratio = sin * r.inverse_root;
  }
  const double above = u * (even + r.b / 2 * ratio) + r.a * ratio;
  const double below = even - (r.b / 2 + r.c * u) * ratio;
  if (!(below > 0)) return {above, nan};
  const double inverse = 1 / below;
  return {above * inverse, inverse * inverse};
}

HitchTurn::After HitchTurn::after(int turn, double u, double way) const noexcept {
  return after(of_turn(turn), u, way);
}

HitchTurn::After HitchTurn::after_arc(double curvature, double u, double way) const noexcept {
  return after(riccati(curvature), u, way);
}

double HitchTurn::way_between(int turn, double from, double to) const noexcept {
  const Riccati& r = of_turn(turn);
  const double sign = turn < 0 ? -1 : 1;
  const double above = sign * (to - from);
  const double below = sign * (r.a + r.b / 2 * (from + to) + r.c * from * to);
  if (std::abs(r.root * above) < 1e-5 * std::abs(below)) {
    const double t = above / below;
    return t * (1 + r.square * t * t / 3);
  }
  if (r.square < 0) return base::atan_2(r.root * above, below) / r.root;
  const double z = r.root * above / below;
  if (!(std::abs(z) < 1)) return nan;
  return logarithm((1 + z) / (1 - z)) / (2 * r.root);
}

double HitchTurn::hold_curvature(double u) const noexcept {
  const double square = u * u;
  return 2 * u / (wheelbase_ * (1 + square) - hitch_ * (1 - square));
}

}  // namespace vandplan::steering
