// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vandplan::judge {
namespace {

/// Nearest points of a body and a side, or a point.
struct Gap {
  double distance = 0.0;
  Point on_body;
  Point on_side;
};

double length_of(const Point& a, const Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

Gap gap_between(const Point& on_body, const Point& on_side) {
  return {length_of(on_body, on_side), on_body, on_side};
}

const Gap& nearer(const Gap& a, const Gap& b) { return b.distance < a.distance ? b : a; }

Gap gap_to_point(const Point& p, const Outline& body) {
  return gap_between(
      {std::clamp(p.x, body.x_min, body.x_max), std::clamp(p.y, body.y_min, body.y_max)}, p);
}

/// Gap between a point of the body and the side from a to b.
Gap gap_to_side(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double part = squared > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared : 0.0;
  const double nearest = std::clamp(part, 0.0, 1.0);
  return gap_between(p, {a.x + nearest * dx, a.y + nearest * dy});
}

/// Distance of a point to the left of the line from a to b, times the length of a to b [m^2].
double left_of(const Point& a, const Point& b, const Point& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Whether a side of the body separates it from the side a b: the body is left of it, a and b are
/// right.
bool is_beside(const Point& a, const Point& b, const Outline& body) {
  if (std::max(a.x, b.x) < body.x_min || std::min(a.x, b.x) > body.x_max ||
      std::max(a.y, b.y) < body.y_min || std::min(a.y, b.y) > body.y_max) {
    return true;
  }
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const Point& from = body.corners[i];
    const Point& to = body.corners[(i + 1) % body.corners.size()];
    if (left_of(from, to, a) < 0 && left_of(from, to, b) < 0) return true;
  }
  return false;
}

/// Gap between the ends of the side a b and a body with corners.
Gap gap_to_corners(const Point& a, const Point& b, const Outline& body) {
  Gap gap{std::numeric_limits<double>::infinity(), {}, {}};
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const Point& from = body.corners[i];
    const Point& to = body.corners[(i + 1) % body.corners.size()];
    for (const Point& end : {a, b}) {
      const Gap turned = gap_to_side(end, from, to);
      gap = nearer(gap, {turned.distance, turned.on_side, turned.on_body});
    }
  }
  return gap;
}

/// Gap between a body and the side a b. Two disjoint convex sets are nearest at a corner of one of
/// them. They are disjoint exactly if the direction of one of their sides separates them.
Gap gap_of_side(const Point& a, const Point& b, const Outline& body) {
  bool left = true;
  bool right = true;
  for_each_corner(body, [&](const Point& corner) {
    const double side = left_of(a, b, corner);
    left = left && side > 0;
    right = right && side < 0;
  });
  if (!left && !right && !is_beside(a, b, body)) return {};
  Gap gap = body.corners.empty() ? nearer(gap_to_point(a, body), gap_to_point(b, body))
                                 : gap_to_corners(a, b, body);
  for_each_corner(body, [&](const Point& corner) { gap = nearer(gap, gap_to_side(corner, a, b)); });
  return gap;
}

/// A point of the world that moves in the vehicle's frame along a passage.
class Mover {
 public:
  Mover(const Passage& passage, const Point& p)
      : p_(p),
        half_(passage.half),
        velocity_{passage.curvature * p.y - 1, -passage.curvature * p.x},
        speed_(std::sqrt(velocity_.x * velocity_.x + velocity_.y * velocity_.y)),
        turning_(std::abs(passage.curvature) * speed_ * half_ * half_ / 2) {}

  [[nodiscard]] double approach(const Point& direction) const {
    const double along = std::abs(velocity_.x * direction.x + velocity_.y * direction.y);
    return std::min(speed_ * half_, along * half_ + turning_);
  }

  /// Lower bound of the distance of the point ahead of `from` along `direction` on the passage [m].
  [[nodiscard]] double ahead(const Point& from, const Point& direction) const {
    return (p_.x - from.x) * direction.x + (p_.y - from.y) * direction.y - approach(direction);
  }

 private:
  Point p_;
  double half_;
  Point velocity_;  // velocity per metre driven
  double speed_;
  double turning_;
};

double clearance_of_side(const Passage& passage, const Outline& body, const Point& a,
                         const Point& b) {
  const Gap gap = gap_of_side(a, b, body);
  if (gap.distance == 0 || passage.half == 0) return gap.distance;
  const auto& [distance, here, there] = gap;
  const Point to_side{(there.x - here.x) / distance, (there.y - here.y) / distance};
  // Two lines through the ends of the gap, perpendicular to it: the body stays behind one, the side
  // behind the other. The line at the body moves with the body, and the ends of the side approach
  // it.
  const Mover first(passage, a);
  const Mover last(passage, b);
  const auto both_ahead = [&](const Point& from, const Point& direction) {
    return std::min(first.ahead(from, direction), last.ahead(from, direction));
  };
  const double at_body =
      std::max({0.0, both_ahead(here, to_side), both_ahead({0, body.y_max}, {0, 1}),
                both_ahead({0, body.y_min}, {0, -1})});
  if (length_of(a, b) <= body.x_max - body.x_min) return at_body;
  // The line at the side stays with the side, and the corners of the body approach it. This bound
  // is better for long sides, whose ends move far more than the body.
  const Point to_body{-to_side.x, -to_side.y};
  double at_side = std::numeric_limits<double>::infinity();
  for_each_corner(body, [&](const Point& corner) {
    at_side = std::min(at_side, Mover(passage, corner).ahead(gap.on_side, to_body));
  });
  return std::max(at_body, at_side);
}

}  // namespace

Outline outline_with(const Polygon& corners) {
  const Bounds box = bounding_box(corners);
  double area = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    area += left_of(corners[0], corners[i - 1], corners[i]);
  }
  Outline body{box.x_min, box.x_max, box.y_min, box.y_max, corners};
  if (area < 0) std::reverse(body.corners.begin(), body.corners.end());
  return body;
}

double reach_of(const Outline& body) {
  return std::hypot(std::max(-body.x_min, body.x_max), std::max(-body.y_min, body.y_max));
}

double deviation(const Passage& passage, const Outline& body) {
  if (passage.rate == 0) return 0;
  const double square = passage.half * passage.half;
  return std::abs(passage.rate) * square * (passage.half / 6 + reach_of(body) / 2);
}

double approach(const Passage& passage, const Point& p, const Point& direction) {
  return Mover(passage, p).approach(direction);
}

View view_of(const Passage& passage) {
  return view_of(passage, direction_of(passage.middle.heading));
}

View view_of(const Passage& passage, const Direction& heading) {
  const auto& [cos, sin] = heading;
  return {.passage = passage,
          .cos = cos,
          .sin = sin,
          .axle = {static_cast<double>(passage.middle.x), static_cast<double>(passage.middle.y)},
          .axis = {static_cast<double>(cos), static_cast<double>(sin)}};
}

double clearance_of_disc(const Passage& passage, const Outline& body, const Point& centre,
                         double radius) {
  const Gap gap = gap_to_point(centre, body);
  if (gap.distance == 0 || passage.half == 0) return gap.distance - radius;
  const Mover mover(passage, centre);
  const Point direction{(centre.x - gap.on_body.x) / gap.distance,
                        (centre.y - gap.on_body.y) / gap.distance};
  const double ahead = gap.distance - mover.approach(direction);
  const double aside = std::max(centre.y - body.y_max, body.y_min - centre.y);
  return std::max(ahead, aside - mover.approach({0, 1})) - radius;
}

double clearance_of_bar(const Passage& passage, const Outline& body, const Bar& bar, double most) {
  const auto& [a, b, radius] = bar;
  const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
  const double half_length = length_of(a, b) / 2;
  const double around = clearance_of_disc(passage, body, middle, half_length + radius);
  if (around >= most || half_length == 0) return around;
  return std::max(around, clearance_of_side(passage, body, a, b) - radius);
}

double clearance_of_seen(const Passage& passage, const Outline& body,
                         std::span<const Point> polygon, double most) {
  double least = most;
  // The body holds its rear axle, the origin. If no side touches the body, the body is inside the
  // polygon exactly if a ray from the origin crosses an odd number of sides.
  bool inside = false;
  Point a = polygon.back();
  for (const Point& b : polygon) {
    least = std::min(least, clearance_of_bar(passage, body, {a, b}, least));
    if ((a.y > 0) != (b.y > 0) && a.x - a.y * (b.x - a.x) / (b.y - a.y) > 0) inside = !inside;
    a = b;
  }
  return inside ? 0.0 : least;
}

}  // namespace vandplan::judge
