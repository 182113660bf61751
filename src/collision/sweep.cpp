// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "collision/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "base/trigonometry.h"
#include "geometry/convex.h"
#include "path/clothoid.h"

namespace vandplan::collision {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
// Largest deviation from the straight sweep of an arc that is tested as straight [m].
constexpr double straight_enough = 0.1e-3;
// Distance from the edge of the swept area at which a corner counts as covered [m].
constexpr double slack = 1e-6;
// Distance from the segment's start beyond which sides are cut before the test [m].
constexpr double far_away = 1e4;

double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

/// 1 + u without cancellation, for a unit vector (u, v).
double one_plus(double u, double v) { return u < 0 ? v * v / (1 - u) : 1 + u; }

struct Turned {
  double sin, cos;
  Point end;
};

/// Turn of an arc, and its end in the arc's frame.
Turned turned(double length, double curvature) noexcept {
  const double turn = length * curvature;
  // Half the turn gives 1 - cos(turn) without cancellation.
  const base::SinCos half = base::sin_cos(turn / 2);
  const double sin = 2 * half.sin * half.cos;
  const double cos = 1 - 2 * half.sin * half.sin;
  // Such a small turn moves nothing sideways in double precision.
  if (turn < 1e-15) return {sin, cos, {length, 0}};
  return {sin, cos, {sin / curvature, 2 * half.sin * half.sin / curvature}};
}

}  // namespace

Placement placement_of(const Pose& pose) noexcept {
  const auto [sin, cos] = base::sin_cos(pose.heading);
  return {{pose.x, pose.y}, {cos, sin}};
}

Placement after(const Placement& from, const Segment& segment) noexcept {
  const Point position = from.position;
  const Point heading = from.heading;
  const auto moved = [&](double x, double y, double sin, double cos) -> Placement {
    return {
        {position.x + x * heading.x - y * heading.y, position.y + x * heading.y + y * heading.x},
        {cos * heading.x - sin * heading.y, cos * heading.y + sin * heading.x}};
  };
  if (segment.curvature_rate != 0) {
    const auto [x, y, turn] = path::along_clothoid(segment);
    const auto [sin, cos] = base::sin_cos(turn);
    return moved(x, y, sin, cos);
  }
  // The chord of an arc that turns by 2 a is length * sin(a) / a long and lies at the angle a.
  const double half = segment.curvature * segment.length / 2;
  const auto [sin, cos] = base::sin_cos(half);
  const double chord = segment.length * (std::abs(half) < 1e-4 ? 1 - half * half / 6 : sin / half);
  return moved(chord * cos, chord * sin, 2 * sin * cos, 1 - 2 * sin * sin);
}

namespace {

/// Lower bound on the squared distance of a rectangle from the hull of five points, in the
/// vehicle's frame [m^2].
double squared_gap(const Rectangle& body, const std::array<Point, 5>& points) {
  double left = points[0].x, right = left, low = points[0].y, high = low;
  for (std::size_t i = 1; i < points.size(); ++i) {
    left = std::min(left, points[i].x);
    right = std::max(right, points[i].x);
    low = std::min(low, points[i].y);
    high = std::max(high, points[i].y);
  }
  const double along = std::max({left - body.front, -body.back - right, 0.0});
  const double aside = std::max({low - body.half_width, -body.half_width - high, 0.0});
  return along * along + aside * aside;
}

}  // namespace

double squared_distance(const Shape& body, const Placement& placement, const Sides& sides,
                        double below) noexcept {
  const Rectangle box{body.box.rear, body.box.front, body.box.half_width};
  const auto& [position, heading] = placement;
  std::array<Point, 5> corners;  // Corners in the vehicle's frame.
  for (std::size_t i = 0; i < 5; ++i) {
    const Point to{sides.x[i] - position.x, sides.y[i] - position.y};
    corners[i] = {dot(to, heading), cross(heading, to)};
  }
  if (squared_gap(box, corners) >= below) return infinity;  // Most sides end here.
  double least = infinity;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point& a = corners[i];
    const Point& b = corners[i + 1];
    least = std::min(least, body.corners.empty() ? squared_distance(box, a, b)
                                                 : geometry::squared_distance(body.corners, a, b));
  }
  return least;
}

PlacedSegment::PlacedSegment(const Placement& start, const Segment& segment) noexcept
    : from(start) {
  const Point& heading = from.heading;
  const double gear = segment.length < 0 ? -1 : 1;
  const double side = segment.curvature < 0 ? -1 : 1;
  forward = {gear * heading.x, gear * heading.y};
  left = {-side * heading.y, side * heading.x};
  length = std::abs(segment.length);
  curvature = std::abs(segment.curvature);
  turn = length * curvature;
  const Turned whole = turned(length, curvature);
  sin = whole.sin;
  cos = whole.cos;
  end = whole.end;
  to = placed(whole.sin, whole.cos, whole.end);
}

Placement PlacedSegment::at(double driven) const noexcept {
  if (curvature == 0) return placed(0, 1, {driven, 0});
  const Turned part = turned(driven, curvature);
  return placed(part.sin, part.cos, part.end);
}

PlacedSegment PlacedSegment::part(double begin, double last) const noexcept {
  const double gear = dot(forward, from.heading) < 0 ? -1 : 1;
  const double side = cross(from.heading, left) < 0 ? -1 : 1;
  return {at(begin), Segment{side * curvature, gear * (last - begin)}};
}

Placement PlacedSegment::placed(double sin_of_turn, double cos_of_turn,
                                const Point& place) const noexcept {
  const double gear = dot(forward, from.heading) < 0 ? -1 : 1;
  return {{from.position.x + place.x * forward.x + place.y * left.x,
           from.position.y + place.x * forward.y + place.y * left.y},
          {gear * (cos_of_turn * forward.x + sin_of_turn * left.x),
           gear * (cos_of_turn * forward.y + sin_of_turn * left.y)}};
}

// [1] of docs/algorithms/collision.md.
Bounds PlacedSegment::axle_box() const noexcept {
  const Point& a = from.position;
  const Point& b = to.position;
  Bounds box{std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)};
  if (!(turn > 0)) return box;
  // An arc below half a turn passes its circle's greatest x exactly if x first grows, then falls.
  // An arc below a whole turn passes it unless the remaining arc does.
  const Point last{cos * forward.x + sin * left.x, cos * forward.y + sin * left.y};
  const auto passes = [&](double before, double after) {
    return turn >= 2 * pi || (turn < pi ? before > 0 && after < 0 : !(after > 0 && before < 0));
  };
  const double radius = 1 / curvature;
  if (passes(forward.x, last.x)) box.x_max = a.x + radius * one_plus(left.x, left.y);
  if (passes(-forward.x, -last.x)) box.x_min = a.x - radius * one_plus(-left.x, left.y);
  if (passes(forward.y, last.y)) box.y_max = a.y + radius * one_plus(left.y, left.x);
  if (passes(-forward.y, -last.y)) box.y_min = a.y - radius * one_plus(-left.y, left.x);
  return box;
}

Sweep::Sweep(const Footprint& footprint, const PlacedSegment& placed, double margin) noexcept
    : segment_(placed), margin_(margin) {
  const bool in_reverse = dot(placed.forward, placed.from.heading) < 0;
  const double back = in_reverse ? footprint.front : footprint.rear;
  const double front = in_reverse ? footprint.rear : footprint.front;
  const Rectangle body{back, front, footprint.half_width};
  first_ = body.grown(end_margin);
  moving_ = body.grown(arc_margin);
  const double reach = std::max(front, back) + footprint.half_width;
  turns_ = placed.turn * (placed.length / 2 + reach) > straight_enough;
  if (turns_) {
    build_arcs();
  } else {
    first_.front += placed.length;
  }
}

void Sweep::build_arcs() noexcept {
  const double curvature = segment_.curvature;
  const bool centre_outside = curvature * first_.half_width < 1;
  const auto add_arc = [&](double x, double y) {
    arcs_[static_cast<std::size_t>(arc_count_++)] = {{x, y}, level({x, y})};
  };
  add_arc(moving_.front, -moving_.half_width);
  add_arc(-moving_.back, -moving_.half_width);
  if (centre_outside) {
    add_arc(0, moving_.half_width);
  } else {
    add_arc(moving_.front, moving_.half_width);
    add_arc(-moving_.back, moving_.half_width);
  }
  const auto [back, front, half_width] = first_.grown(margin_);
  const bool turns_outside = curvature * half_width < 1;
  most_level_ = level({std::max(front, back), -half_width});
  least_level_ = turns_outside ? level({0, half_width}) : -1 / (2 * curvature);
  least_x_ = -infinity;
  most_x_ = infinity;
  if (segment_.turn > pi || !turns_outside) return;
  const auto& [sin, cos, end] = std::tie(segment_.sin, segment_.cos, segment_.end);
  const double ahead = std::max(front * cos, -back * cos) + half_width * std::abs(sin);
  const double behind = std::min(front * cos, -back * cos) - half_width * std::abs(sin);
  least_x_ = std::min(-back, end.x + behind);
  most_x_ = std::max(front, from_end({0, 0}).x + ahead);
}

Bounds Sweep::box() const noexcept {
  const Rectangle r = first_.grown(margin_);
  const double middle = (r.front - r.back) / 2;
  const double half_length = (r.front + r.back) / 2;
  const auto box_at = [&](const Point& position, const Point& forward) {
    const double x = position.x + middle * forward.x;
    const double y = position.y + middle * forward.y;
    const double dx = half_length * std::abs(forward.x) + r.half_width * std::abs(forward.y);
    const double dy = half_length * std::abs(forward.y) + r.half_width * std::abs(forward.x);
    return Bounds{x - dx, x + dx, y - dy, y + dy};
  };
  const PlacedSegment& s = segment_;
  const Bounds first = box_at(s.from.position, s.forward);
  if (!turns_) return first;
  const double radius = 1 / s.curvature;
  const double reach = std::max(r.front, r.back) + r.half_width;
  const Point centre{s.from.position.x + radius * s.left.x, s.from.position.y + radius * s.left.y};
  const double outer = radius + reach;
  const Bounds disc{centre.x - outer, centre.x + outer, centre.y - outer, centre.y + outer};
  if (s.turn >= pi) return disc;
  const Bounds last = box_at(s.to.position, {s.cos * s.forward.x + s.sin * s.left.x,
                                             s.cos * s.forward.y + s.sin * s.left.y});
  // Between its ends a point leaves its chord by at most radius * (1 - cos(turn / 2)).
  const double bulge = s.turn * (s.length + s.turn * reach) / 8;
  return {std::max(disc.x_min, std::min(first.x_min, last.x_min) - bulge),
          std::min(disc.x_max, std::max(first.x_max, last.x_max) + bulge),
          std::max(disc.y_min, std::min(first.y_min, last.y_min) - bulge),
          std::min(disc.y_max, std::max(first.y_max, last.y_max) + bulge)};
}

bool Sweep::touches(const Sides& sides) const noexcept {
  std::array<double, 5> x;
  std::array<double, 5> y;
  const PlacedSegment& s = segment_;
  for (std::size_t i = 0; i < 5; ++i) {
    const double dx = sides.x[i] - s.from.position.x;
    const double dy = sides.y[i] - s.from.position.y;
    x[i] = dx * s.forward.x + dy * s.forward.y;
    y[i] = dx * s.left.x + dy * s.left.y;
  }
  if (turns_) {
    double furthest = 0.0;
    for (std::size_t i = 0; i < 5; ++i) {
      furthest = std::max({furthest, std::abs(x[i]), std::abs(y[i])});
    }
    if (furthest <= far_away) return touches_turning(x, y);  // [3] [5]
    for (std::size_t i = 0; i < 4; ++i) {
      if (touches_far_side({x[i], y[i]}, {x[i + 1], y[i + 1]})) return true;
    }
    return false;
  }
  const Rectangle wide = first_.grown(margin_);
  bool touched = false;
  for (std::size_t i = 0; i < 4; ++i) {  // [4]
    touched |= wide.meets({x[i], y[i]}, {x[i + 1], y[i + 1]});
  }
  if (!touched || margin_ == 0) return touched;
  for (std::size_t i = 0; i < 4; ++i) {  // [6]
    if (is_near_first({x[i], y[i]}, {x[i + 1], y[i + 1]})) return true;
  }
  return false;
}

bool Sweep::is_near_first(const Point& a, const Point& b) const noexcept {
  return squared_distance(first_, a, b) <= margin_ * margin_;
}

/// Signed distance outwards from the circle of the rear axle, to first order. Exactly it is (r^2 -
/// R^2) / 2R at distance r from the turning centre, so it is constant along each arc.
double Sweep::level(const Point& p) const noexcept {
  return segment_.curvature / 2 * dot(p, p) - p.y;
}

Point Sweep::from_end(const Point& p) const noexcept {
  const double dx = p.x - segment_.end.x;
  const double dy = p.y - segment_.end.y;
  return {dx * segment_.cos + dy * segment_.sin, dy * segment_.cos - dx * segment_.sin};
}

/// Whether the first of two points on a circle around the turning centre reaches the second one on
/// the way.
bool Sweep::is_reached(const Point& from, const Point& to) const noexcept {
  if (segment_.turn >= 2 * pi) return true;
  // Sine and cosine of the angle between the points, both times r^2 / R.
  const double curvature = segment_.curvature;
  const double sin = to.x - from.x + curvature * cross(from, to);
  const double cos = 1 / curvature + curvature * dot(from, to) - from.y - to.y;
  const bool after_start = sin > 0;
  const bool before_end = segment_.sin * cos - segment_.cos * sin > 0;
  return segment_.turn < pi ? after_start && before_end : after_start || before_end;
}

bool Sweep::crosses_arc(const Point& a, const Point& b) const noexcept {
  // Along a + t * (b - a) the level is level(a) + linear * t + square * t^2.
  const Point d{b.x - a.x, b.y - a.y};
  const double linear = segment_.curvature * dot(a, d) - d.y;
  const double square = segment_.curvature / 2 * dot(d, d);
  const double level_a = level(a);
  for (int i = 0; i < arc_count_; ++i) {
    const Arc& arc = arcs_[static_cast<std::size_t>(i)];
    const double constant = level_a - arc.level;
    const double discriminant = linear * linear - 4 * square * constant;
    if (!(discriminant >= 0)) continue;
    const double h = -(linear + std::copysign(std::sqrt(discriminant), linear)) / 2;
    for (const double t : {h / square, constant / h}) {
      if (!(t >= 0 && t <= 1)) continue;
      if (is_reached(arc.start, {a.x + t * d.x, a.y + t * d.y})) return true;
    }
  }
  return false;
}

/// [6] Whether a side that crosses no arc comes within the margin of its inner part. It does if an
/// end of the side does, or its point nearest to the turning centre, from outside.
bool Sweep::passes_arc(const Point& a, const Point& b) const noexcept {
  const double curvature = segment_.curvature;
  const Point d{b.x - a.x, b.y - a.y};
  const double part = (d.y - curvature * dot(a, d)) / (curvature * dot(d, d));
  const Point nearest{a.x + part * d.x, a.y + part * d.y};
  for (int i = 0; i < arc_count_; ++i) {
    const auto& [start, at] = arcs_[static_cast<std::size_t>(i)];
    // Radius as a multiple of the rear axle's, and levels of the circles at the margin beside the
    // arc.
    const double radius = std::sqrt(std::max(0.0, 1 + 2 * curvature * at));
    const double bulge = curvature * margin_ * margin_ / 2;
    const double outer = at + radius * margin_ + bulge;
    const double inner = radius > curvature * margin_ ? at - radius * margin_ + bulge : -infinity;
    for (const Point& p : {a, b}) {
      const double level_of_p = level(p);
      if (level_of_p >= inner && level_of_p <= outer && is_reached(start, p)) return true;
    }
    if (part > 0 && part < 1 && level(nearest) >= at && level(nearest) <= outer &&
        is_reached(start, nearest)) {
      return true;
    }
  }
  return false;
}

/// Whether a point is in the swept area without the rectangles at its ends, because a side of the
/// footprint hits it on the way. A side hits only points at the levels that it has itself.
bool Sweep::covers(const Point& p) const noexcept {
  const auto& [back, front, half_width] = moving_;
  const double curvature = segment_.curvature;
  const double at = level(p);
  const double most = level({front, -half_width});
  const bool centre_outside = curvature * half_width < 1;
  // The front, below the turning centre. It has y from the level.
  const double inner_front =
      centre_outside ? level({front, half_width}) : level({front, 1 / curvature});
  if (at >= inner_front - slack && at <= most + slack) {
    const double c = curvature / 2 * front * front - at;
    const double y = 2 * c / (1 + std::sqrt(std::max(0.0, 1 - 2 * curvature * c)));
    if (is_reached({front, std::clamp(y, -half_width, half_width)}, p)) return true;
  }
  // The left side, ahead of the rear axle.
  const double left = level({0, half_width});
  if (at >= left - slack && at <= level({front, half_width}) + slack) {
    const double x = std::sqrt(std::max(0.0, 2 * (at - left) / curvature));
    if (is_reached({std::min(x, front), half_width}, p)) return true;
  }
  // The right side, behind the rear axle: the tail swings out.
  const double right = level({0, -half_width});
  if (at >= right - slack && at <= level({-back, -half_width}) + slack) {
    const double x = std::sqrt(std::max(0.0, 2 * (at - right) / curvature));
    if (is_reached({-std::min(x, back), -half_width}, p)) return true;
  }
  // The back, above the turning centre.
  if (centre_outside) return false;
  if (at < level({-back, 1 / curvature}) - slack || at > level({-back, half_width}) + slack) {
    return false;
  }
  const double c = curvature / 2 * back * back - at;
  const double y = (1 + std::sqrt(std::max(0.0, 1 - 2 * curvature * c))) / curvature;
  return is_reached({-back, std::min(y, half_width)}, p);
}

bool Sweep::touches_side(const Point& a, const Point& b) const noexcept {
  if (margin_ == 0) {
    return first_.meets(a, b) || first_.meets(from_end(a), from_end(b)) || covers(a) ||
           crosses_arc(a, b);
  }
  return is_near_first(a, b) || is_near_first(from_end(a), from_end(b)) || covers(a) ||
         crosses_arc(a, b) || passes_arc(a, b);
}

/// Tests a side that reaches far away. Levels grow with the squared distance, so the side is cut to
/// a square around the area.
bool Sweep::touches_far_side(const Point& a, const Point& b) const noexcept {
  const double reach = std::max({first_.front, first_.back}) + first_.half_width;
  const double most = std::min(segment_.length, 2 / segment_.curvature) + reach + margin_ + 1.0;
  double begin = 0.0;
  double end = 1.0;
  const auto cut = [&](double from, double step) {
    const double low = (-most - from) / step;
    const double high = (most - from) / step;
    begin = std::max(begin, std::min(low, high));
    end = std::min(end, std::max(low, high));
    return step != 0 || std::abs(from) <= most;
  };
  const Point d{b.x - a.x, b.y - a.y};
  if (!cut(a.x, d.x) || !cut(a.y, d.y) || begin > end) return false;
  const Point first{a.x + begin * d.x, a.y + begin * d.y};
  const Point last{a.x + end * d.x, a.y + end * d.y};
  return touches_side(begin > 0 ? first : a, end < 1 ? last : b);
}

bool Sweep::touches_turning(const std::array<double, 5>& x,
                            const std::array<double, 5>& y) const noexcept {
  const PlacedSegment& s = segment_;
  std::array<double, 5> levels;
  std::array<double, 5> ahead;
  for (std::size_t i = 0; i < 5; ++i) {
    levels[i] = s.curvature / 2 * (x[i] * x[i] + y[i] * y[i]) - y[i];
    ahead[i] = (x[i] - s.end.x) * s.cos + (y[i] - s.end.y) * s.sin;
  }
  // Most sides are separated from the area by level, or lie behind its start or beyond its end.
  std::array<bool, 4> apart;
  for (std::size_t i = 0; i < 4; ++i) {
    const double dx = x[i + 1] - x[i];
    const double dy = y[i + 1] - y[i];
    const double square = s.curvature * (dx * dx + dy * dy);
    const double linear = s.curvature * (x[i] * dx + y[i] * dy) - dy;
    const bool dips = (linear < 0) & (-linear < square) &
                      (2 * square * (levels[i] - most_level_) <= linear * linear);
    const bool outside = (std::min(levels[i], levels[i + 1]) > most_level_) & !dips;
    apart[i] = outside | (std::max(levels[i], levels[i + 1]) < least_level_) |
               (std::max(x[i], x[i + 1]) < least_x_) | (std::min(ahead[i], ahead[i + 1]) > most_x_);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (!apart[i] && touches_side({x[i], y[i]}, {x[i + 1], y[i + 1]})) return true;
  }
  return false;
}

}  // namespace vandplan::collision
