// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vehicle/hitch_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/exponential.h"
#include "base/trigonometry.h"

namespace vandplan::vehicle {
namespace {

/// A matrix [[stretch, shear + turn], [shear - turn, -stretch]]: what the vector (sin, cos) of half
/// the hitch angle goes through while one drives (2).
struct Generator {
  double stretch = 0.0;
  double shear = 0.0;
  double turn = 0.0;

  friend Generator operator+(const Generator& a, const Generator& b) {
    return {a.stretch + b.stretch, a.shear + b.shear, a.turn + b.turn};
  }
  friend Generator operator*(double factor, const Generator& a) {
    return {factor * a.stretch, factor * a.shear, factor * a.turn};
  }
};

Generator commutator(const Generator& a, const Generator& b) {
  return {2 * (a.turn * b.shear - a.shear * b.turn), 2 * (a.stretch * b.turn - a.turn * b.stretch),
          2 * (a.stretch * b.shear - a.shear * b.stretch)};
}

/// Of `driven` metres, negative in reverse, at one curvature.
Generator generator(const Coupling& coupling, double curvature, double driven) {
  const double turn = driven * curvature / 2;
  return {-driven / (2 * coupling.wheelbase), -turn * coupling.hitch / coupling.wheelbase, turn};
}

/// By how much the angle changes that is half of `angle` [rad]: (3), for the three cases of (4).
double half_change(const Generator& g, double angle) {
  const auto [sin, cos] = base::sin_cos(angle);
  const double across = g.stretch * sin + g.shear * cos + g.turn;
  const double along = g.shear * sin - g.stretch * cos;
  if (across == 0.0) return 0.0;
  const double z = g.stretch * g.stretch + (g.shear - g.turn) * (g.shear + g.turn);
  constexpr double small = 0.25;
  if (z > small) {  // two equilibria
    const double root = std::sqrt(z);
    const double e = base::exponential(-2 * root);
    const double ratio = (1 - e) / root;
    return base::atan_2(ratio * across, (1 + e) + ratio * along);
  }
  if (z < -small) {  // none: the trailer turns round its hitch
    const double root = std::sqrt(-z);
    const double halves = std::floor(root * std::numbers::inv_pi);
    const auto part = base::sin_cos(std::max(root - halves * std::numbers::pi, 0.0));
    const double ratio = part.sin / root;
    return std::copysign(halves * std::numbers::pi, across) +
           base::atan_2(ratio * across, part.cos + ratio * along);
  }
  double ratio = 1.0;  // sinh(sqrt z) / sqrt z
  double even = 1.0;   // cosh(sqrt z)
  for (int n = 14; n > 0; n -= 2) {
    ratio = 1.0 + z * ratio / (n * (n + 1));
    even = 1.0 + z * even / (n * (n - 1));
  }
  return base::atan_2(ratio * across, even + ratio * along);
}

/// A clothoid in steps that are short enough for (5).
class Steps {
 public:
  Steps(const Coupling& coupling, const Segment& segment)
      : coupling_(coupling), segment_(segment), gear_(segment.length < 0.0 ? -1.0 : 1.0) {
    const double size = std::abs(segment.length);
    const double lever = 1.0 + std::abs(coupling.hitch) / coupling.wheelbase;
    const double sharpest =
        std::max(std::abs(segment.curvature), std::abs(curvature_at(segment, size)));
    const double turning = size * (1.0 / coupling.wheelbase + sharpest * lever);
    const double bending = size * std::sqrt(std::abs(segment.curvature_rate) * lever);
    constexpr double fineness = 1.0 / 16;
    constexpr double most = 65536.0;  // whatever the numbers
    const double wanted = std::ceil(std::max(turning, bending) / fineness);
    count_ = static_cast<int>(wanted < most ? std::max(wanted, 1.0) : most);
    step_ = size / count_;
  }

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] double step() const { return step_; }

  /// What driving `size` metres from the beginning of step `i` does to the angle [rad].
  [[nodiscard]] double change(int i, double size, double angle) const {
    const double middle = i * step_ + size / 2;
    const Generator mean = generator(coupling_, curvature_at(segment_, middle), gear_ * size);
    const double turn = gear_ * size * size * segment_.curvature_rate / 2;
    const Generator bend{0.0, -turn * coupling_.hitch / coupling_.wheelbase, turn};
    const Generator first = commutator(mean, bend);
    const Generator second = -1.0 / 60 * commutator(mean, first);
    const Generator whole = mean + 1.0 / 240 * commutator(-20.0 * mean + first, bend + second);
    return 2 * half_change(whole, angle);
  }

  /// Change of the angle per metre driven, `driven` metres from the start [rad/m].
  [[nodiscard]] double rate(double driven, double angle) const {
    return gear_ * hitch_rate(coupling_, angle, curvature_at(segment_, driven));
  }

 private:
  Coupling coupling_;
  Segment segment_;
  double gear_;
  int count_ = 1;
  double step_ = 0.0;
};

/// The angle where its rate changes sign within step `i`. There it hardly changes, so that halving
/// twenty times is exact enough.
double turning_point(const Steps& steps, int i, double angle) {
  const double begin = i * steps.step();
  const bool rising = steps.rate(begin, angle) > 0.0;
  double low = 0.0;
  double high = steps.step();
  for (int halving = 0; halving < 20; ++halving) {
    const double middle = (low + high) / 2;
    const double there = angle + steps.change(i, middle, angle);
    ((steps.rate(begin + middle, there) > 0.0) == rising ? low : high) = middle;
  }
  return angle + steps.change(i, low, angle);
}

}  // namespace

double hitch_rate(const Coupling& coupling, double angle, double curvature) noexcept {
  const auto [sin, cos] = base::sin_cos(angle);
  return curvature - (sin + coupling.hitch * curvature * cos) / coupling.wheelbase;
}

double hitch_change(const Coupling& coupling, double angle, const Segment& segment) noexcept {
  if (segment.curvature_rate == 0.0) {
    return 2 * half_change(generator(coupling, segment.curvature, segment.length), angle);
  }
  const Steps steps(coupling, segment);
  double there = angle;
  for (int i = 0; i < steps.count(); ++i) there += steps.change(i, steps.step(), there);
  return there - angle;
}

double largest_hitch_angle(const Coupling& coupling, double angle,
                           const Segment& segment) noexcept {
  if (segment.curvature_rate == 0.0) {
    return std::max(std::abs(angle), std::abs(angle + hitch_change(coupling, angle, segment)));
  }
  const Steps steps(coupling, segment);
  double largest = std::abs(angle);
  double there = angle;
  for (int i = 0; i < steps.count(); ++i) {
    const double next = there + steps.change(i, steps.step(), there);
    const double before = steps.rate(i * steps.step(), there);
    if (before * steps.rate((i + 1) * steps.step(), next) < 0.0) {
      largest = std::max(largest, std::abs(turning_point(steps, i, there)));
    }
    largest = std::max(largest, std::abs(next));
    there = next;
  }
  return largest;
}

TrailerAlone trailer_alone(const Vehicle& vehicle) noexcept {
  constexpr double nearly_right = std::numbers::pi / 2 - 1e-3;
  const double swing = std::abs(vehicle.hitch) / vehicle.min_turning_radius;
  const double most_angle = vehicle.max_hitch_angle + base::atan_2(swing, 1.0);
  const auto [sin, cos] = base::sin_cos(std::min(most_angle, nearly_right));
  return {most_angle, vehicle.trailer->wheelbase * cos / sin, std::sqrt(1.0 + swing * swing)};
}

}  // namespace vandplan::vehicle
