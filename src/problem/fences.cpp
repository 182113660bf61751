// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "problem/fences.h"

#include <cmath>
#include <string>
#include <utility>

#include "geometry/convex.h"
#include "geometry/polygon.h"
#include "problem/checks.h"
#include "vandplan/input_error.h"

namespace vandplan::problem {
namespace {

// Distance of a fence from the side of the area [m]. Not 0, because a body may touch the side.
constexpr double fence_begin = 2e-7;
constexpr double fence_end = 1e-6;  // distance of the fence's far side from the area [m]

const Point& corner(const Polygon& polygon, std::size_t i) { return polygon[i % polygon.size()]; }

bool have_common_points(const Polygon& one, const Polygon& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < other.size(); ++k) {
      if (geometry::meet(one[i], corner(one, i + 1), other[k], corner(other, k + 1))) return true;
    }
  }
  return contains(one, other.front()) || contains(other, one.front());
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

}  // namespace vandplan::problem
