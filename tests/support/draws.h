// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do random cases draw, beyond what the library does?

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "vandplan/path.h"
#include "vandplan/random.h"
#include "vandplan/vehicle.h"

namespace vandplan {

inline bool chance(double probability, Rng& rng) { return uniform01(rng) < probability; }

/// Between the bounds, every power of ten as likely as the next.
inline double any_size(double low, double high, Rng& rng) {
  return low * std::pow(high / low, uniform01(rng));
}

inline double any_sign(double value, Rng& rng) { return chance(0.5, rng) ? value : -value; }

/// Often the default one; may turn as sharply as a case wants.
inline Vehicle any_vehicle(Rng& rng) {
  Vehicle vehicle;
  if (chance(0.7, rng)) {
    vehicle = {.wheelbase = any_size(0.3, 8, rng),
               .front_overhang = chance(0.2, rng) ? 0 : any_size(0.1, 3, rng),
               .rear_overhang = chance(0.2, rng) ? 0 : any_size(0.1, 5, rng),
               .width = any_size(0.2, 4, rng)};
  }
  vehicle.min_turning_radius = 1e-3;
  return vehicle;
}

/// As it is, or with an outline of 3 to 8 corners around the rear axle, in either orientation.
inline Vehicle any_body(Rng& rng) {
  constexpr double pi = std::numbers::pi;
  Vehicle vehicle = any_vehicle(rng);
  const Footprint box = footprint(vehicle);
  const int count = static_cast<int>(uniform(2, 9, rng));
  if (count == 2 || chance(0.5, rng)) return vehicle;
  const double middle = (box.front - box.rear) / 2;
  const double turn = chance(0.5, rng) ? pi / count : uniform(0, pi, rng);
  for (int i = 0; i < count; ++i) {  // on an ellipse about the middle
    const double angle = turn + 2 * pi * (i + uniform(-0.3, 0.3, rng)) / count;
    vehicle.outline.push_back(
        {middle + (box.front + box.rear) * std::cos(angle), 2 * box.half_width * std::sin(angle)});
  }
  if (chance(0.5, rng)) std::reverse(vehicle.outline.begin(), vehicle.outline.end());
  const auto left_of = [](const Point& a, const Point& b) { return a.x * b.y - a.y * b.x > 0; };
  for (std::size_t i = 0, j = vehicle.outline.size() - 1; i < vehicle.outline.size(); j = i++) {
    const bool is_left = left_of(vehicle.outline[j], vehicle.outline[i]);
    if (is_left != left_of(vehicle.outline.back(), vehicle.outline[0])) {  // axle outside
      vehicle.outline.clear();
    }
  }
  return vehicle;
}

/// Straight, nearly straight or up to 1.4 turns; of any length up to 30 m, or of none.
inline Segment any_segment(Rng& rng) {
  const double kind = uniform01(rng);
  Segment segment;
  if (kind < 0.6) segment.curvature = any_sign(1 / uniform(2, 12, rng), rng);
  if (kind < 0.1) segment.curvature = any_sign(1 / any_size(0.02, 2, rng), rng);
  if (kind > 0.8) segment.curvature = any_sign(any_size(1e-12, 0.1, rng), rng);
  const double most = std::min(30.0, 9 / std::abs(segment.curvature));
  const double length = chance(0.05, rng) ? 0 : any_size(chance(0.1, rng) ? 1e-6 : 0.02, most, rng);
  segment.length = any_sign(length, rng);
  return segment;
}

/// Any segment; every third one changes its curvature on the way, by as much as a turn's worth.
inline Segment any_drive(Rng& rng) {
  Segment segment = any_segment(rng);
  const double length = std::abs(segment.length);
  if (chance(0.67, rng) || length < 0.02) return segment;
  if (chance(0.3, rng)) segment.curvature = 0;
  segment.curvature_rate = any_sign(any_size(1e-6, 8, rng) / length / length, rng);
  if (chance(0.1, rng)) segment.curvature = -segment.curvature_rate * length;
  return segment;
}

/// One or three segments from a pose in the box.
inline Path any_edge(const Bounds& box, Rng& rng) {
  Path path{uniform_pose(box, rng), {}};
  const int count = chance(0.7, rng) ? 1 : 3;
  for (int i = 0; i < count; ++i) path.segments.push_back(any_drive(rng));
  return path;
}

}  // namespace vandplan
