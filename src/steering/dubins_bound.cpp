// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/dubins_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/trigonometry.h"

namespace vandplan::steering {
namespace {

using base::atan_2;

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;  // bound of all rounding errors in this file, with room to spare

/// An interval of angles, whole turns included [rad].
struct Angles {
  double low = 0.0;
  double high = 0.0;

  friend Angles operator+(Angles a, Angles b) { return {a.low + b.low, a.high + b.high}; }
  friend Angles operator-(Angles a, Angles b) { return {a.low - b.high, a.high - b.low}; }
};

/// The least of the angles' turns in [0, 2 pi); 0 if one of the turns may be 0.
double least_turn(Angles angles) {
  const double low = angles.low - rounding;
  const double wrapped = low - 2 * pi * std::floor(low / (2 * pi));
  return wrapped + (angles.high + rounding - low) >= 2 * pi ? 0.0 : wrapped;
}

/// Whole turns to add to an angle of the interval: the sum is no more than its turn in [0, 2 pi).
double whole_turns(Angles angles) {
  return -2 * pi * std::floor((angles.high + rounding) / (2 * pi));
}

double arc_sine(double sine) {
  const double s = std::clamp(sine, 0.0, 1.0);
  return atan_2(s, std::sqrt((1 - s) * (1 + s)));
}

/// Vectors from the centre of a circle at the first pose to possible centres at the last pose. All
/// circles have radius 1.
struct Apart {
  Angles direction;
  double least;  ///< least distance of the centres
  double most;   ///< largest distance of the centres

  Apart(double x, double y, double shift) {
    const double distance = std::sqrt(x * x + y * y);
    const double angle = atan_2(y, x);
    const double swing = distance > shift ? arc_sine(shift / distance) : pi;
    direction = {angle - swing, angle + swing};
    least = std::max(distance - shift, 0.0);
    most = distance + shift;
  }
};

/// Where the last pose may be, in the frame of the first one and in turning radii.
struct Goals {
  double x, y;
  Angles heading;
  double sin, cos;  ///< sine and cosine of the middle heading
  double shift;     ///< how far the centre of a circle may be from that of the middle pose
};

// Bounds of the words that begin to the left. Each part is bounded by itself, and so is the sum,
// which is much tighter where one part grows while another one shrinks.

double same_sides(const Goals& g) {  // LSL
  const Apart apart(g.x - g.sin, g.y + g.cos - 1, g.shift);
  const double turns = least_turn(apart.direction) + least_turn(g.heading - apart.direction);
  return apart.least + std::max(turns, least_turn(g.heading));
}

double other_sides(const Goals& g) {  // LSR
  const Apart apart(g.x + g.sin, g.y - g.cos - 1, g.shift);
  if (apart.most < 2) return infinity;
  const double nearest = std::max(apart.least, 2.0);
  const Angles tangent{arc_sine(2 / apart.most), arc_sine(2 / nearest)};
  const Angles first = apart.direction + tangent;
  const Angles last = first - g.heading;
  const double line = std::sqrt((nearest - 2) * (nearest + 2));
  // The line and both tangents, together: their sum grows with the distance.
  const double sum = line + 2 * tangent.high + 2 * apart.direction.low - g.heading.high +
                     whole_turns(first) + whole_turns(last);
  return std::max(line + least_turn(first) + least_turn(last), sum);
}

double three_arcs(const Goals& g) {  // LRL
  const Apart apart(g.x - g.sin, g.y + g.cos - 1, g.shift);
  if (apart.least > 4) return infinity;
  const Angles half{pi - arc_sine(apart.most / 4), pi - arc_sine(apart.least / 4)};
  const Angles first = apart.direction + half;
  const Angles last = g.heading - apart.direction + half;
  const double sum = 4 * half.low + g.heading.low + whole_turns(first) + whole_turns(last);
  return std::max(2 * half.low + least_turn(first) + least_turn(last), sum);
}

double least_of_words(const Goals& goals) {
  return std::min({same_sides(goals), other_sides(goals), three_arcs(goals)});
}

Goals mirrored(const Goals& g) {
  return {g.x, -g.y, {-g.heading.high, -g.heading.low}, -g.sin, g.cos, g.shift};
}

}  // namespace

double dubins_bound(const Pose& from, const Pose& to, double radius, const Closing& off) noexcept {
  const auto [sin, cos] = base::sin_cos(from.heading);
  const double dx = (to.x - from.x) / radius;
  const double dy = (to.y - from.y) / radius;
  const double turn = wrap_angle(to.heading - from.heading);
  const auto [turn_sin, turn_cos] = base::sin_cos(turn);
  const Goals goals{dx * cos + dy * sin,
                    dy * cos - dx * sin,
                    {turn - off.heading, turn + off.heading},
                    turn_sin,
                    turn_cos,
                    off.position / radius + off.heading + rounding};
  const double least = std::min(least_of_words(goals), least_of_words(mirrored(goals)));
  return std::max(least - rounding * (1 + least), 0.0) * radius;
}

}  // namespace vandplan::steering
