// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geodesic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vandplan {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double touch = 1e-9;  // [m] a way may run along the border of a box

// Boxes are this much longer than their side at both ends, so that those of neighbouring sides
// overlap [disc radii]; their half width makes up for it.
constexpr double overhang = 0.2;

double distance(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

}  // namespace

Geodesic::Geodesic(const World& world, const Pose& from, const Pose& to) {
  const Footprint body = footprint(world.vehicle());
  const double disc = std::min({body.half_width, body.rear, body.front});
  const double half_width = disc * std::sqrt(1 - overhang * overhang);
  corners_.push_back({{from.x, from.y}, 0.0, false});
  corners_.push_back({{to.x, to.y}, infinity, false});
  for (const Polygon& polygon : world.obstacles()) {
    Point a = polygon.back();
    for (const Point& b : polygon) {
      const double length = distance(a, b);
      const Point u{(b.x - a.x) / length, (b.y - a.y) / length};
      const double half_length = length / 2 + overhang * disc;
      const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
      boxes_.push_back({middle, u, half_length, half_width});
      for (const double s : {-half_length, half_length}) {
        for (const double t : {-half_width, half_width}) {
          const Point place{middle.x + s * u.x - t * u.y, middle.y + s * u.y + t * u.x};
          corners_.push_back({place, infinity, false});
        }
      }
      a = b;
    }
  }
  settle_next();
}

double Geodesic::rank(const Corner& corner) const {
  return corner.length + distance(corner.place, corners_[1].place);
}

// The unsettled corner of least rank; every way to the goal is at least as long as its rank.
void Geodesic::settle_next() {
  std::size_t best = 0;
  double best_rank = infinity;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    if (corners_[i].is_settled || rank(corners_[i]) >= best_rank) continue;
    best = i;
    best_rank = rank(corners_[i]);
  }
  is_final_ = best == 1 || best_rank == infinity;
  if (best_rank < infinity) bound_ = std::max(bound_, best_rank);
  corners_[best].is_settled = true;
  current_ = best;
  next_ = 1;
}

bool Geodesic::step() {
  if (is_final_) return false;
  if (next_ == corners_.size()) {
    settle_next();
    return !is_final_;
  }
  const Corner& from = corners_[current_];
  Corner& to = corners_[next_++];
  if (to.is_settled) return true;
  const double length = from.length + distance(from.place, to.place);
  if (length < to.length && is_seen(from.place, to.place)) to.length = length;
  return true;
}

// No box has points of the line inside: its part within the box's strip is clipped away.
bool Geodesic::is_seen(const Point& p, const Point& q) const {
  const auto crosses = [&](const Box& box) {
    double first = 0.0;
    double last = 1.0;
    const auto clip = [&](const Point& axis, double half) {
      const double from = (p.x - box.middle.x) * axis.x + (p.y - box.middle.y) * axis.y;
      const double way = (q.x - p.x) * axis.x + (q.y - p.y) * axis.y;
      const double limit = half - touch;
      if (std::abs(way) < touch) {
        if (std::abs(from) >= limit) last = -1.0;
        return;
      }
      const double enter = (-std::copysign(limit, way) - from) / way;
      const double leave = (std::copysign(limit, way) - from) / way;
      first = std::max(first, enter);
      last = std::min(last, leave);
    };
    clip(box.along, box.half_length);
    clip({-box.along.y, box.along.x}, box.half_width);
    return first < last;
  };
  return std::none_of(boxes_.begin(), boxes_.end(), crosses);
}

}  // namespace vandplan
