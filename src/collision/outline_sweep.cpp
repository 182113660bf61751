// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/outline_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/convex.h"

namespace vandplan::collision {
namespace {

// Largest deviation of a point of the body from a line [m].
constexpr double straight_arc = 0.1e-3;

double along(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
double across(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
Point from_to(const Point& a, const Point& b) { return {b.x - a.x, b.y - a.y}; }

double furthest(std::span<const Point> corners) {
  double most = 0.0;
  for (const Point& corner : corners) most = std::max(most, along(corner, corner));
  return std::sqrt(most);
}

/// Squared distance between two line segments, from a to b and from c to d [m^2].
double squared_gap(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto parts = [](const Point& from, const Point& to, const Point& p, const Point& q) {
    const Point line = from_to(from, to);
    return across(line, from_to(from, p)) * across(line, from_to(from, q)) < 0.0;
  };
  if (parts(a, b, c, d) && parts(c, d, a, b)) return 0.0;
  using geometry::squared_distance_to_side;
  return std::min({squared_distance_to_side(a, c, d), squared_distance_to_side(b, c, d),
                   squared_distance_to_side(c, a, b), squared_distance_to_side(d, a, b)});
}

}  // namespace

OutlineSweep::OutlineSweep(std::span<const Point> corners, const PlacedSegment& placed,
                           double margin) noexcept
    : corners_(corners),
      placed_(placed),
      gear_(along(placed.forward, placed.from.heading) < 0.0 ? -1.0 : 1.0),
      side_(across(placed.from.heading, placed.left) < 0.0 ? -1.0 : 1.0),
      near_(margin + arc_margin) {
  turns_ = placed.turn * (placed.length / 2 + furthest(corners)) > straight_arc;
  if (!turns_) near_ += straight_arc;
}

/// Tests in the frame of the vehicle at the start.
bool OutlineSweep::touches(const Sides& sides) const noexcept {
  const auto& [position, heading] = placed_.from;
  std::array<Point, 5> p;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point d{sides.x[i] - position.x, sides.y[i] - position.y};
    p[i] = {along(heading, d), across(heading, d)};
  }
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    if (touches_side(p[i], p[i + 1])) return true;
  }
  return false;
}

/// Two disjoint convex sets are nearest at a corner of one of them. So a side that is far enough at
/// the start stays so if no corner of the body comes near the side, and neither end of the side,
/// seen from the body, comes near a side of the body. The end b is tested with the polygon's next
/// side.
bool OutlineSweep::touches_side(const Point& a, const Point& b) const noexcept {
  if (geometry::squared_distance(corners_, a, b) <= near_ * near_) return true;
  Point from = corners_.back();
  for (const Point& to : corners_) {
    if (comes_near(to, 1.0, a, b) || comes_near(a, -1.0, from, to)) return true;
    from = to;
  }
  return false;
}

/// Whether a point that is driven (`way` 1), or driven past (-1), comes near the side from a to b.
bool OutlineSweep::comes_near(const Point& point, double way, const Point& a,
                              const Point& b) const noexcept {
  if (turns_) return turns_near(point, way, a, b);
  const Point last{point.x + way * gear_ * placed_.length, point.y};
  return squared_gap(point, last, a, b) <= near_ * near_;
}

/// Whether a point that turns about the turning centre comes near a side. Its arc is nearest to the
/// side at an end of either, at the foot of the centre on the side, or at a crossing.
bool OutlineSweep::turns_near(const Point& point, double way, const Point& a,
                              const Point& b) const noexcept {
  const double hand = way * gear_ * side_;  // 1: counter-clockwise
  const Point centre{0.0, side_ / placed_.curvature};
  const Point first = from_to(centre, point);
  const Point last{placed_.cos * first.x - hand * placed_.sin * first.y,
                   placed_.cos * first.y + hand * placed_.sin * first.x};
  const Point c = from_to(centre, a);
  const Point d = from_to(centre, b);
  const double squared_near = near_ * near_;
  if (geometry::squared_distance_to_side(first, c, d) <= squared_near ||
      geometry::squared_distance_to_side(last, c, d) <= squared_near) {
    return true;
  }
  const auto is_passed = [&](const Point& direction) {
    if (placed_.turn >= 2 * std::numbers::pi) return true;
    const double after = hand * across(first, direction);
    const double before = hand * across(direction, last);
    return placed_.turn <= std::numbers::pi ? after >= 0.0 && before >= 0.0
                                            : after >= 0.0 || before >= 0.0;
  };
  const double radius = std::sqrt(along(first, first));
  const auto is_near_circle = [&](const Point& p) {
    return std::abs(std::sqrt(along(p, p)) - radius) <= near_;
  };
  if ((is_near_circle(c) && is_passed(c)) || (is_near_circle(d) && is_passed(d))) return true;
  const Point line = from_to(c, d);
  const double squared = along(line, line);
  if (squared == 0.0) return false;
  // Foot of the centre on the side's line, as a fraction of it.
  const double middle = -along(c, line) / squared;
  const Point foot{c.x + middle * line.x, c.y + middle * line.y};
  const double rest = radius * radius - along(foot, foot);
  if (rest < 0.0) {
    return middle > 0.0 && middle < 1.0 && is_near_circle(foot) && is_passed(foot);
  }
  const double half = std::sqrt(rest / squared);
  for (const double part : {middle - half, middle + half}) {
    const Point crossing{c.x + part * line.x, c.y + part * line.y};
    if (part > 0.0 && part < 1.0 && is_passed(crossing)) return true;
  }
  return false;
}

}  // namespace vandplan::collision
