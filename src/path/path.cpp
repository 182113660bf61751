// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/path.h"

#include <algorithm>
#include <cmath>

#include "base/trigonometry.h"

namespace vandplan {

Piece reversed(const Piece& piece) noexcept {
  Piece result = piece;
  std::reverse(result.segments.begin(), result.segments.begin() + result.count);
  for (Segment& segment : result.segments) segment.length = -segment.length;
  return result;
}

Pose advance(const Pose& pose, const Segment& segment) noexcept {
  // The chord of an arc of angle a and length s is s * sin(a/2) / (a/2), under heading + a/2.
  const double half = segment.curvature * segment.length / 2;
  const double ratio = std::abs(half) < 1e-4 ? 1 - half * half / 6 : base::sin_cos(half).sin / half;
  const double chord = segment.length * ratio;
  const auto [sin, cos] = base::sin_cos(pose.heading + half);
  return {pose.x + chord * cos, pose.y + chord * sin, wrap_angle(pose.heading + 2 * half)};
}

double length(std::span<const Segment> segments) noexcept {
  double sum = 0.0;
  for (const Segment& segment : segments) sum += std::abs(segment.length);
  return sum;
}

int gear_changes(std::span<const Segment> segments) noexcept {
  int changes = 0;
  double last = 0.0;
  for (const Segment& segment : segments) {
    if (segment.length == 0.0) continue;
    if (last * segment.length < 0.0) ++changes;
    last = segment.length > 0 ? 1.0 : -1.0;
  }
  return changes;
}

Pose end_pose(const Path& path) noexcept {
  Pose pose = path.start;
  for (const Segment& segment : path.segments) pose = advance(pose, segment);
  return pose;
}

Pose pose_at(const Path& path, double s) noexcept {
  Pose pose = path.start;
  double left = std::max(s, 0.0);
  for (const Segment& segment : path.segments) {
    const double part = std::min(left, std::abs(segment.length));
    pose = advance(pose, {segment.curvature, std::copysign(part, segment.length)});
    left -= part;
    if (left <= 0.0) break;
  }
  return pose;
}

std::vector<PathPoint> sampled(const Path& path, double step) {
  std::vector<PathPoint> points;
  Pose pose = path.start;
  double s = 0.0;
  for (const Segment& segment : path.segments) {
    const double size = std::abs(segment.length);
    const int direction = segment.length < 0.0 ? -1 : 1;
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(size / step)));
    for (std::size_t i = 0; i < steps; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(steps);
      points.push_back({s + size * part, advance(pose, {segment.curvature, segment.length * part}),
                        segment.curvature, direction});
    }
    pose = advance(pose, segment);
    s += size;
  }
  if (path.segments.empty()) return {{0.0, path.start, 0.0, 1}};
  points.push_back({s, pose, points.back().curvature, points.back().direction});
  return points;
}

std::vector<Segment> merged(std::span<const Segment> segments) {
  std::vector<Segment> result;
  for (const Segment& segment : segments) {
    if (segment.length == 0.0) continue;
    if (!result.empty() && result.back().curvature == segment.curvature &&
        (result.back().length > 0.0) == (segment.length > 0.0)) {
      result.back().length += segment.length;
    } else {
      result.push_back(segment);
    }
  }
  return result;
}

}  // namespace vandplan
