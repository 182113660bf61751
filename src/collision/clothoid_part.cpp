// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/clothoid_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/trigonometry.h"

namespace vandplan::collision {
namespace {

constexpr double most_parts = 1e6;
constexpr double quarter = std::numbers::pi / 2;

/// Half the length of an arc that deviates by at most `arc_deviation` [m].
double half_of_arc(double rate, double reach) {
  return std::min(std::sqrt(arc_deviation / (rate * reach)), 0.75 * reach);
}

double steepest(const Segment& clothoid) {
  return std::max(std::abs(clothoid.curvature),
                  std::abs(curvature_at(clothoid, std::abs(clothoid.length))));
}

}  // namespace

ClothoidPart::ClothoidPart(const Placement& from, const Segment& clothoid) noexcept
    : ClothoidPart(from, after(from, clothoid), clothoid) {}

bool ClothoidPart::is_too_long(double reach) const noexcept {
  const double arc = 2 * half_of_arc(std::abs(clothoid_.curvature_rate), reach);
  return !(std::abs(clothoid_.length) <= most_parts * std::min(arc, 1 / steepest(clothoid_)));
}

bool ClothoidPart::is_simple() const noexcept {
  const double length = std::abs(clothoid_.length);
  return clothoid_.curvature * curvature_at(clothoid_, length) >= 0 &&
         length * steepest(clothoid_) <= 1;
}

PlacedSegment ClothoidPart::arc() const noexcept {
  const double middle = std::abs(clothoid_.length) / 2;
  return {from_, {curvature_at(clothoid_, middle), clothoid_.length}};
}

double ClothoidPart::deviation(double reach) const noexcept {
  const double half = std::abs(clothoid_.length) / 2;
  return std::abs(clothoid_.curvature_rate) * half * half * (reach / 2 + 2 * half / 3);
}

// The axle is furthest along x or y at the ends, or where it points along an axis. There is at most
// one such place, since a simple part turns to one side by at most a radian.
bool ClothoidPart::keeps_to(const Bounds& bounds) const noexcept {
  if (!contains(bounds, to_.position)) return false;
  const double gear = clothoid_.length < 0 ? -1 : 1;
  const double curvature = gear * clothoid_.curvature;
  const double rate = gear * clothoid_.curvature_rate;
  const double heading = base::atan_2(from_.heading.y, from_.heading.x);
  const double length = std::abs(clothoid_.length);
  const double turn = length * (curvature + rate * length / 2);
  const double before = std::floor(heading / quarter);
  const double after_it = std::floor((heading + turn) / quarter);
  if (before == after_it) return true;
  // Least t with curvature * t + rate * t^2 / 2 = wanted; all terms have the same sign.
  const double wanted = std::max(before, after_it) * quarter - heading;
  const double root = std::sqrt(std::max(0.0, curvature * curvature + 2 * rate * wanted));
  const double sum = std::abs(curvature) + root;
  const double place = sum > 0 ? std::clamp(2 * std::abs(wanted) / sum, 0.0, length) : 0.0;
  return contains(bounds, after(from_, part_of(clothoid_, 0.0, place)).position);
}

std::pair<ClothoidPart, ClothoidPart> ClothoidPart::halves() const noexcept {
  const double length = std::abs(clothoid_.length);
  const double inflection = -clothoid_.curvature / clothoid_.curvature_rate;
  const bool is_inside = 0 < inflection && inflection < length;
  const double cut = is_inside ? inflection : length / 2;
  const Segment first = part_of(clothoid_, 0.0, cut);
  Segment second = part_of(clothoid_, cut, length);
  if (is_inside) second.curvature = 0;
  const Placement middle = after(from_, first);
  return {{from_, middle, first}, {middle, to_, second}};
}

}  // namespace vandplan::collision
