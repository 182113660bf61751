// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/trailing.h"

#include <algorithm>
#include <cmath>

namespace vandplan::judge {
namespace {

constexpr Real steps_per_wheelbase = 128;
constexpr Real most_steps = 1e6;  // largest number of steps of a stretch

}  // namespace

Trailing::Trailing(const Track& track, const Vehicle& vehicle, double start_angle)
    : track_(track), hitch_(vehicle.hitch), wheelbase_(vehicle.trailer->wheelbase) {
  Real angle = start_angle;
  for (const Stretch& stretch : track.stretches) {
    const Real lever = 1 + std::abs(hitch_) / wheelbase_;
    const Real pace = 1 / wheelbase_ + steepest(stretch) * lever;
    const Real wanted = std::ceil(stretch.length * pace * steps_per_wheelbase);
    const auto count = static_cast<std::size_t>(std::clamp<Real>(wanted, 1, most_steps));
    Angles angles{stretch.length / static_cast<Real>(count), {angle}};
    angles.at.reserve(count + 1);
    for (std::size_t i = 0; i < count; ++i) {
      angle = driven(stretch, static_cast<Real>(i) * angles.step, angles.step, angle);
      angles.at.push_back(angle);
    }
    angles_.push_back(std::move(angles));
  }
  end_angle_ = angle;
}

/// Derivative of the hitch angle per metre driven: the trailer turns by the sideways motion of its
/// hitch over its wheelbase.
Real Trailing::rate(const Stretch& stretch, Real t, Real angle) const {
  const Real curvature = curvature_at(stretch, t);
  const Real aside = std::sin(angle) + hitch_ * curvature * std::cos(angle);
  return stretch.direction * (curvature - aside / wheelbase_);
}

/// Hitch angle after one Runge-Kutta step of `step` metres [rad].
Real Trailing::driven(const Stretch& stretch, Real t, Real step, Real angle) const {
  const Real half = step / 2;
  const Real first = rate(stretch, t, angle);
  const Real second = rate(stretch, t + half, angle + half * first);
  const Real third = rate(stretch, t + half, angle + half * second);
  const Real last = rate(stretch, t + step, angle + step * third);
  return angle + step * (first + 2 * second + 2 * third + last) / 6;
}

Real Trailing::angle(const Place& place) const {
  const auto& [step, at] = angles_[place.stretch];
  if (step == 0) return at.front();
  const Real last = static_cast<Real>(at.size() - 1);
  const Real whole = std::clamp<Real>(std::floor(place.t / step), 0, last);
  return driven(track_.stretches[place.stretch], whole * step, place.t - whole * step,
                at[static_cast<std::size_t>(whole)]);
}

Position Trailing::position(const Place& place) const {
  const auto [x, y, heading] = after(track_.stretches[place.stretch], place.t);
  const Real of_trailer = heading - angle(place);
  return {x + hitch_ * std::cos(heading) - wheelbase_ * std::cos(of_trailer),
          y + hitch_ * std::sin(heading) - wheelbase_ * std::sin(of_trailer), of_trailer};
}

Real Trailing::largest_angle() const {
  Real largest = 0;
  for (const Angles& angles : angles_) {
    for (const Real angle : angles.at) largest = std::max(largest, std::abs(angle));
  }
  return largest;
}

std::optional<Place> Trailing::first_beyond(Real limit) const {
  for (std::size_t i = 0; i < angles_.size(); ++i) {
    const auto& [step, at] = angles_[i];
    const auto found =
        std::find_if(at.begin(), at.end(), [&](Real angle) { return std::abs(angle) > limit; });
    if (found == at.end()) continue;
    return Place{i, step * static_cast<Real>(found - at.begin())};
  }
  return std::nullopt;
}

double Trailing::speed(const Stretch& stretch, double reach) const {
  const Real of_hitch = std::hypot(Real{1}, hitch_ * steepest(stretch));
  return static_cast<double>(of_hitch * (1 + reach / wheelbase_));
}

}  // namespace vandplan::judge
