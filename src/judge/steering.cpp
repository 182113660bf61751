// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/steering.h"

#include <algorithm>
#include <cmath>

#include "judge/text.h"

namespace vandplan::judge {
namespace {

constexpr auto rate_slack = static_cast<Real>(1e-9L);  // relative tolerance of the curvature rate
// Largest sum of the jumps from one stop to the next, relative to the tightest curvature. Limited
// one by one, many small jumps could turn the wheels at once.
constexpr auto rounding = static_cast<Real>(1e-6L);

/// Largest change of the curvature per metre that the vehicle can drive [1/m^2].
Real fastest_change(const Vehicle& vehicle) {
  constexpr Real speed = 1;  // speed at which the steering rate limits the curvature rate [m/s]
  const DrivingLimits& limits = vehicle.limits;
  if (limits.max_curvature_rate) return *limits.max_curvature_rate;
  return static_cast<Real>(limits.max_steering_rate) / (vehicle.wheelbase * speed);
}

Fault jump(const char* where, Real before, Real after, const Place& place) {
  return {text("the curvature jumps from %.7g to %.7g 1/m %s", static_cast<double>(before),
               static_cast<double>(after), where),
          place};
}

}  // namespace

bool jumps(const Track& track, const Vehicle& vehicle, std::size_t i) {
  const Stretch& before = track.stretches[i - 1];
  const Stretch& after = track.stretches[i];
  const Real jump = after.curvature - curvature_at(before, before.length);
  return std::abs(jump) > rounding / vehicle.min_turning_radius;
}

std::optional<Fault> false_steering(const Track& track, const Task& task, Steering claimed,
                                    std::span<const Place> stops) {
  if (claimed == Steering::reeds_shepp) return std::nullopt;
  const bool is_throughout = claimed == Steering::continuous;
  const Real allowed_jump = rounding / task.vehicle.min_turning_radius;
  const Real fastest = fastest_change(task.vehicle);
  const bool drives = track.length > 0;  // an empty track has one stretch of length 0
  Real before = task.curvatures.start;
  Real jumped = 0;
  for (std::size_t i = 0; drives && i < track.stretches.size(); ++i) {
    const Stretch& stretch = track.stretches[i];
    const Place place{i, 0};
    const bool changes_gear = i > 0 && stretch.direction != track.stretches[i - 1].direction;
    const auto is_here = [i](const Place& stop) { return stop.stretch == i && stop.t == 0; };
    const bool stands = i == 0 || changes_gear || std::any_of(stops.begin(), stops.end(), is_here);
    if (stands) jumped = 0;
    if (!stands || is_throughout) jumped += std::abs(stretch.curvature - before);
    if (jumped > allowed_jump) {
      return jump(i == 0         ? "at the start"
                  : changes_gear ? "at a gear change"
                                 : "where the vehicle rolls",
                  before, stretch.curvature, place);
    }
    if (std::abs(stretch.rate) > fastest * (1 + rate_slack)) {
      return Fault{text("the curvature changes by %.7g 1/m per metre, the vehicle can %.7g",
                        static_cast<double>(stretch.rate), static_cast<double>(fastest)),
                   place};
    }
    before = curvature_at(stretch, stretch.length);
  }
  if (!is_throughout || std::abs(task.curvatures.goal - before) <= allowed_jump)
    return std::nullopt;
  const std::size_t last = track.stretches.size() - 1;
  return jump("at the goal", before, task.curvatures.goal, {last, track.stretches[last].length});
}

}  // namespace vandplan::judge
