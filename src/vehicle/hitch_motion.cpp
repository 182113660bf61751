// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vehicle/hitch_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/exponential.h"
#include "base/trigonometry.h"

namespace vandplan::vehicle {
namespace {

/// The matrix M s of (2), [[stretch, shear + turn], [shear - turn, -stretch]]. It generates the
/// motion of the vector (sin, cos) of half the hitch angle while the rig drives s metres.
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

/// The generator of `driven` metres, negative in reverse, at one curvature.
Generator generator(const Coupling& coupling, double curvature, double driven) {
  const double turn = driven * curvature / 2;
  return {-driven / (2 * coupling.wheelbase), -turn * coupling.hitch / coupling.wheelbase, turn};
}

/// The number z of (4).
double determinant(const Generator& g) {
  return g.stretch * g.stretch + (g.shear - g.turn) * (g.shear + g.turn);
}

/// Sine and cosine of half the hitch angle, times any factor.
struct HalfAngle {
  double sin, cos;
};

HalfAngle half_of(double angle) {
  const auto [sin, cos] = base::sin_cos(angle / 2);
  return {sin, cos};
}

/// The half angle after a short way. The map is linear, so that no angle is needed on the way.
HalfAngle moved(const Generator& g, const HalfAngle& v) {
  const double z = determinant(g);  // small, so that a few terms of (4) are enough
  const double even = 1 + z * (1.0 / 2 + z * (1.0 / 24 + z * (1.0 / 720 + z * (1.0 / 40320))));
  const double ratio = 1 + z * (1.0 / 6 + z * (1.0 / 120 + z * (1.0 / 5040 + z * (1.0 / 362880))));
  return {even * v.sin + ratio * (g.stretch * v.sin + (g.shear + g.turn) * v.cos),
          even * v.cos + ratio * ((g.shear - g.turn) * v.sin - g.stretch * v.cos)};
}

/// Change from one hitch angle to another, less than half a turn [rad].
double change_between(const HalfAngle& from, const HalfAngle& to) {
  return 2 *
         base::atan_2(to.sin * from.cos - to.cos * from.sin, to.cos * from.cos + to.sin * from.sin);
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
    constexpr double most = 65536.0;  // limit of the work, whatever the numbers
    const double wanted = std::ceil(std::max(turning, bending) / fineness);
    count_ = static_cast<int>(wanted < most ? std::max(wanted, 1.0) : most);
    step_ = size / count_;
  }

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] double step() const { return step_; }

  /// Generator of the first `size` metres of step `i`, by (5).
  [[nodiscard]] Generator part(int i, double size) const {
    const double middle = i * step_ + size / 2;
    const Generator mean = generator(coupling_, curvature_at(segment_, middle), gear_ * size);
    const double turn = gear_ * size * size * segment_.curvature_rate / 2;
    const Generator bend{0.0, -turn * coupling_.hitch / coupling_.wheelbase, turn};
    const Generator first = commutator(mean, bend);
    const Generator second = -1.0 / 60 * commutator(mean, first);
    return mean + 1.0 / 240 * commutator(-20.0 * mean + first, bend + second);
  }

  /// Whether the hitch angle grows at the place `driven` metres from the start.
  [[nodiscard]] bool is_growing(double driven, const HalfAngle& v) const {
    const double k = curvature_at(segment_, driven);
    const double lever = coupling_.hitch * k;
    const double rate = (coupling_.wheelbase * k + lever) * v.sin * v.sin - 2 * v.sin * v.cos +
                        (coupling_.wheelbase * k - lever) * v.cos * v.cos;
    return gear_ * rate > 0.0;
  }

 private:
  Coupling coupling_;
  Segment segment_;
  double gear_;
  int count_ = 1;
  double step_ = 0.0;
};

/// Half angle at the place within step `i` where the rate of the angle changes sign. The angle
/// hardly changes there, so that halving twenty times is exact enough.
HalfAngle turning_point(const Steps& steps, int i, const HalfAngle& first) {
  const double begin = i * steps.step();
  const bool grows = steps.is_growing(begin, first);
  double low = 0.0;
  double high = steps.step();
  for (int halving = 0; halving < 20; ++halving) {
    const double middle = (low + high) / 2;
    const HalfAngle there = moved(steps.part(i, middle), first);
    (steps.is_growing(begin + middle, there) == grows ? low : high) = middle;
  }
  return moved(steps.part(i, low), first);
}

// Number of steps between two computed angles, which differ by half a radian at most.
constexpr int steps_of_look = 8;

}  // namespace

double hitch_rate(const Coupling& coupling, double angle, double curvature) noexcept {
  const auto [sin, cos] = base::sin_cos(angle);
  return curvature - (sin + coupling.hitch * curvature * cos) / coupling.wheelbase;
}

HitchAlongArc::HitchAlongArc(const Coupling& coupling, const Segment& arc) noexcept
    : half_turns_(0.0) {
  const Generator g = generator(coupling, arc.curvature, arc.length);
  stretch_ = g.stretch;
  shear_ = g.shear;
  turn_ = g.turn;
  // The three cases of (4).
  const double z = determinant(g);
  constexpr double small = 0.25;
  if (z > small) {  // two equilibria
    const double root = std::sqrt(z);
    const double e = base::exponential(-2 * root);
    ratio_ = (1 - e) / root;
    even_ = 1 + e;
  } else if (z < -small) {  // no equilibrium: the trailer turns round its hitch
    const double root = std::sqrt(-z);
    const double halves = std::floor(root * std::numbers::inv_pi);
    const auto part = base::sin_cos(std::max(root - halves * std::numbers::pi, 0.0));
    ratio_ = part.sin / root;
    even_ = part.cos;
    half_turns_ = halves * std::numbers::pi;
  } else {
    ratio_ = 1.0;  // sinh(sqrt z) / sqrt z
    even_ = 1.0;   // cosh(sqrt z)
    for (int n = 14; n > 0; n -= 2) {
      ratio_ = 1.0 + z * ratio_ / (n * (n + 1));
      even_ = 1.0 + z * even_ / (n * (n - 1));
    }
  }
}

/// Formula (3).
double HitchAlongArc::change(const base::SinCos& angle) const noexcept {
  const double across = stretch_ * angle.sin + shear_ * angle.cos + turn_;
  const double along = shear_ * angle.sin - stretch_ * angle.cos;
  if (across == 0.0) return 0.0;
  return 2 * (std::copysign(half_turns_, across) +
              base::atan_2(ratio_ * across, even_ + ratio_ * along));
}

double hitch_change(const Coupling& coupling, double angle, const Segment& segment) noexcept {
  if (segment.curvature_rate == 0.0) {
    return HitchAlongArc(coupling, segment).change(base::sin_cos(angle));
  }
  const Steps steps(coupling, segment);
  double there = angle;
  for (int i = 0; i < steps.count(); i += steps_of_look) {
    const HalfAngle first = half_of(there);
    HalfAngle v = first;
    for (int k = i; k < std::min(i + steps_of_look, steps.count()); ++k) {
      v = moved(steps.part(k, steps.step()), v);
    }
    there += change_between(first, v);
  }
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
  for (int i = 0; i < steps.count(); i += steps_of_look) {
    const HalfAngle first = half_of(there);
    HalfAngle v = first;
    bool grows = steps.is_growing(i * steps.step(), v);
    for (int k = i; k < std::min(i + steps_of_look, steps.count()); ++k) {
      const HalfAngle next = moved(steps.part(k, steps.step()), v);
      const bool grew = std::exchange(grows, steps.is_growing((k + 1) * steps.step(), next));
      if (grows != grew) {
        const double extreme = there + change_between(first, turning_point(steps, k, v));
        largest = std::max(largest, std::abs(extreme));
      }
      v = next;
    }
    there += change_between(first, v);
    largest = std::max(largest, std::abs(there));
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
