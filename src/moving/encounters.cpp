// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "moving/encounters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/trigonometry.h"
#include "geometry/convex.h"

namespace vandplan::moving {
namespace {

using collision::Rectangle;

/// Rotation and translation of a frame.
struct Frame {
  double x, y, sin, cos;

  [[nodiscard]] Point place(const Point& p) const noexcept {
    return {x + cos * p.x - sin * p.y, y + sin * p.x + cos * p.y};
  }
};

/// Frame of `pose`, in the frame of `seen_from`.
Frame frame_of(const Pose& pose, const Pose& seen_from) noexcept {
  const auto [sin, cos] = base::sin_cos(seen_from.heading);
  const double dx = pose.x - seen_from.x;
  const double dy = pose.y - seen_from.y;
  const auto turn = base::sin_cos(pose.heading - seen_from.heading);
  return {cos * dx + sin * dy, cos * dy - sin * dx, turn.sin, turn.cos};
}

/// Whether the side from a to b crosses the positive x axis.
bool passes_ahead(const Point& a, const Point& b) noexcept {
  if ((a.y > 0.0) == (b.y > 0.0)) return false;
  return (a.x * (b.y - a.y) - a.y * (b.x - a.x) > 0.0) == (b.y > a.y);
}

/// Square of the distance between a body and an outline [m^2]; 0 if they overlap. The body is
/// `corners`, or `box` if `corners` is empty. `frame` places the outline in the body's frame.
double squared_gap(const Rectangle& box, std::span<const Point> corners,
                   std::span<const Point> outline, const Frame& frame) noexcept {
  double least = std::numeric_limits<double>::infinity();
  bool holds_axle = false;
  Point from = frame.place(outline.back());
  for (const Point& corner : outline) {
    const Point to = frame.place(corner);
    least = std::min(least, corners.empty() ? collision::squared_distance(box, from, to)
                                            : geometry::squared_distance(corners, from, to));
    holds_axle ^= passes_ahead(from, to);
    from = to;
  }
  return holds_axle ? 0.0 : least;
}

/// Distance of the middle of the bounding box from the outline [m]; 0 if the middle is outside.
double core_of(std::span<const Point> outline, const Bounds& box) noexcept {
  const Frame centred{-(box.x_min + box.x_max) / 2, -(box.y_min + box.y_max) / 2, 0.0, 1.0};
  constexpr Rectangle point{0.0, 0.0, 0.0};
  double least = std::numeric_limits<double>::infinity();
  bool is_within = false;
  Point from = centred.place(outline.back());
  for (const Point& corner : outline) {
    const Point to = centred.place(corner);
    least = std::min(least, collision::squared_distance(point, from, to));
    is_within ^= passes_ahead(from, to);
    from = to;
  }
  return is_within ? std::sqrt(least) : 0.0;
}

}  // namespace

Encounters::Body Encounters::body_of(const auto& part) {
  const Footprint box = footprint(part);
  return {{box.rear, box.front, box.half_width},
          part.outline.empty() ? Polygon{} : body_outline(part),
          std::hypot(std::max(box.rear, box.front), box.half_width)};
}

Encounters::Encounters(const Course& course, std::span<const MovingObstacle> moving, double margin)
    : vehicle_(course.vehicle), way_(course.path), body_(body_of(course.vehicle)), margin_(margin) {
  if (vehicle_.trailer) trailer_ = body_of(*vehicle_.trailer);
  Begin begin{0.0, 0.0, course.hitch_angle};
  for (const Segment& segment : way_.segments()) {
    begins_.push_back(begin);
    const double way = std::abs(segment.length);
    const double bend = std::max(std::abs(segment.curvature), std::abs(curvature_at(segment, way)));
    double fastest = 1.0 + bend * body_.reach;
    if (trailer_) {
      const double of_hitch = std::hypot(1.0, vehicle_.hitch * bend);
      const double turn = trailer_->reach / vehicle_.trailer->wheelbase;
      fastest = std::max(fastest, of_hitch * (1.0 + turn));
    }
    begin.s += way;
    begin.driven += way * fastest;
    begin.hitch_angle = hitch_angle_after(vehicle_, begin.hitch_angle, segment);
  }
  begins_.push_back(begin);
  movers_.reserve(moving.size());
  for (const MovingObstacle& obstacle : moving) movers_.push_back(mover_of(obstacle));
}

State Encounters::state_at(double s) const {
  const Pose pose = way_.at(s, true).pose;
  if (!trailer_) return {pose, 0.0};
  const auto later = std::ranges::upper_bound(begins_, s, {}, &Begin::s);
  const auto after = static_cast<std::size_t>(later - begins_.begin());
  const std::size_t i = std::clamp<std::size_t>(after, 1, begins_.size()) - 1;
  const double angle = begins_[i].hitch_angle;
  if (i + 1 == begins_.size()) return {pose, angle};
  return {pose,
          hitch_angle_after(vehicle_, angle, part_of(way_.segments()[i], 0.0, s - begins_[i].s))};
}

Encounters::Mover Encounters::mover_of(const MovingObstacle& obstacle) {
  const Bounds box = bounding_box(obstacle.outline);
  Mover mover{.obstacle = &obstacle,
              .centre = {(box.x_min + box.x_max) / 2, (box.y_min + box.y_max) / 2},
              .reach = 0.0,
              .core = core_of(obstacle.outline, box),
              .moved = {0.0},
              .before = obstacle.inflate};
  double turns = 0.0;  // distance of the furthest corner from the centre of rotation [m]
  for (const Point& corner : obstacle.outline) {
    const Point& c = mover.centre;
    mover.reach = std::max(mover.reach, std::hypot(corner.x - c.x, corner.y - c.y));
    turns = std::max(turns, std::hypot(corner.x, corner.y));
  }
  const std::vector<TimedPose>& rows = obstacle.trajectory;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Pose& from = rows[i - 1].pose;
    const Pose& to = rows[i].pose;
    const double way = std::hypot(to.x - from.x, to.y - from.y);
    const double turn = std::abs(wrap_angle(to.heading - from.heading));
    const double growth = obstacle.inflate * (rows[i].t - rows[i - 1].t);
    mover.moved.push_back(mover.moved.back() + way + turn * turns + growth);
  }
  return mover;
}

double Encounters::gap(std::size_t i, const State& state, double t, double enough) const noexcept {
  const double least = gap(movers_[i], body_, state.pose, t, enough);
  if (!trailer_) return least;
  return std::min(least, gap(movers_[i], *trailer_, trailer_pose(vehicle_, state), t, enough));
}

double Encounters::gap(const Mover& mover, const Body& body, const Pose& pose, double t,
                       double enough) const noexcept {
  const MovingObstacle& obstacle = *mover.obstacle;
  const double kept = margin_ + growth_at(obstacle, t);
  const Frame frame = frame_of(*vandplan::pose_at(obstacle, t), pose);
  // 1. A circle around the outline: is it far enough?
  const Point centre = frame.place(mover.centre);
  const double dx = std::max({-body.box.back - centre.x, centre.x - body.box.front, 0.0});
  const double dy = std::max(std::abs(centre.y) - body.box.half_width, 0.0);
  const double coarse = std::hypot(dx, dy) - mover.reach - kept;
  if (coarse >= enough) return coarse;
  // 2. The exact distance of the outline.
  return std::sqrt(squared_gap(body.box, body.corners, obstacle.outline, frame)) - kept;
}

double Encounters::depth(std::size_t i, const State& state, double t) const noexcept {
  const Mover& mover = movers_[i];
  const MovingObstacle& obstacle = *mover.obstacle;
  const Pose there = *vandplan::pose_at(obstacle, t);
  double nearest = distance_of(body_, frame_of(there, state.pose).place(mover.centre));
  if (trailer_) {
    const Frame frame = frame_of(there, trailer_pose(vehicle_, state));
    nearest = std::min(nearest, distance_of(*trailer_, frame.place(mover.centre)));
  }
  return mover.core + margin_ + growth_at(obstacle, t) - nearest;
}

/// Distance of a point from a body, in the body's frame [m]; negative inside.
double Encounters::distance_of(const Body& body, const Point& point) noexcept {
  if (!body.corners.empty()) return geometry::signed_distance(body.corners, point);
  const double x = std::max(-body.box.back - point.x, point.x - body.box.front);
  const double y = std::abs(point.y) - body.box.half_width;
  return x > 0.0 && y > 0.0 ? std::hypot(x, y) : std::max(x, y);
}

double Encounters::driven(double s) const noexcept {
  const auto next = std::ranges::upper_bound(begins_, s, {}, &Begin::s);
  if (next == begins_.end()) return begins_.back().driven;
  if (next == begins_.begin()) return 0.0;
  const Begin& from = *std::prev(next);
  return from.driven + (s - from.s) / (next->s - from.s) * (next->driven - from.driven);
}

double Encounters::moved(std::size_t i, double t) const noexcept {
  const Mover& mover = movers_[i];
  const std::vector<TimedPose>& rows = mover.obstacle->trajectory;
  if (t >= rows.back().t) return mover.moved.back();
  const auto next = std::ranges::upper_bound(rows, t, {}, &TimedPose::t);
  if (next == rows.begin()) return mover.before * (t - next->t);
  const auto k = static_cast<std::size_t>(next - rows.begin());
  const double share = (t - rows[k - 1].t) / (rows[k].t - rows[k - 1].t);
  return mover.moved[k - 1] + share * (mover.moved[k] - mover.moved[k - 1]);
}

double Encounters::rests(std::size_t i) const noexcept {
  return movers_[i].obstacle->trajectory.back().t;
}

std::optional<double> Encounters::leaves(std::size_t i) const noexcept {
  const MovingObstacle& obstacle = *movers_[i].obstacle;
  if (obstacle.after == Afterwards::stays) return std::nullopt;
  return obstacle.trajectory.back().t;
}

}  // namespace vandplan::moving
