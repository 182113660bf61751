// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/clothoid_arcs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/trigonometry.h"
#include "path/clothoid.h"

namespace vandplan::collision {
namespace {

constexpr double most_arcs = 1e6;
constexpr double quarter = std::numbers::pi / 2;

/// Half the length of an arc: with h = that, rate * h^2 * (reach / 2 + 2 h / 3) <= arc_deviation.
double half_of_arc(double rate, double reach) {
  return std::min(std::sqrt(arc_deviation / (rate * reach)), 0.75 * reach);
}

}  // namespace

ClothoidArcs::ClothoidArcs(const Placement& from, const Segment& clothoid, double reach) noexcept
    : clothoid_(clothoid),
      length_(std::abs(clothoid.length)),
      inflection_(-clothoid.curvature / clothoid.curvature_rate),
      here_(from) {
  const double steepest =
      std::max(std::abs(clothoid.curvature), std::abs(curvature_at(clothoid, length_)));
  longest_ = std::min(2 * half_of_arc(std::abs(clothoid.curvature_rate), reach), 1 / steepest);
  find_end();
}

bool ClothoidArcs::are_too_many() const noexcept { return !(length_ <= most_arcs * longest_); }

PlacedSegment ClothoidArcs::arc() const noexcept {
  const double middle = (begin_ + end_) / 2;
  return {here_, {curvature_at(clothoid_, middle), std::copysign(end_ - begin_, clothoid_.length)}};
}

Placement ClothoidArcs::after(double driven) const noexcept {
  const auto [x, y, turn] = path::along_clothoid(part_of(clothoid_, begin_, driven));
  const auto [sin, cos] = base::sin_cos(turn);
  const auto& [position, heading] = here_;
  return {{position.x + x * heading.x - y * heading.y, position.y + x * heading.y + y * heading.x},
          {cos * heading.x - sin * heading.y, cos * heading.y + sin * heading.x}};
}

void ClothoidArcs::advance() noexcept {
  here_ = there_;
  begin_ = end_;
  find_end();
}

/// As far as an arc may go, but not over the inflection: on each the vehicle turns to one side.
void ClothoidArcs::find_end() noexcept {
  end_ = std::min(length_, begin_ + longest_);
  if (begin_ < inflection_ && inflection_ < end_) end_ = inflection_;
  there_ = after(end_);
}

// The axle is furthest along x or y at the ends or where it points along an axis. That is at most
// one place: it turns to one side, by a radian at most.
bool ClothoidArcs::keeps_to(const Bounds& bounds) const noexcept {
  if (!contains(bounds, there_.position)) return false;
  const double gear = clothoid_.length < 0 ? -1 : 1;
  const double curvature = gear * curvature_at(clothoid_, begin_);
  const double rate = gear * clothoid_.curvature_rate;
  const double heading = base::atan_2(here_.heading.y, here_.heading.x);
  const double length = end_ - begin_;
  const double turn = length * (curvature + rate * length / 2);
  const double before = std::floor(heading / quarter);
  const double after_it = std::floor((heading + turn) / quarter);
  if (before == after_it) return true;
  // The least t with curvature t + rate t^2 / 2 = wanted; every term has the same sign.
  const double wanted = std::max(before, after_it) * quarter - heading;
  const double root = std::sqrt(std::max(0.0, curvature * curvature + 2 * rate * wanted));
  const double sum = std::abs(curvature) + root;
  const double place = sum > 0 ? std::clamp(2 * std::abs(wanted) / sum, 0.0, length) : 0.0;
  return contains(bounds, after(begin_ + place).position);
}

}  // namespace vandplan::collision
