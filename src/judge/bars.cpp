// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/bars.h"

#include <algorithm>
#include <cmath>

namespace vandplan::judge {
namespace {

// Enlargement of a bar per metre of coordinates, so that it contains its points in spite of
// rounding. It is many times the rounding error of a double.
constexpr double slack = 1e-14;
// Largest radius of a bar as a share of the disc's radius; wider bars gain too little.
constexpr double narrow = 0.25;

double length_of(double dx, double dy) { return std::sqrt(dx * dx + dy * dy); }

double reach_of_coordinates(const Point& middle, double radius) {
  return std::abs(middle.x) + std::abs(middle.y) + radius;
}

/// Extent of points from a middle, along their principal axis and across it [m].
struct Extent {
  Point axis;
  double back = 0.0, ahead = 0.0;
  double right = 0.0, left = 0.0;
};

/// Unit vector at an angle. The arguments are cosine and sine of twice the angle, times any factor.
Point axis_of(double cos, double sin) {
  const double length = std::sqrt(cos * cos + sin * sin);
  if (!(length > 0)) return {1, 0};
  const double c = std::sqrt((1 + std::abs(cos) / length) / 2);
  const double s = std::abs(sin) / (2 * length * c);
  return cos > 0 ? Point{c, std::copysign(s, sin)} : Point{s, std::copysign(c, sin)};
}

Extent extent_of(std::span<const Point> points, const Point& middle) {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Point& p : points) {
    xx += (p.x - middle.x) * (p.x - middle.x);
    xy += (p.x - middle.x) * (p.y - middle.y);
    yy += (p.y - middle.y) * (p.y - middle.y);
  }
  Extent extent{axis_of(xx - yy, 2 * xy)};
  for (const Point& p : points) {
    const double dx = p.x - middle.x;
    const double dy = p.y - middle.y;
    const double along = dx * extent.axis.x + dy * extent.axis.y;
    const double aside = dy * extent.axis.x - dx * extent.axis.y;
    extent.back = std::min(extent.back, along);
    extent.ahead = std::max(extent.ahead, along);
    extent.right = std::min(extent.right, aside);
    extent.left = std::max(extent.left, aside);
  }
  return extent;
}

}  // namespace

Bar bar_of(const Box& box) {
  const Point middle = box.middle();
  const double radius = length_of(box.high.x - box.low.x, box.high.y - box.low.y) / 2;
  return {middle, middle, radius + slack * reach_of_coordinates(middle, radius)};
}

Bar bar_of(std::span<const Point> points) {
  Box box = Box::of(points[0]);
  for (const Point& p : points) box.add(p);
  const Bar disc = bar_of(box);
  const auto [axis, back, ahead, right, left] = extent_of(points, disc.a);
  const double radius = (left - right) / 2;
  if (radius > narrow * disc.radius) return disc;
  const double aside = (left + right) / 2;
  const auto at = [&, axis = axis](double along) {  // clang 14 cannot capture structured bindings
    return Point{disc.a.x + along * axis.x - aside * axis.y,
                 disc.a.y + along * axis.y + aside * axis.x};
  };
  return {at(back), at(ahead), radius + slack * reach_of_coordinates(disc.a, disc.radius)};
}

}  // namespace vandplan::judge
