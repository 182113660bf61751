// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace vandplan::judge {
namespace {

/// Where a body and a side, or a point, are nearest.
struct Gap {
  double distance = 0.0;
  Point on_body;
  Point on_side;
};

Gap gap_between(const Point& on_body, const Point& on_side) {
  const double dx = on_side.x - on_body.x;
  const double dy = on_side.y - on_body.y;
  return {std::sqrt(dx * dx + dy * dy), on_body, on_side};
}

const Gap& nearer(const Gap& a, const Gap& b) { return b.distance < a.distance ? b : a; }

Gap gap_to_point(const Point& p, const Rectangle& body) {
  return gap_between(
      {std::clamp(p.x, body.x_min, body.x_max), std::clamp(p.y, body.y_min, body.y_max)}, p);
}

/// Between a point of the body and a side, from a to b.
Gap gap_to_side(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double part = squared > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared : 0.0;
  const double nearest = std::clamp(part, 0.0, 1.0);
  return gap_between(p, {a.x + nearest * dx, a.y + nearest * dy});
}

/// Of two convex sets that are apart one is nearest at a corner of the other.
Gap gap_of_side(const Point& a, const Point& b, const Rectangle& body) {
  const std::array<Point, 4> corners = corners_of(body);
  // Two convex sets are apart exactly if one of the directions of their sides tells them apart.
  bool apart = std::max(a.x, b.x) < body.x_min || std::min(a.x, b.x) > body.x_max ||
               std::max(a.y, b.y) < body.y_min || std::min(a.y, b.y) > body.y_max;
  int left = 0;
  int right = 0;
  for (const Point& corner : corners) {
    const double cross = (b.x - a.x) * (corner.y - a.y) - (b.y - a.y) * (corner.x - a.x);
    left += cross > 0;
    right += cross < 0;
  }
  apart = apart || left == 4 || right == 4;
  if (!apart) return {};
  Gap gap = nearer(gap_to_point(a, body), gap_to_point(b, body));
  for (const Point& corner : corners) gap = nearer(gap, gap_to_side(corner, a, b));
  return gap;
}

/// How far the nearest of some points stays ahead of another, along a direction.
double least_ahead(const Passage& passage, const Point& from, const Point& direction,
                   std::span<const Point> points) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point& p : points) {
    const double ahead = (p.x - from.x) * direction.x + (p.y - from.y) * direction.y;
    least = std::min(least, ahead - approach(passage, p, direction));
  }
  return least;
}

double clearance_of_side(const Passage& passage, const Rectangle& body, const Point& a,
                         const Point& b) {
  const Gap gap = gap_of_side(a, b, body);
  if (gap.distance == 0 || passage.half == 0) return gap.distance;
  const auto& [distance, here, there] = gap;
  const Point to_side{(there.x - here.x) / distance, (there.y - here.y) / distance};
  // Two lines through the ends of the gap, square to it: neither body nor side reach beyond its
  // own. The one at the body stays with the body, and the ends of the side approach it.
  const std::array<Point, 2> ends = {a, b};
  const double at_body = std::max({least_ahead(passage, here, to_side, ends),
                                   least_ahead(passage, {0, body.y_max}, {0, 1}, ends),
                                   least_ahead(passage, {0, body.y_min}, {0, -1}, ends)});
  if (std::hypot(b.x - a.x, b.y - a.y) <= body.x_max - body.x_min) return std::max(0.0, at_body);
  // The one at the side stays there, and the corners of the body approach it. Of long sides, whose
  // ends turn by far more than the body does, it tells more.
  const Point to_body{-to_side.x, -to_side.y};
  return std::max({0.0, at_body, least_ahead(passage, there, to_body, corners_of(body))});
}

}  // namespace

std::array<Point, 4> corners_of(const Rectangle& body) {
  return {Point{body.x_min, body.y_min},
          {body.x_max, body.y_min},
          {body.x_max, body.y_max},
          {body.x_min, body.y_max}};
}

double reach_of(const Rectangle& body) {
  return std::hypot(std::max(-body.x_min, body.x_max), std::max(-body.y_min, body.y_max));
}

double deviation(const Passage& passage, const Rectangle& body) {
  if (passage.rate == 0) return 0;
  const double square = passage.half * passage.half;
  return std::abs(passage.rate) * square * (passage.half / 6 + reach_of(body) / 2);
}

double approach(const Passage& passage, const Point& p, const Point& direction) {
  const double curvature = passage.curvature;
  const double half = passage.half;
  const Point velocity{curvature * p.y - 1, -curvature * p.x};  // for each metre driven
  const double speed = std::sqrt(velocity.x * velocity.x + velocity.y * velocity.y);
  const double along = std::abs(velocity.x * direction.x + velocity.y * direction.y);
  const double turning = std::abs(curvature) * speed * half * half / 2;
  return std::min(speed * half, along * half + turning);
}

double clearance_of_disc(const Passage& passage, const Rectangle& body, const Point& centre,
                         double radius) {
  const Gap gap = gap_to_point(centre, body);
  if (gap.distance == 0) return -radius;
  const Point direction{(centre.x - gap.on_body.x) / gap.distance,
                        (centre.y - gap.on_body.y) / gap.distance};
  const double ahead = gap.distance - approach(passage, centre, direction);
  const double aside = std::max(centre.y - body.y_max, body.y_min - centre.y);
  return std::max(ahead, aside - approach(passage, centre, {0, 1})) - radius;
}

double clearance_of_seen(const Passage& passage, const Rectangle& body,
                         std::span<const Point> polygon, double most) {
  double least = most;
  // The body holds its rear axle, the origin. If no side touches the body, the body is inside the
  // polygon exactly if a ray from the origin crosses an odd number of sides.
  bool inside = false;
  Point a = polygon.back();
  for (const Point& b : polygon) {
    const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const double radius = std::hypot(b.x - a.x, b.y - a.y) / 2;
    if (clearance_of_disc(passage, body, middle, radius) < least) {
      least = std::min(least, clearance_of_side(passage, body, a, b));
    }
    if ((a.y > 0) != (b.y > 0) && a.x - a.y * (b.x - a.x) / (b.y - a.y) > 0) inside = !inside;
    a = b;
  }
  return inside ? 0.0 : least;
}

double clearance(const Passage& passage, const Rectangle& body, const Polygon& polygon,
                 double most) {
  const Position& position = passage.middle;
  const auto cos = static_cast<double>(std::cos(position.heading));
  const auto sin = static_cast<double>(std::sin(position.heading));
  std::vector<Point> seen;
  seen.reserve(polygon.size());
  for (const Point& corner : polygon) {
    const auto dx = static_cast<double>(corner.x - position.x);
    const auto dy = static_cast<double>(corner.y - position.y);
    seen.push_back({dx * cos + dy * sin, dy * cos - dx * sin});
  }
  const double aside = deviation(passage, body);
  return std::clamp(clearance_of_seen(passage, body, seen, most + aside) - aside, 0.0, most);
}

}  // namespace vandplan::judge
