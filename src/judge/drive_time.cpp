// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/drive_time.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vandplan::judge {
namespace {

// Largest turn of the wheels at a joint that needs no stop [rad].
constexpr Real ignored_turn = 1e-6;
constexpr Real least_motion = 1e-9;  // stretches of less total length are passed over [m]
constexpr Real least_places = 200;   // least number of samples between two limits
constexpr Real usual_step = 1e-2;    // usual distance between samples [m]
constexpr Real most_places = 2e6;    // largest number of samples of a path

struct FastPlace {
  Real s = 0;
  Real square = 0;  // square of the largest speed at the place [m^2/s^2]
};

Real wheel_angle(const Vehicle& vehicle, Real curvature) {
  return std::atan(vehicle.wheelbase * curvature);
}

/// Square of the largest speed at a place [m^2/s^2], whatever the speed elsewhere.
Real square_at(const Stretch& stretch, Real t, const Vehicle& vehicle) {
  const DrivingLimits& limits = vehicle.limits;
  const Real curvature = curvature_at(stretch, t);
  const Real top = stretch.direction < 0 ? limits.max_speed.reverse : limits.max_speed.forward;
  Real square = top * top;
  if (curvature != 0) {
    square = std::min(square, limits.max_lateral_acceleration / std::abs(curvature));
  }
  if (stretch.rate == 0) return square;
  const Real bend = vehicle.wheelbase * curvature;
  const Real turned = vehicle.wheelbase * std::abs(stretch.rate) / (1 + bend * bend);
  const Real slow = limits.max_steering_rate / turned;
  return std::min(square, slow * slow);
}

/// Duration of the drive through `places` from stop to stop [s]; clears `places`.
Real time_of(std::vector<FastPlace>& places, const DrivingLimits& limits) {
  if (places.empty()) return 0;
  places.front().square = places.back().square = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Real gain = 2 * limits.max_acceleration * (places[i].s - places[i - 1].s);
    places[i].square = std::min(places[i].square, places[i - 1].square + gain);
  }
  const Real braking = limits.max_braking.value_or(limits.max_acceleration);
  Real time = 0;
  for (std::size_t i = places.size() - 1; i > 0; --i) {
    const Real way = places[i].s - places[i - 1].s;
    FastPlace& before = places[i - 1];
    before.square = std::min(before.square, places[i].square + 2 * braking * way);
    if (way > 0) time += 2 * way / (std::sqrt(places[i].square) + std::sqrt(before.square));
  }
  places.clear();
  return time;
}

/// Ends of the parts of a stretch between places to stand [m].
std::vector<Real> ends_between(const std::vector<Place>& stops, std::size_t i, Real length) {
  std::vector<Real> ends;
  for (const Place& stop : stops) {
    if (stop.stretch == i && stop.t > 0 && stop.t < length) ends.push_back(stop.t);
  }
  ends.push_back(length);
  return ends;
}

/// How densely a path is sampled.
struct Sampling {
  Real step = 0;   // largest distance between samples [m]
  Real least = 0;  // least number of samples between two limits
};

/// Adds places of stretch `i` between two of its lengths. They are denser near both, and near each
/// place where a limit begins or ends: there the vehicle may reach its speed within a tiny
/// distance. `part`: the part that holds there, moved on.
void add_places(const Stretch& stretch, std::size_t i, Real begin, Real end,
                const Sampling& sampling, const Vehicle& vehicle,
                const std::vector<PricedPart>& parts, std::size_t& part,
                std::vector<FastPlace>& places) {
  for (Real from = begin; from < end;) {
    while (part + 1 < parts.size() && parts[part + 1].stretch == i && parts[part].end <= from) {
      ++part;
    }
    const bool is_last = part + 1 >= parts.size() || parts[part + 1].stretch != i;
    const Real to = is_last ? end : std::min(parts[part].end, end);
    const Real most = max_speed_at(parts, {i, from + (to - from) / 2});
    const Real count = std::max(sampling.least, std::ceil((to - from) / sampling.step));
    for (Real k = 0; k <= count; ++k) {
      const Real t = from + (to - from) * (1 - std::cos(full_turn / 2 * k / count)) / 2;
      places.push_back({stretch.s + t, std::min(square_at(stretch, t, vehicle), most * most)});
    }
    from = to;
  }
}

}  // namespace

double drive_time(const Track& track, const Vehicle& vehicle, double start_curvature,
                  const std::vector<PricedPart>& parts, const std::vector<Place>& stops) {
  const auto most_limits = static_cast<Real>(std::max(track.stretches.size(), parts.size()));
  const Sampling sampling{std::max(usual_step, track.length / most_places),
                          std::min(least_places, most_places / most_limits)};
  std::vector<FastPlace> places;
  Real time = 0;
  Real curvature = start_curvature;  // curvature to which the wheels are turned [1/m]
  Real direction = 0;
  Real passed_over = 0;
  std::size_t part = 0;
  for (std::size_t i = 0; i < track.stretches.size(); ++i) {
    const Stretch& stretch = track.stretches[i];
    passed_over += stretch.length;
    if (passed_over < least_motion) continue;
    passed_over = 0;
    const Real turn =
        std::abs(wheel_angle(vehicle, stretch.curvature) - wheel_angle(vehicle, curvature));
    if (turn > ignored_turn || (direction != 0 && direction != stretch.direction)) {
      time += time_of(places, vehicle.limits);
      if (turn > ignored_turn) time += turn / vehicle.limits.max_steering_rate;
    }
    direction = stretch.direction;
    curvature = curvature_at(stretch, stretch.length);
    const auto is_here = [i](const Place& stop) { return stop.stretch == i && stop.t == 0; };
    if (std::any_of(stops.begin(), stops.end(), is_here)) time += time_of(places, vehicle.limits);
    while (part < parts.size() && parts[part].stretch < i) ++part;
    Real begin = 0;
    for (const Real end : ends_between(stops, i, stretch.length)) {
      if (begin > 0) time += time_of(places, vehicle.limits);
      add_places(stretch, i, begin, end, sampling, vehicle, parts, part, places);
      begin = end;
    }
  }
  return static_cast<double>(time + time_of(places, vehicle.limits));
}

}  // namespace vandplan::judge
