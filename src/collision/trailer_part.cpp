// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/trailer_part.h"

#include <algorithm>
#include <cmath>

#include "base/trigonometry.h"

namespace vandplan::collision {
namespace {

constexpr double most_turns = 1e5;     // lengths of the coupling that a segment may have
constexpr double shortest_arc = 1e-6;  // [m]; a trailer that turns on the spot drives so far

RigState driven(const Vehicle& vehicle, const RigState& from, const Segment& segment) {
  return {advance(from.pose, segment), hitch_angle_after(vehicle, from.hitch_angle, segment)};
}

/// How the trailer moves for each metre of its tractor.
struct Motion {
  double ahead;    // of its axle, along its own heading
  double turning;  // its turning rate times its wheelbase
  double folding;  // change of the hitch angle [rad/m]
};

Motion motion_of(const Vehicle& vehicle, double angle, double curvature) {
  const auto [sin, cos] = base::sin_cos(angle);
  const double lever = vehicle.hitch * curvature;
  const double turning = sin + lever * cos;
  return {cos - lever * sin, turning, curvature - turning / vehicle.trailer->wheelbase};
}

double largest(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

}  // namespace

TrailerPart::TrailerPart(const Vehicle& vehicle, const RigState& from,
                         const Segment& segment) noexcept
    : TrailerPart(vehicle, from, driven(vehicle, from, segment), segment) {}

/// Turning rate of the trailer, at most, times the length [rad].
double TrailerPart::most_turn() const noexcept {
  const double length = std::abs(segment_.length);
  const double lever =
      vehicle_->hitch * largest(segment_.curvature, curvature_at(segment_, length));
  return length * std::sqrt(1 + lever * lever) / vehicle_->trailer->wheelbase;
}

bool TrailerPart::is_too_long() const noexcept { return !(most_turn() <= most_turns); }

bool TrailerPart::is_simple() const noexcept { return most_turn() <= 0.5; }

double TrailerPart::half_length() const noexcept { return std::abs(segment_.length) / 2; }

Point TrailerPart::tractor_in_the_middle() const noexcept {
  const Pose middle = advance(from_.pose, part_of(segment_, 0.0, half_length()));
  return {middle.x, middle.y};
}

PlacedSegment TrailerPart::arc() const noexcept {
  const Pose begin = trailer_pose(*vehicle_, from_);
  const Pose end = trailer_pose(*vehicle_, to_);
  const double turn = wrap_angle(end.heading - begin.heading);
  const auto [sin, cos] = base::sin_cos(begin.heading + turn / 2);
  const double chord = (end.x - begin.x) * cos + (end.y - begin.y) * sin;
  // An arc is longer than its chord by (turn / 2) / sin(turn / 2); the rest is below 1e-8 of it.
  const double square = turn * turn;
  double length = chord * (1 + square / 24 * (1 + square * 7 / 240 * (1 + square * 31 / 1176)));
  if (turn != 0.0 && std::abs(length) < shortest_arc) length = std::copysign(shortest_arc, length);
  return {placement_of(begin), {length == 0.0 ? 0.0 : turn / length, length}};
}

double TrailerPart::deviation(double reach) const noexcept {
  const double wheelbase = vehicle_->trailer->wheelbase;
  const double length = std::abs(segment_.length);
  const double last = curvature_at(segment_, length);
  const Motion begin = motion_of(*vehicle_, from_.hitch_angle, segment_.curvature);
  const Motion end = motion_of(*vehicle_, to_.hitch_angle, last);
  const double lever = vehicle_->hitch * largest(segment_.curvature, last);
  const double fastest = std::sqrt(1 + lever * lever);
  const double swing = std::abs(vehicle_->hitch * segment_.curvature_rate);
  // Bounds of what changes on the way, from its values at both ends.
  const double jolt = std::abs(segment_.curvature_rate) + swing / wheelbase;
  const double folding = (largest(begin.folding, end.folding) + jolt * length / 2) *
                         (1 + 0.57 * fastest / wheelbase * length);
  const double turning = std::min(
      fastest, largest(begin.turning, end.turning) + (fastest * folding + swing) * length / 2);
  const double ahead_change = turning * folding + swing;
  const double ahead =
      std::min(fastest, largest(begin.ahead, end.ahead) + ahead_change * length / 2);
  const double turning_change = (ahead * folding + swing) / wheelbase;
  const double square = length * length;
  return (reach * turning_change + ahead_change) * square / 8 +
         2.05 * fastest * (turning_change + ahead_change / wheelbase) * square * length / 12 +
         shortest_arc;
}

std::pair<TrailerPart, TrailerPart> TrailerPart::halves() const noexcept {
  const double length = std::abs(segment_.length);
  const Segment first = part_of(segment_, 0.0, length / 2);
  const Segment second = part_of(segment_, length / 2, length);
  const RigState middle = driven(*vehicle_, from_, first);
  return {{*vehicle_, from_, middle, first}, {*vehicle_, middle, to_, second}};
}

}  // namespace vandplan::collision
