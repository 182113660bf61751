// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does a body come near a side of a polygon, where it stands or on its way?

#include <algorithm>
#include <cmath>

#include "collision/bodies.h"
#include "collision/obstacles.h"
#include "collision/outline_sweep.h"
#include "collision/sweep.h"

namespace vandplan::collision {

/// Test whether a sweep touches a side while a part of its segment is driven. A long part is
/// halved, as the box around all of it contains many sides that are not near.
template <typename Touches>
struct AlongTheWay {
  const Obstacles& obstacles;
  const PlacedSegment& placed;
  const Touches& touches;
  double reach;  // Reach of the inflated footprint from its axle [m].

  [[nodiscard]] bool is_crossed(double begin, double end) const noexcept {
    const double half = (end - begin) / 2;
    const double around = half + reach;
    const Point axle = placed.at(begin + half).position;
    const Bounds box{axle.x - around, axle.x + around, axle.y - around, axle.y + around};
    if (half <= 4 * reach) {
      return obstacles.any_near(box, touches);
    }
    return obstacles.any_near(box, [](const Sides&) { return true; }) &&
           (is_crossed(begin, begin + half) || is_crossed(begin + half, end));
  }
};

/// Distance of a body from the sides of polygons, at most `most` [m], which may be infinite.
inline double distance_from(const Obstacles& obstacles, const Shape& body,
                            const Placement& placement, double most) noexcept {
  if (obstacles.is_empty()) return most;
  double least = most * most;
  const auto lower = [&](const Sides& sides) {
    least = std::min(least, squared_distance(body, placement, sides, least));
    return least == 0;
  };
  const PlacedSegment standing(placement, Segment{});
  constexpr double beyond_all = 1e12;  // [m]; the middle of an infinite box is undefined.
  (void)obstacles.any_near(Sweep(body.box, standing, std::min(most, beyond_all)).box(), lower);
  return std::sqrt(least);
}

/// Whether a side comes within a margin [m] of a footprint on its way, and `may_touch` accepts it.
template <typename MayTouch>
bool is_crossed(const Obstacles& obstacles, const Footprint& footprint, double margin,
                const PlacedSegment& placed, const MayTouch& may_touch) noexcept {
  const Sweep sweep(footprint, placed, margin);
  const auto touches = [&](const Sides& s) { return sweep.touches(s) && may_touch(s); };
  const double reach = reach_of(footprint) + margin + 1e-3;  // Adds more than the inflation.
  if (placed.length > 16 * reach && obstacles.are_many()) {
    const AlongTheWay<decltype(touches)> along{obstacles, placed, touches, reach};
    return along.is_crossed(0, placed.length);
  }
  return obstacles.any_near(sweep.box(), touches);  // [2]
}

inline bool is_crossed(const Obstacles& obstacles, const Shape& body, double margin,
                       const PlacedSegment& placed) noexcept {
  if (obstacles.is_empty()) return false;
  if (body.corners.empty()) {
    return is_crossed(obstacles, body.box, margin, placed, [](const Sides&) { return true; });
  }
  const OutlineSweep outline(body.corners, placed, margin);
  return is_crossed(obstacles, body.box, margin, placed,
                    [&](const Sides& s) { return outline.touches(s); });
}

}  // namespace vandplan::collision
