// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/trailer_part.h"

#include <algorithm>
#include <cmath>

namespace vandplan::collision {
namespace {

constexpr double most_turns = 1e5;  // Largest ratio of a segment's way to the trailer's wheelbase.
constexpr double shortest_arc = 1e-6;  // Length of the arc of a trailer that turns on the spot [m].

RigPlacement driven(const Vehicle& vehicle, const RigPlacement& from, const Segment& segment) {
  return {vehicle, after(from.tractor, segment),
          hitch_angle_after(vehicle, from.hitch_angle, segment)};
}

/// Motion of the trailer for each metre of its tractor.
struct Motion {
  double ahead;    // Motion of the trailer's axle along its own heading.
  double turning;  // Turning rate of the trailer times its wheelbase.
  double folding;  // Change of the hitch angle [rad/m].
};

Motion motion_of(const Vehicle& vehicle, const base::SinCos& fold, double curvature) {
  const auto [sin, cos] = fold;
  const double lever = vehicle.hitch * curvature;
  const double turning = sin + lever * cos;
  return {cos - lever * sin, turning, curvature - turning / vehicle.trailer->wheelbase};
}

double largest(double a, double b) { return std::max(std::abs(a), std::abs(b)); }

}  // namespace

RigPlacement::RigPlacement(const Vehicle& vehicle, const Placement& at, double angle) noexcept
    : tractor(at), hitch_angle(angle), fold(base::sin_cos(angle)) {
  const auto& [position, heading] = at;
  const auto [sin, cos] = fold;
  const double wheelbase = vehicle.trailer->wheelbase;
  const Point behind{cos * heading.x + sin * heading.y, cos * heading.y - sin * heading.x};
  trailer = {{position.x + vehicle.hitch * heading.x - wheelbase * behind.x,
              position.y + vehicle.hitch * heading.y - wheelbase * behind.y},
             behind};
}

TrailerPart::TrailerPart(const Vehicle& vehicle, const RigPlacement& from,
                         const Segment& segment) noexcept
    : TrailerPart(vehicle, from, driven(vehicle, from, segment), segment) {}

TrailerPart::TrailerPart(const Vehicle& vehicle, const RigPlacement& from, const RigPlacement& to,
                         const Segment& segment) noexcept
    : vehicle_(&vehicle), from_(from), to_(to), segment_(segment) {
  const double length = std::abs(segment.length);
  last_ = curvature_at(segment, length);
  const double lever = vehicle.hitch * largest(segment.curvature, last_);
  fastest_ = std::sqrt(1 + lever * lever);
  most_turn_ = length * fastest_ / vehicle.trailer->wheelbase;
}

bool TrailerPart::is_too_long() const noexcept { return !(most_turn_ <= most_turns); }

bool TrailerPart::is_simple() const noexcept { return most_turn_ <= 0.5; }

double TrailerPart::half_length() const noexcept { return std::abs(segment_.length) / 2; }

Point TrailerPart::tractor_in_the_middle() const noexcept {
  return after(from_.tractor, part_of(segment_, 0.0, half_length())).position;
}

PlacedSegment TrailerPart::arc() const noexcept {
  const auto& [begin, first] = from_.trailer;
  const auto& [end, last] = to_.trailer;
  const double of_tractor = segment_.length * (segment_.curvature + last_) / 2;
  const double turn = of_tractor - (to_.hitch_angle - from_.hitch_angle);
  // Chord along the heading halfway, which is the direction of the sum of both headings.
  const Point sum{first.x + last.x, first.y + last.y};
  const double chord = ((end.x - begin.x) * sum.x + (end.y - begin.y) * sum.y) /
                       std::sqrt(sum.x * sum.x + sum.y * sum.y);
  // An arc is longer than its chord by (turn / 2) / sin(turn / 2). The omitted terms are below 1e-8
  // of it.
  const double square = turn * turn;
  double length = chord * (1 + square / 24 * (1 + square * 7 / 240 * (1 + square * 31 / 1176)));
  if (turn != 0.0 && std::abs(length) < shortest_arc) length = std::copysign(shortest_arc, length);
  return {from_.trailer, {length == 0.0 ? 0.0 : turn / length, length}};
}

double TrailerPart::deviation(double reach) const noexcept {
  const double wheelbase = vehicle_->trailer->wheelbase;
  const double length = std::abs(segment_.length);
  const Motion begin = motion_of(*vehicle_, from_.fold, segment_.curvature);
  const Motion end = motion_of(*vehicle_, to_.fold, last_);
  const double swing = std::abs(vehicle_->hitch * segment_.curvature_rate);
  // Bounds on quantities along the way, from their values at both ends.
  const double jolt = std::abs(segment_.curvature_rate) + swing / wheelbase;
  const double folding = (largest(begin.folding, end.folding) + jolt * length / 2) *
                         (1 + 0.57 * fastest_ / wheelbase * length);
  const double turning = std::min(
      fastest_, largest(begin.turning, end.turning) + (fastest_ * folding + swing) * length / 2);
  const double ahead_change = turning * folding + swing;
  const double ahead =
      std::min(fastest_, largest(begin.ahead, end.ahead) + ahead_change * length / 2);
  const double turning_change = (ahead * folding + swing) / wheelbase;
  const double square = length * length;
  return (reach * turning_change + ahead_change) * square / 8 +
         2.05 * fastest_ * (turning_change + ahead_change / wheelbase) * square * length / 12 +
         shortest_arc;
}

std::pair<TrailerPart, TrailerPart> TrailerPart::halves() const noexcept {
  const double length = std::abs(segment_.length);
  const Segment first = part_of(segment_, 0.0, length / 2);
  const Segment second = part_of(segment_, length / 2, length);
  const RigPlacement middle = driven(*vehicle_, from_, first);
  return {{*vehicle_, from_, middle, first}, {*vehicle_, middle, to_, second}};
}

}  // namespace vandplan::collision
