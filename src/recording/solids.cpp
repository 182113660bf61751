// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "recording/solids.h"

#include <algorithm>
#include <numeric>

#include "geometry/convex.h"
#include "geometry/orientation.h"
#include "geometry/polygon.h"

namespace vandplan::recording {
namespace {

constexpr double above_ground =
    0.05;  // Height of lines, so that the ground does not hide them [m].
// Most corners of a polygon that gets a lid: the time to cut it grows with their square.
constexpr std::size_t most_corners = 5000;

/// Three corners of a polygon.
struct Ear {
  std::uint32_t before, tip, after;
};

/// Whether the triangle lies in the polygon of the corners `left`, or has no area.
bool is_ear(const Polygon& polygon, const std::vector<std::uint32_t>& left, const Ear& ear) {
  const Point& a = polygon[ear.before];
  const Point& b = polygon[ear.tip];
  const Point& c = polygon[ear.after];
  const int turn = geometry::orientation(a, b, c);
  if (turn <= 0) return turn == 0;
  return std::none_of(left.begin(), left.end(), [&](std::uint32_t i) {
    if (i == ear.before || i == ear.tip || i == ear.after) return false;
    const Point& p = polygon[i];
    return geometry::orientation(a, b, p) >= 0 && geometry::orientation(b, c, p) >= 0 &&
           geometry::orientation(c, a, p) >= 0;
  });
}

/// Corners of triangles that a simple, counter-clockwise polygon is cut into: one ear after the
/// other.
std::vector<std::uint32_t> cut(const Polygon& polygon) {
  std::vector<std::uint32_t> left(polygon.size());
  std::iota(left.begin(), left.end(), 0U);
  std::vector<std::uint32_t> corners;
  std::size_t failures = 0;
  for (std::size_t i = 0; left.size() > 2 && failures < left.size();) {
    const std::size_t count = left.size();
    i %= count;
    const Ear ear{left[(i + count - 1) % count], left[i], left[(i + 1) % count]};
    if (!is_ear(polygon, left, ear)) {
      ++i;
      ++failures;
      continue;
    }
    corners.insert(corners.end(), {ear.before, ear.tip, ear.after});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    failures = 0;
  }
  return corners;
}

}  // namespace

Triangles prism_of(const Polygon& polygon, double height, const Colour& colour) {
  const Polygon corners = geometry::counter_clockwise(geometry::cleaned(polygon));
  const auto count = static_cast<std::uint32_t>(corners.size());
  Triangles prism{.points = {}, .corners = {}, .colour = colour};
  for (const double z : {0.0, height}) {
    for (const auto& [x, y] : corners) prism.points.push_back({x, y, z});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    prism.corners.insert(prism.corners.end(), {i, next, next + count, i, next + count, i + count});
  }
  if (corners.size() > most_corners) return prism;
  for (const std::uint32_t corner : cut(corners)) prism.corners.push_back(corner + count);
  return prism;
}

Line outline_of(const Polygon& polygon, const Colour& colour) {
  Line line{.join = Join::loop, .points = {}, .colour = colour};
  for (const auto& [x, y] : polygon) line.points.push_back({x, y, above_ground});
  return line;
}

}  // namespace vandplan::recording
