// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "nasty/naive_drive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "nasty/naive_geometry.h"

namespace vandplan::nasty {
namespace {

constexpr int moments = 20'000;

/// A body at a pose, as corners that count from the start.
std::vector<Vector> corners_at(const Body& body, const Vector& place, Real heading) {
  const Frame frame = frame_at(place, heading);
  std::vector<Vector> corners;
  for (const Vector& corner : body.corners) corners.push_back(frame.placed(corner));
  return corners;
}

/// The corners of an obstacle at a time; none if it has left.
std::vector<Vector> corners_at(const MovingObstacle& obstacle, const Pose& start, Real t) {
  const std::vector<TimedPose>& rows = obstacle.trajectory;
  if (t > rows.back().t && obstacle.after == Afterwards::leaves) return {};
  std::size_t next = 0;
  while (next < rows.size() && rows[next].t <= t) ++next;
  const TimedPose& before = rows[next == 0 ? 0 : next - 1];
  const TimedPose& after = rows[std::min(next, rows.size() - 1)];
  const Real part = after.t > before.t ? (t - before.t) / (Real{after.t} - before.t) : 0;
  const Pose& a = before.pose;
  const Pose& b = after.pose;
  const Real turn = std::remainder(Real{b.heading} - a.heading, 2 * pi);
  const Vector place{Real{a.x} - start.x + part * (Real{b.x} - a.x),
                     Real{a.y} - start.y + part * (Real{b.y} - a.y)};
  const Frame frame = frame_at(place, a.heading + part * turn);
  std::vector<Vector> corners;
  for (const Point& corner : obstacle.outline)
    corners.push_back(frame.placed({corner.x, corner.y}));
  return corners;
}

/// How far each corner of `a` is from the sides of `b`, at least.
Real from_corners(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  Real least = std::numeric_limits<Real>::infinity();
  for (const Vector& corner : a) {
    for (std::size_t i = 0, j = b.size() - 1; i < b.size(); j = i++) {
      least = std::min(least, from_segment(corner, b[j], b[i]));
    }
  }
  return least;
}

/// Whether a body that was made smaller, at a pose, and a polygon overlap.
bool overlaps(const Body& smaller, const Vector& place, Real heading,
              const std::vector<Vector>& polygon) {
  Thing thing;
  thing.corners = polygon;
  return hits(thing, smaller, frame_at(place, heading));
}

/// The bodies of a vehicle, as they are and made smaller.
class Company {
 public:
  Company(const Scenario& scenario, double margin)
      : scenario_(scenario), margin_(margin), body_(body_of(scenario.vehicle, 0)) {
    if (scenario.vehicle.width > 4 * allowed_nearness) {
      small_ = body_of(scenario.vehicle, -allowed_nearness);
    }
    if (!scenario.vehicle.trailer) return;
    trailer_ = body_of(*scenario.vehicle.trailer, 0);
    if (scenario.vehicle.trailer->width > 4 * allowed_nearness) {
      small_trailer_ = body_of(*scenario.vehicle.trailer, -allowed_nearness);
    }
  }

  /// The obstacle that is met at a time, or empty.
  [[nodiscard]] std::string met(const Drive& at, Real t) const {
    for (std::size_t i = 0; i < scenario_.moving.size(); ++i) {
      const MovingObstacle& obstacle = scenario_.moving[i];
      const std::vector<Vector> outline = corners_at(obstacle, scenario_.start, t);
      if (outline.empty()) continue;
      const Real grown = obstacle.inflate * std::clamp<Real>(t, 0, obstacle.trajectory.back().t);
      const std::string name = "moving[" + std::to_string(i) + "]";
      if (meets(body_, small_, at.place, at.heading, outline, grown)) return name;
      if (!scenario_.vehicle.trailer) continue;
      const Vehicle& v = scenario_.vehicle;
      const Vector hitch = frame_at(at.place, at.heading).placed({v.hitch, 0});
      const Real heading = at.heading - at.angle;
      const Vector axle = frame_at(hitch, heading).placed({-v.trailer->wheelbase, 0});
      if (meets(trailer_, small_trailer_, axle, heading, outline, grown)) {
        return name + " with the trailer";
      }
    }
    return "";
  }

 private:
  [[nodiscard]] bool meets(const Body& body, const std::optional<Body>& small, const Vector& place,
                           Real heading, const std::vector<Vector>& outline, Real grown) const {
    if (small && overlaps(*small, place, heading, outline)) return true;
    const Real kept = margin_ + grown - allowed_nearness;
    if (kept <= 0) return false;
    const std::vector<Vector> corners = corners_at(body, place, heading);
    return std::min(from_corners(corners, outline), from_corners(outline, corners)) < kept;
  }

  const Scenario& scenario_;
  Real margin_;
  Body body_;
  std::optional<Body> small_;
  Body trailer_ = {};
  std::optional<Body> small_trailer_;
};

/// Drives on to a distance from the start of the path.
class Driver {
 public:
  Driver(const Scenario& scenario, const Path& path)
      : vehicle_(scenario.vehicle),
        path_(path),
        at_{{}, scenario.start.heading, scenario.hitch_angles.start} {}

  const Drive& drive_to(Real s) {
    while (segment_ < path_.segments.size()) {
      const Segment& segment = path_.segments[segment_];
      const Real length = std::abs(Real{segment.length});
      const Real end = std::min(s - begin_, length);
      go(segment, end);
      if (end < length) break;
      begin_ += length;
      done_ = 0;
      ++segment_;
    }
    return at_;
  }

 private:
  void go(const Segment& segment, Real end) {
    const Real gear = segment.length < 0 ? -1 : 1;
    const Real far = std::max<Real>(end - done_, 0);
    const Real steepest = std::max(std::abs(Real{segment.curvature}),
                                   std::abs(segment.curvature + segment.curvature_rate * end));
    const auto steps = 1 + static_cast<long>(std::min<Real>(32 * far * steepest, 1000));
    for (long i = 0; i < steps && far > 0; ++i) {
      const Real curvature = segment.curvature + segment.curvature_rate * done_;
      const Real part = gear * far / steps;
      if (vehicle_.trailer) at_.fold(vehicle_, curvature, segment.curvature_rate, part);
      at_.step(curvature, segment.curvature_rate, part);
      done_ += far / steps;
    }
  }

  const Vehicle& vehicle_;
  const Path& path_;
  Drive at_;
  std::size_t segment_ = 0;
  Real begin_ = 0;  // where the segment begins on the path
  Real done_ = 0;   // how much of the segment is driven
};

/// Driven distance at a time, by the knot before it.
Real distance_at(const SpeedProfile& speeds, Real t) {
  std::size_t next = 1;
  while (next < speeds.knots.size() && speeds.knots[next].t <= t) ++next;
  const SpeedKnot& knot = speeds.knots[next - 1];
  const Real dt = std::min<Real>(t, speeds.duration) - knot.t;
  return knot.s + dt * (knot.v + dt * (Real{knot.a} / 2 + dt * knot.jerk / 6));
}

}  // namespace

std::string naive_flaw_of_drive(const Scenario& scenario, const TimedPath& drive, double margin) {
  const SpeedProfile& speeds = drive.speeds;
  Real length = 0;
  for (const Segment& segment : drive.path.segments) length += std::abs(Real{segment.length});
  if (speeds.knots.empty()) return "has no times";
  const Real slack = 1e-6L * (1 + length);
  if (std::abs(distance_at(speeds, speeds.duration) - length) > slack) return "ends on the way";
  const Company company(scenario, margin);
  Driver driver(scenario, drive.path);
  Real end = speeds.duration;
  for (const MovingObstacle& obstacle : scenario.moving) {
    end = std::max<Real>(end, obstacle.trajectory.back().t);
  }
  Real before = 0;
  for (int i = 0; i <= moments; ++i) {
    const Real t = (end + 1) * i / moments;
    const Real s = distance_at(speeds, t);
    if (s < before - slack) return "drives backwards along the path";
    before = std::max(before, s);
    const std::string met = company.met(driver.drive_to(s), t);
    if (!met.empty())
      return "meets " + met + " at " + std::to_string(static_cast<double>(t)) + " s";
  }
  return "";
}

std::string naive_meeting_at_start(const Scenario& scenario, double margin) {
  const Drive at{{}, scenario.start.heading, scenario.hitch_angles.start};
  return Company(scenario, margin + allowed_nearness).met(at, 0);
}

}  // namespace vandplan::nasty
