// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where are bodies, things and places, and how does a vehicle move, in the eyes of the naive judge?

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/vehicle.h"

namespace vandplan::nasty {

using Real = long double;

inline constexpr Real pi = std::numbers::pi_v<Real>;

struct Vector {
  Real x = 0, y = 0;
};

struct Rectangle {
  Real x_min, x_max, y_min, y_max;
};

/// A convex body: what is to the left of all its sides, each moved outwards by a margin.
struct Body {
  struct Line {
    Vector outwards;  // unit vector
    Real offset;      // of the line from the origin, that way
    [[nodiscard]] Real beyond(const Vector& p) const {
      return outwards.x * p.x + outwards.y * p.y - offset;
    }
  };
  std::vector<Line> sides;
  std::vector<Vector> corners;  // where neighbouring sides meet
  Vector middle;
  Real reach = 0;
};

/// The corners in either order.
inline Body body_with(const Polygon& given, Real margin) {
  Body body;
  Real area = 0;
  for (std::size_t i = 0, j = given.size() - 1; i < given.size(); j = i++) {
    area += Real{given[j].x} * given[i].y - Real{given[j].y} * given[i].x;
    body.middle.x += Real{given[i].x} / given.size();
    body.middle.y += Real{given[i].y} / given.size();
  }
  for (std::size_t i = 0, j = given.size() - 1; i < given.size(); j = i++) {
    const Real dx = Real{given[i].x} - given[j].x;
    const Real dy = Real{given[i].y} - given[j].y;
    const Real length = area > 0 ? std::hypot(dx, dy) : -std::hypot(dx, dy);
    const Vector outwards{dy / length, -dx / length};
    body.sides.push_back({outwards, outwards.x * given[i].x + outwards.y * given[i].y + margin});
  }
  for (std::size_t i = 0, j = body.sides.size() - 1; i < body.sides.size(); j = i++) {
    const auto& [n, c] = body.sides[j];
    const auto& [m, d] = body.sides[i];
    const Real sine = n.x * m.y - n.y * m.x;
    body.corners.push_back({(c * m.y - d * n.y) / sine, (d * n.x - c * m.x) / sine});
  }
  for (const Vector& c : body.corners) body.reach = std::max(body.reach, std::hypot(c.x, c.y));
  return body;
}

inline Polygon rectangle(double rear, double front, double half_width) {
  return {{rear, -half_width}, {front, -half_width}, {front, half_width}, {rear, half_width}};
}

inline Body body_of(const Vehicle& v, Real margin) {
  if (!v.outline.empty()) return body_with(v.outline, margin);
  return body_with(rectangle(-v.rear_overhang, v.wheelbase + v.front_overhang, v.width / 2),
                   margin);
}

inline Body body_of(const Trailer& t, Real margin) {
  if (!t.outline.empty()) return body_with(t.outline, margin);
  return body_with(rectangle(-t.rear_overhang, t.wheelbase + t.front_overhang, t.width / 2),
                   margin);
}

inline Body wheels_of(const Vehicle& v, Real margin) {
  return body_with(rectangle(0, v.wheelbase, v.track_width.value_or(v.width) / 2), margin);
}

/// Where something is in a frame of somebody else: in the vehicle's or in the map's.
struct Frame {
  Vector origin;
  Real cosine, sine;

  [[nodiscard]] Vector seen(const Vector& p) const {
    const Real x = p.x - origin.x;
    const Real y = p.y - origin.y;
    return {cosine * x + sine * y, cosine * y - sine * x};
  }
  [[nodiscard]] Vector placed(const Vector& p) const {
    return {origin.x + cosine * p.x - sine * p.y, origin.y + sine * p.x + cosine * p.y};
  }
};

inline Frame frame_at(const Vector& origin, Real heading) {
  return {origin, std::cos(heading), std::sin(heading)};
}

/// Whether a part of the side lies inside the open body (Cyrus and Beck 1978).
inline bool runs_through(const Vector& a, const Vector& b, const Body& body) {
  Real begin = 0;
  Real end = 1;
  for (const Body::Line& side : body.sides) {
    const Real first = side.beyond(a);
    const Real last = side.beyond(b);
    if (first >= 0 && last >= 0) return false;
    if (first < 0 && last < 0) continue;
    const Real crossing = first / (first - last);
    (first > 0 ? begin : end) = first > 0 ? std::max(begin, crossing) : std::min(end, crossing);
  }
  if (begin > end) return false;
  const Real middle = (begin + end) / 2;
  const Vector p{a.x + middle * (b.x - a.x), a.y + middle * (b.y - a.y)};
  return std::ranges::all_of(body.sides, [&](const auto& side) { return side.beyond(p) < 0; });
}

inline bool holds(const std::vector<Vector>& polygon, const Vector& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector& a = polygon[j];
    const Vector& b = polygon[i];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// A polygon whose corners count from the start, and a box around it.
struct Thing {
  std::string name;
  std::vector<Vector> corners;
  Rectangle box;
};

inline Thing thing_of(const std::string& name, const Polygon& polygon, const Pose& start) {
  constexpr Real far = 1e300;
  Thing thing{name, {}, {far, -far, far, -far}};
  for (const Point& p : polygon) {
    const Vector corner{Real{p.x} - start.x, Real{p.y} - start.y};
    thing.corners.push_back(corner);
    thing.box = {std::min(thing.box.x_min, corner.x), std::max(thing.box.x_max, corner.x),
                 std::min(thing.box.y_min, corner.y), std::max(thing.box.y_max, corner.y)};
  }
  return thing;
}

inline bool hits(const Thing& thing, const Body& body, const Frame& vehicle) {
  std::vector<Vector> seen;
  for (const Vector& corner : thing.corners) seen.push_back(vehicle.seen(corner));
  for (std::size_t i = 0, j = seen.size() - 1; i < seen.size(); j = i++) {
    if (runs_through(seen[j], seen[i], body)) return true;
  }
  return holds(seen, body.middle);
}

/// A vehicle on its way, its place counted from the start.
struct Drive {
  Vector place;
  Real heading;
  Real angle;  ///< at the hitch, if there is a trailer

  /// A step so short that three Gauss nodes are exact to the last digits.
  void step(Real curvature, Real rate, Real signed_step) {
    const Real gear = signed_step < 0 ? -1 : 1;
    const Real driven = std::abs(signed_step);
    const auto heading_at = [&](Real t) { return heading + gear * t * (curvature + rate * t / 2); };
    const Real node = std::sqrt(Real{3} / 5);
    for (const auto& [at, weight] : {std::pair<Real, Real>{-node, 5}, {0, 8}, {node, 5}}) {
      const Real there = heading_at(driven / 2 * (1 + at));
      place.x += signed_step * weight / 18 * std::cos(there);
      place.y += signed_step * weight / 18 * std::sin(there);
    }
    heading = heading_at(driven);
  }

  /// What that does to the hitch angle, by small steps of Runge and Kutta.
  void fold(const Vehicle& vehicle, Real curvature, Real rate, Real signed_step) {
    const Real gear = signed_step < 0 ? -1 : 1;
    const Real driven = std::abs(signed_step);
    const Real hitch = vehicle.hitch, wheelbase = vehicle.trailer->wheelbase;
    const auto slope = [&](Real t, Real a) {
      const Real k = curvature + rate * t;
      return gear * (k - (std::sin(a) + hitch * k * std::cos(a)) / wheelbase);
    };
    const Real steepest = std::max(std::abs(curvature), std::abs(curvature + rate * driven));
    const Real pace = (1 + std::abs(hitch) * steepest) / wheelbase + steepest;
    const auto steps = 1 + static_cast<long>(std::min<Real>(256 * driven * pace, 1e6L));
    const Real h = driven / steps;
    for (long i = 0; i < steps; ++i) {
      const Real t = h * i;
      const Real first = slope(t, angle);
      const Real second = slope(t + h / 2, angle + h / 2 * first);
      const Real third = slope(t + h / 2, angle + h / 2 * second);
      angle += h / 6 * (first + 2 * second + 2 * third + slope(t + h, angle + h * third));
    }
  }
};

inline Real from_segment(const Vector& p, const Vector& a, const Vector& b) {
  const Vector along{b.x - a.x, b.y - a.y};
  const Real square = along.x * along.x + along.y * along.y;
  Real t = square > 0 ? ((p.x - a.x) * along.x + (p.y - a.y) * along.y) / square : 0;
  t = std::min(std::max(t, Real{0}), Real{1});
  return std::hypot(p.x - a.x - t * along.x, p.y - a.y - t * along.y);
}

/// How far a place is from an area: by the angles under which it sees the sides whether it is in
/// it.
inline Real from_area(const Polygon& area, const Pose& origin, const Vector& p) {
  Real turns = 0;
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Point& from = area[i];
    const Point& to = area[(i + 1) % area.size()];
    const Vector a{Real{from.x} - origin.x, Real{from.y} - origin.y};
    const Vector b{Real{to.x} - origin.x, Real{to.y} - origin.y};
    least = std::min(least, from_segment(p, a, b));
    turns +=
        std::remainder(std::atan2(b.y - p.y, b.x - p.x) - std::atan2(a.y - p.y, a.x - p.x), 2 * pi);
  }
  return std::abs(turns) > pi ? 0 : least;
}

inline Real beyond(Real value, Real least, Real most) {
  return std::max({least - value, value - most, Real{0}});
}

/// How far a heading is beyond all of a range, counter-clockwise from the first to the last.
inline Real beyond_headings(Real heading, const HeadingRange& range) {
  Real width = Real{range.to} - range.from;
  while (width < 0) width += 2 * pi;
  Real after = std::fmod(heading - range.from, 2 * pi);
  if (after < 0) after += 2 * pi;
  return after <= width ? 0 : std::min(after - width, 2 * pi - after);
}

}  // namespace vandplan::nasty
