// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/path.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "base/require.h"
#include "base/trigonometry.h"
#include "path/clothoid.h"
#include "path/finite.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

Pose advance_clothoid(const Pose& pose, const Segment& segment) noexcept {
  const auto [x, y, turn] = path::along_clothoid(segment);
  const auto [sin, cos] = base::sin_cos(pose.heading);
  return {pose.x + (x * cos - y * sin), pose.y + (x * sin + y * cos),
          wrap_angle(pose.heading + wrap_angle(turn))};
}

/// The start of a path rounded to whole metres. Poses are added up relative to it, because doubles
/// are coarse far from the origin.
Point beside(const Pose& start) { return {std::round(start.x), std::round(start.y)}; }

Pose moved(const Pose& pose, double dx, double dy) {
  return {pose.x + dx, pose.y + dy, pose.heading};
}

/// Whether `next` continues `segment`: equal gears and rates, and the curvature goes on. If the
/// curvature changes, it may differ by rounding.
bool goes_on(const Segment& segment, const Segment& next) {
  if ((segment.length > 0.0) != (next.length > 0.0)) return false;
  if (segment.curvature_rate != next.curvature_rate) return false;
  const double driven = std::abs(segment.length);
  const double change = std::abs(segment.curvature_rate) * driven;
  const double jump = std::abs(curvature_at(segment, driven) - next.curvature);
  constexpr double rounding = 1e-15;
  if (change == 0.0) return segment.curvature == next.curvature;
  return jump <= rounding * (std::abs(segment.curvature) + change);
}

}  // namespace

std::string_view name_of(Gear gear) noexcept {
  return gear == Gear::forward ? "forward" : "reverse";
}

Segment part_of(const Segment& segment, double begin, double end) noexcept {
  return {curvature_at(segment, begin), std::copysign(end - begin, segment.length),
          segment.curvature_rate};
}

Piece reversed(const Piece& piece) noexcept {
  Piece result = piece;
  const std::span<Segment> segments(result.segments.data(), result.count);
  std::reverse(segments.begin(), segments.end());
  for (Segment& segment : segments) {
    if (segment.curvature_rate != 0.0) {
      segment.curvature = curvature_at(segment, std::abs(segment.length));
      segment.curvature_rate = -segment.curvature_rate;
    }
    segment.length = -segment.length;
  }
  return result;
}

Pose advance(const Pose& pose, const Segment& segment) noexcept {
  if (segment.curvature_rate != 0.0) return advance_clothoid(pose, segment);
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

double length(const Path& path) noexcept { return length(path.segments); }

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

int gear_changes(const Path& path) noexcept { return gear_changes(path.segments); }

Pose end_pose(const Path& path) noexcept {
  const auto [x, y] = beside(path.start);
  Pose pose = moved(path.start, -x, -y);
  for (const Segment& segment : path.segments) pose = advance(pose, segment);
  return moved(pose, x, y);
}

Pose pose_at(const Path& path, double s) noexcept {
  const auto [x, y] = beside(path.start);
  Pose pose = moved(path.start, -x, -y);
  double left = std::max(s, 0.0);
  for (const Segment& segment : path.segments) {
    const double part = std::min(left, std::abs(segment.length));
    pose = advance(pose, part_of(segment, 0.0, part));
    left -= part;
    if (left <= 0.0) break;
  }
  return moved(pose, x, y);
}

void path::check_finite(const Path& path) {
  for (std::size_t i = 0; i < path.segments.size(); ++i) {
    const Segment& segment = path.segments[i];
    const double last = curvature_at(segment, std::abs(segment.length));
    if (std::isfinite(segment.curvature + segment.length + segment.curvature_rate + last)) continue;
    throw InputError("segments[" + std::to_string(i) + "]", "is not finite, expected numbers");
  }
}

std::vector<PathPoint> sampled(const Path& path, double step) {
  vandplan::path::check_finite(path);
  constexpr double most = 1e7;
  base::require(step > 0.0 && step >= length(path) / most, "step", step,
                "more than 0 m, and 10^7 of them on the path at most");
  if (path.segments.empty()) return {{0.0, path.start, 0.0, Gear::forward}};
  std::vector<PathPoint> points;
  const auto [x, y] = beside(path.start);
  Pose pose = moved(path.start, -x, -y);
  double s = 0.0;
  for (const Segment& segment : path.segments) {
    const double size = std::abs(segment.length);
    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(size / step)));
    for (std::size_t i = 0; i < steps; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(steps);
      const Segment driven{segment.curvature, segment.length * part, segment.curvature_rate};
      points.push_back({s + size * part, moved(advance(pose, driven), x, y),
                        curvature_at(segment, size * part), segment.gear()});
    }
    pose = advance(pose, segment);
    s += size;
  }
  const Segment& last = path.segments.back();
  points.push_back(
      {s, moved(pose, x, y), curvature_at(last, std::abs(last.length)), points.back().gear});
  return points;
}

std::vector<Segment> merged(std::span<const Segment> segments) {
  std::vector<Segment> result;
  for (const Segment& segment : segments) {
    if (segment.length == 0.0) continue;
    if (!result.empty() && goes_on(result.back(), segment)) {
      result.back().length += segment.length;
    } else {
      result.push_back(segment);
    }
  }
  return result;
}

}  // namespace vandplan
