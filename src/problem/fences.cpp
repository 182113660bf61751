// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/fences.h"

#include <cmath>
#include <string>
#include <utility>

#include "geometry/convex.h"
#include "geometry/orientation.h"
#include "problem/checks.h"
#include "vandplan/input_error.h"

namespace vandplan::problem {
namespace {

// A body may touch the side of its area, so a fence begins a little outside of it [m].
constexpr double fence_begin = 2e-7;
constexpr double fence_end = 1e-6;

const Point& corner(const Polygon& polygon, std::size_t i) { return polygon[i % polygon.size()]; }

/// Whether two closed sides have a point in common.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  using geometry::orientation;
  const Bounds one = bounding_box(std::initializer_list<Point>{a, b});
  const Bounds other = bounding_box(std::initializer_list<Point>{c, d});
  if (one.x_max < other.x_min || other.x_max < one.x_min || one.y_max < other.y_min ||
      other.y_max < one.y_min) {
    return false;
  }
  return orientation(a, b, c) * orientation(a, b, d) <= 0 &&
         orientation(c, d, a) * orientation(c, d, b) <= 0;
}

bool holds(const Polygon& area, const Point& p) {
  bool is_inside = false;
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Point& a = area[i];
    const Point& b = corner(area, i + 1);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const bool goes_up = b.y > a.y;
    const int side = geometry::orientation(a, b, p);
    if (side != 0 && (side > 0) == goes_up) is_inside = !is_inside;
  }
  return is_inside;
}

bool have_common_points(const Polygon& one, const Polygon& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < other.size(); ++k) {
      if (meet(one[i], corner(one, i + 1), other[k], corner(other, k + 1))) return true;
    }
  }
  return holds(one, other.front()) || holds(other, one.front());
}

}  // namespace

std::vector<Polygon> local_areas(const std::vector<Polygon>& areas, const Point& origin) {
  std::vector<Polygon> local = local_polygons(areas, origin, "inside");
  for (Polygon& area : local) area = geometry::counter_clockwise(std::move(area));
  for (std::size_t i = 0; i < local.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!have_common_points(local[i], local[k])) continue;
      throw InputError(
          "inside[" + std::to_string(i) + "]",
          "touches inside[" + std::to_string(k) + "], expected areas that have nothing in common");
    }
  }
  return local;
}

std::vector<Polygon> fences_around(std::span<const Polygon> areas) {
  std::vector<Polygon> fences;
  for (const Polygon& area : areas) {
    for (std::size_t i = 0; i < area.size(); ++i) {
      const Point& a = area[i];
      const Point& b = corner(area, i + 1);
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const Point out{(b.y - a.y) / length, (a.x - b.x) / length};
      const auto beside = [&](const Point& p, double metres) {
        return Point{p.x + metres * out.x, p.y + metres * out.y};
      };
      fences.push_back({beside(a, fence_begin), beside(b, fence_begin), beside(b, fence_end),
                        beside(a, fence_end)});
    }
  }
  return fences;
}

std::size_t area_of_fence(std::span<const Polygon> areas, std::size_t fence) {
  std::size_t area = 0;
  while (fence >= areas[area].size()) fence -= areas[area++].size();
  return area;
}

}  // namespace vandplan::problem
