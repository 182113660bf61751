// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/decimal.h"
#include "base/text.h"

namespace vandplan::geometry {
namespace {

constexpr double speck = 1e-6;  // what a point grows to on each side [m]

struct Side {
  Point from;
  Point to;
  std::size_t index;  // of the corner it begins at
  Bounds box;
};

/// Twice the area of the triangle: positive when it turns left.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool overlap(const Bounds& a, const Bounds& b) {
  return a.x_min <= b.x_max && b.x_min <= a.x_max && a.y_min <= b.y_max && b.y_min <= a.y_max;
}

/// Whether two closed segments whose boxes overlap have a point in common.
bool meet(const Side& a, const Side& b) {
  const double from = turn(a.from, a.to, b.from);
  const double to = turn(a.from, a.to, b.to);
  if ((from > 0 && to > 0) || (from < 0 && to < 0)) return false;
  const double back_from = turn(b.from, b.to, a.from);
  const double back_to = turn(b.from, b.to, a.to);
  return !((back_from > 0 && back_to > 0) || (back_from < 0 && back_to < 0));
}

/// Whether the second of two sides that follow each other runs back along the first.
bool folds_back(const Side& first, const Side& second) {
  const double along = (first.to.x - first.from.x) * (second.to.x - second.from.x) +
                       (first.to.y - first.from.y) * (second.to.y - second.from.y);
  return along < 0 && turn(first.from, first.to, second.to) == 0;
}

bool clash(const Side& a, const Side& b, std::size_t count) {
  if ((a.index + 1) % count == b.index) return folds_back(a, b);
  if ((b.index + 1) % count == a.index) return folds_back(b, a);
  return overlap(a.box, b.box) && meet(a, b);
}

std::vector<Side> sides_from_left_to_right(const Polygon& polygon) {
  std::vector<Side> sides;
  sides.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point ends[] = {polygon[i], polygon[(i + 1) % polygon.size()]};
    sides.push_back({ends[0], ends[1], i, bounding_box(ends)});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.box.x_min != b.box.x_min ? a.box.x_min < b.box.x_min : a.index < b.index;
  });
  return sides;
}

/// Whether all corners lie on one line, but for rounding.
bool is_flat(const Polygon& polygon) {
  const auto squared_distance = [&](const Point& corner) {
    const double dx = corner.x - polygon[0].x;
    const double dy = corner.y - polygon[0].y;
    return dx * dx + dy * dy;
  };
  const Point far = *std::max_element(
      polygon.begin(), polygon.end(),
      [&](const Point& a, const Point& b) { return squared_distance(a) < squared_distance(b); });
  const double limit = 1e-15 * squared_distance(far);
  return std::all_of(polygon.begin(), polygon.end(), [&](const Point& corner) {
    return std::abs(turn(polygon[0], far, corner)) <= limit;
  });
}

std::string corner_text(const Point& corner, const Point& origin) {
  return "[" + base::shortest_text(base::moved(corner.x, origin.x)) + ", " +
         base::shortest_text(base::moved(corner.y, origin.y)) + "]";
}

}  // namespace

Polygon cleaned(const Polygon& polygon) {
  Polygon result;
  result.reserve(polygon.size());
  for (const Point& corner : polygon) {
    if (result.empty() || result.back() != corner) result.push_back(corner);
  }
  while (result.size() > 1 && result.back() == result.front()) result.pop_back();
  if (result.size() != 1) return result;
  const auto [x, y] = result.front();
  return {{x - speck, y - speck}, {x + speck, y - speck}, {x, y + speck}};
}

std::string flaw_of(const Polygon& polygon, const Point& origin) {
  if (is_flat(polygon)) return "has no area, expected corners that are not on one line";
  // Sides in the order of their left ends: only those that begin before this one ends can meet it.
  const std::vector<Side> sides = sides_from_left_to_right(polygon);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size() && sides[j].box.x_min <= sides[i].box.x_max; ++j) {
      if (!clash(sides[i], sides[j], sides.size())) continue;
      return "crosses or touches itself where the sides that begin at " +
             corner_text(sides[i].from, origin) + " and " + corner_text(sides[j].from, origin) +
             " meet, expected a simple polygon";
    }
  }
  return {};
}

}  // namespace vandplan::geometry
