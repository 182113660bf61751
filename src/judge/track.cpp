// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/track.h"

#include <cmath>

namespace vandplan::judge {

// On a circle the chord to the place an angle 2a further has length 2 sin(a) / curvature and
// points along heading + a.
Position after(const Stretch& stretch, Real t) {
  const Real way = stretch.direction * t;
  const Real a = stretch.curvature * way / 2;
  const Real chord = a == 0 ? way : way * (std::sin(a) / a);
  const auto& [x, y, heading] = stretch.start;
  return {x + chord * std::cos(heading + a), y + chord * std::sin(heading + a), heading + 2 * a};
}

Track integrate(const Path& path) {
  Track track;
  track.end = {path.start.x, path.start.y, path.start.heading};
  for (const Segment& segment : path.segments) {
    if (segment.length == 0) continue;
    const Real direction = segment.length > 0 ? 1 : -1;
    if (!track.stretches.empty() && track.stretches.back().direction != direction) {
      ++track.gear_changes;
    }
    const Real length = std::abs(static_cast<Real>(segment.length));
    track.stretches.push_back({track.end, segment.curvature, direction, length, track.length});
    track.end = after(track.stretches.back(), length);
    track.length += length;
    if (direction < 0) track.reverse_length += length;
  }
  if (track.stretches.empty()) track.stretches.push_back({track.end, 0, 1, 0, 0});
  return track;
}

PathPoint point_at(const Track& track, const Place& place) {
  const Stretch& stretch = track.stretches[place.stretch];
  const Position position = after(stretch, place.t);
  return {.s = static_cast<double>(stretch.s + place.t),
          .pose = {static_cast<double>(position.x), static_cast<double>(position.y),
                   static_cast<double>(std::remainder(position.heading, full_turn))},
          .curvature = static_cast<double>(stretch.curvature),
          .direction = stretch.direction > 0 ? 1 : -1};
}

}  // namespace vandplan::judge
