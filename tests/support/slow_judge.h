// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How near does the footprint come to obstacles along a path? The most obvious answer: its distance
// from every one of them, again and again, whenever it may have moved by a little.
//
// Right because it leaves out nothing: no look depends on what was seen before. What lies between
// two looks is at most half of `moved` nearer.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/collision_oracle.h"
#include "vandplan/path.h"

namespace vandplan {

/// One of the poses that are looked at, and the gap there.
struct SlowLook {
  double s = 0.0;  ///< driven from the start [m]
  double distance = 0.0;
};

/// Poses of the path from end to end between which no point of the footprint moves further than
/// `moved` [m].
inline std::vector<PathPoint> poses_everywhere(const Footprint& body, const Path& path,
                                               double moved) {
  std::vector<PathPoint> points = {{.s = 0, .pose = path.start}};
  Pose from = path.start;
  double before = 0.0;
  for (const Segment& segment : path.segments) {
    const double way = std::abs(segment.length) * top_speed(body, segment);
    const int count = 1 + static_cast<int>(way / moved);
    for (int i = 1; i <= count; ++i) {
      const double s = std::abs(segment.length) * i / count;
      points.push_back({.s = before + s, .pose = advance(from, part_of(segment, 0, s))});
    }
    from = advance(from, segment);
    before += std::abs(segment.length);
  }
  return points;
}

inline std::vector<SlowLook> look_everywhere(const Footprint& body,
                                             const std::vector<Polygon>& obstacles,
                                             const Path& path, double moved) {
  std::vector<SlowLook> looks;
  for (const PathPoint& point : poses_everywhere(body, path, moved)) {
    looks.push_back({point.s, gap_at(body, obstacles, point.pose).distance});
  }
  return looks;
}

inline double least_of(const std::vector<SlowLook>& looks) {
  double least = std::numeric_limits<double>::infinity();
  for (const SlowLook& look : looks) least = std::min(least, look.distance);
  return least;
}

}  // namespace vandplan
