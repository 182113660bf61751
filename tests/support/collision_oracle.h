// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the body from the obstacles, at a pose and along an edge?
//
// Slow and obvious: distances are those of points to sides, and motion is bounded by
// ds * (1 + |curvature| * reach), so that halving intervals finds the least distance of an edge.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

/// The distance of two sets and where they are nearest; 0 if they meet [m].
struct Gap {
  double distance = std::numeric_limits<double>::infinity();
  Point on_body;
  Point on_obstacle;
};

/// Keeps the nearer of two gaps.
inline void keep_nearer(Gap& gap, const Gap& other) {
  if (other.distance < gap.distance) gap = other;
}

inline Point nearest_on_side(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double t = squared > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared : 0.0;
  const double part = std::clamp(t, 0.0, 1.0);
  return {a.x + part * dx, a.y + part * dy};
}

/// Keeps the gap between two points if it is nearer.
inline void keep_nearer(Gap& gap, const Point& on_body, const Point& on_obstacle) {
  const double dx = on_body.x - on_obstacle.x;
  const double dy = on_body.y - on_obstacle.y;
  const double squared = dx * dx + dy * dy;
  if (squared < gap.distance * gap.distance) gap = {std::sqrt(squared), on_body, on_obstacle};
}

/// Twice the area of the triangle; positive if it runs counter-clockwise.
inline double orientation(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether two sides cross in a point inside both.
inline bool cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 &&
         orientation(c, d, a) * orientation(c, d, b) < 0;
}

inline bool contains(std::span<const Point> polygon, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point& a = polygon[j];
    const Point& b = polygon[i];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// Between two closed polygons: they meet if sides cross or one holds a corner of the other, and
/// else are nearest at a corner of one of them.
inline Gap gap_between(std::span<const Point> body, std::span<const Point> obstacle) {
  const Gap none{0.0, body[0], body[0]};
  if (contains(obstacle, body[0]) || contains(body, obstacle[0])) return none;
  Gap gap;
  for (std::size_t i = 0, j = body.size() - 1; i < body.size(); j = i++) {
    for (std::size_t k = 0, l = obstacle.size() - 1; k < obstacle.size(); l = k++) {
      if (cross(body[j], body[i], obstacle[l], obstacle[k])) return none;
      keep_nearer(gap, body[i], nearest_on_side(body[i], obstacle[l], obstacle[k]));
      keep_nearer(gap, nearest_on_side(obstacle[k], body[j], body[i]), obstacle[k]);
    }
  }
  return gap;
}

/// What moves: the corners of a footprint, or of whatever outline a vehicle has.
struct OracleBody {
  OracleBody(const Footprint& footprint) {
    for (const Point& corner : vandplan::corners(footprint, {})) corners.push_back(corner);
  }
  OracleBody(const Vehicle& vehicle) : OracleBody(footprint(vehicle)) {
    if (!vehicle.outline.empty()) corners = vehicle.outline;
  }

  [[nodiscard]] Polygon at(const Pose& pose) const {
    Polygon there;
    const double cos = std::cos(pose.heading);
    const double sin = std::sin(pose.heading);
    for (const auto& [x, y] : corners) {
      there.push_back({pose.x + x * cos - y * sin, pose.y + x * sin + y * cos});
    }
    return there;
  }

  [[nodiscard]] double reach() const {
    double most = 0;
    for (const auto& [x, y] : corners) most = std::max(most, std::hypot(x, y));
    return most;
  }

  Polygon corners;
};

inline Gap gap_at(const OracleBody& body, std::span<const Polygon> obstacles, const Pose& pose) {
  const Polygon there = body.at(pose);
  Gap gap;
  for (const Polygon& obstacle : obstacles) keep_nearer(gap, gap_between(there, obstacle));
  return gap;
}

/// A stretch of a segment between two poses where the gap is known.
struct Stretch {
  double begin, end;  // driven, signed as the segment's length
  double at_begin, at_end;

  /// No gap between the poses is less, if no point of the footprint is faster than `speed`.
  [[nodiscard]] double bound(double speed) const {
    return (at_begin + at_end - std::abs(end - begin) * speed) / 2;
  }
};

/// How fast points of the body may move, with the rear axle at speed 1.
inline double top_speed(const OracleBody& body, const Segment& segment) {
  const double last = curvature_at(segment, std::abs(segment.length));
  return 1 + std::max(std::abs(segment.curvature), std::abs(last)) * body.reach();
}

/// The least gap along a segment, its distance at most `error` above the truth.
inline Gap least_gap(const OracleBody& body, std::span<const Polygon> obstacles, const Pose& from,
                     const Segment& segment, double error) {
  const double speed = top_speed(body, segment);
  const auto at = [&](double s) {
    return gap_at(body, obstacles, advance(from, part_of(segment, 0, std::abs(s))));
  };
  Gap least = at(0);
  const Gap last = at(segment.length);
  std::vector<Stretch> open = {{0, segment.length, least.distance, last.distance}};
  keep_nearer(least, last);
  while (!open.empty() && least.distance > 0) {
    const Stretch s = open.back();
    open.pop_back();
    if (s.bound(speed) >= least.distance - error) continue;
    const double middle = (s.begin + s.end) / 2;
    const Gap gap = at(middle);
    keep_nearer(least, gap);
    open.push_back({s.begin, middle, s.at_begin, gap.distance});
    open.push_back({middle, s.end, gap.distance, s.at_end});
  }
  return least;
}

inline Gap least_gap(const OracleBody& body, std::span<const Polygon> obstacles, const Path& path,
                     double error) {
  Gap least = gap_at(body, obstacles, path.start);
  Pose pose = path.start;
  for (const Segment& segment : path.segments) {
    keep_nearer(least, least_gap(body, obstacles, pose, segment, error));
    pose = advance(pose, segment);
  }
  return least;
}

/// Whether the gap is anywhere along a segment at most `distance`.
inline bool comes_within(double distance, const OracleBody& body,
                         std::span<const Polygon> obstacles, const Pose& from,
                         const Segment& segment) {
  const double speed = top_speed(body, segment);
  const auto at = [&](double s) {
    return gap_at(body, obstacles, advance(from, part_of(segment, 0, std::abs(s)))).distance;
  };
  std::vector<Stretch> open = {{0, segment.length, at(0), at(segment.length)}};
  while (!open.empty()) {
    const Stretch s = open.back();
    open.pop_back();
    if (s.at_begin <= distance || s.at_end <= distance) return true;
    if (s.bound(speed) > distance) continue;
    const double middle = (s.begin + s.end) / 2;
    const double gap = at(middle);
    open.push_back({s.begin, middle, s.at_begin, gap});
    open.push_back({middle, s.end, gap, s.at_end});
  }
  return false;
}

inline bool comes_within(double distance, const OracleBody& body,
                         std::span<const Polygon> obstacles, const Path& path) {
  Pose pose = path.start;
  for (const Segment& segment : path.segments) {
    if (comes_within(distance, body, obstacles, pose, segment)) return true;
    pose = advance(pose, segment);
  }
  return false;
}

}  // namespace vandplan
