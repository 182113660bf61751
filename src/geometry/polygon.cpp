// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/decimal.h"
#include "base/text.h"
#include "geometry/convex.h"
#include "geometry/orientation.h"

namespace vandplan::geometry {
namespace {

constexpr double speck = 1e-6;  // half the width of the triangle that a point becomes [m]

/// Order of points along the sweep: from left to right, on a vertical line upwards.
bool comes_before(const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

struct Side {
  Point from;
  Point to;
  std::size_t index;  // index of the corner at which the side begins

  [[nodiscard]] const Point& first() const { return comes_before(from, to) ? from : to; }
  [[nodiscard]] const Point& last() const { return comes_before(from, to) ? to : from; }
};

/// Whether the second of two sides that follow each other runs back along the first.
bool folds_back(const Side& first, const Side& second) {
  return orientation(first.from, first.to, second.to) == 0 &&
         comes_before(first.from, first.to) != comes_before(second.from, second.to);
}

bool clash(const Side& a, const Side& b, std::size_t count) {
  if ((a.index + 1) % count == b.index) return folds_back(a, b);
  if ((b.index + 1) % count == a.index) return folds_back(b, a);
  return meet(a.from, a.to, b.from, b.to);
}

/// 1 if `side` lies above `other`, -1 if below, 0 on its line. `other` does not begin after `side`.
int position(const Side& side, const Side& other) {
  const int begin = orientation(other.first(), other.last(), side.first());
  return begin != 0 ? begin : orientation(other.first(), other.last(), side.last());
}

/// The order in which the sweep crosses sides: from below to above. It is an order as long as no
/// two sides clash.
struct IsBelow {
  bool operator()(const Side* a, const Side* b) const {
    const bool b_is_older = comes_before(b->first(), a->first());
    const int above = b_is_older ? -position(*a, *b) : position(*b, *a);
    return above != 0 ? above > 0 : a->index < b->index;
  }
};

using Clash = std::optional<std::pair<Side, Side>>;

/// Two sides that share more than a corner; nothing if there are none. M. I. Shamos and D. Hoey,
/// "Geometric intersection problems" (1976): before two sides meet, they are neighbours among the
/// sides that a vertical line crosses. So only neighbours have to be compared.
Clash find_clash(const std::vector<Side>& sides) {
  struct Event {
    Point place;
    bool is_end;
    const Side* side;
  };
  std::vector<Event> events;
  events.reserve(2 * sides.size());
  for (const Side& side : sides) {
    events.push_back({side.first(), false, &side});
    events.push_back({side.last(), true, &side});
  }
  // At one point sides begin before others end, because these sides touch.
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
    if (a.place != b.place) return comes_before(a.place, b.place);
    return a.is_end != b.is_end ? b.is_end : a.side->index < b.side->index;
  });
  std::set<const Side*, IsBelow> crossed;
  std::vector<std::set<const Side*, IsBelow>::iterator> places(sides.size());
  const auto clashing = [&](auto lower, auto upper) {
    return lower != crossed.end() && upper != crossed.end() &&
           clash(**lower, **upper, sides.size());
  };
  for (const Event& event : events) {
    auto& place = places[event.side->index];
    if (!event.is_end) place = crossed.insert(event.side).first;
    const auto above = std::next(place);
    const auto below = place == crossed.begin() ? crossed.end() : std::prev(place);
    if (!event.is_end) {
      if (clashing(below, place)) return {{**below, **place}};
      if (clashing(place, above)) return {{**place, **above}};
    } else {
      if (clashing(below, above)) return {{**below, **above}};
      crossed.erase(place);
    }
  }
  return std::nullopt;
}

std::vector<Side> sides_of(const Polygon& polygon) {
  std::vector<Side> sides;
  sides.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sides.push_back({polygon[i], polygon[(i + 1) % polygon.size()], i});
  }
  return sides;
}

/// Whether all corners lie on one line, but for rounding.
bool is_flat(const Polygon& polygon) {
  const auto squared_distance = [&](const Point& corner) {
    const double dx = corner.x - polygon[0].x;
    const double dy = corner.y - polygon[0].y;
    return dx * dx + dy * dy;
  };
  const Point furthest = *std::max_element(
      polygon.begin(), polygon.end(),
      [&](const Point& a, const Point& b) { return squared_distance(a) < squared_distance(b); });
  const double limit = 1e-15 * squared_distance(furthest);
  return std::all_of(polygon.begin(), polygon.end(), [&](const Point& corner) {
    const double area = (furthest.x - polygon[0].x) * (corner.y - polygon[0].y) -
                        (furthest.y - polygon[0].y) * (corner.x - polygon[0].x);
    return std::abs(area) <= limit;
  });
}

std::string corner_text(const Point& corner, const Point& origin) {
  return "[" + base::shortest_text(base::moved(corner.x, origin.x)) + ", " +
         base::shortest_text(base::moved(corner.y, origin.y)) + "]";
}

}  // namespace

bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (orientation(a, b, c) == 0 && orientation(a, b, d) == 0) {
    const auto [first, last] = std::minmax(a, b, comes_before);
    const auto [other_first, other_last] = std::minmax(c, d, comes_before);
    return !comes_before(last, other_first) && !comes_before(other_last, first);
  }
  return orientation(a, b, c) * orientation(a, b, d) <= 0 &&
         orientation(c, d, a) * orientation(c, d, b) <= 0;
}

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
  const Clash clash = find_clash(sides_of(polygon));
  if (!clash) return {};
  const auto& [a, b] = *clash;
  const bool in_order = a.index < b.index;
  return "crosses or touches itself where the sides that begin at " +
         corner_text((in_order ? a : b).from, origin) + " and " +
         corner_text((in_order ? b : a).from, origin) + " meet, expected a simple polygon";
}

double distance_from_border(const Polygon& polygon, const Point& point) {
  double least = std::numeric_limits<double>::infinity();
  Point a = polygon.back();
  for (const Point& b : polygon) {
    least = std::min(least, squared_distance_to_side(point, a, b));
    a = b;
  }
  return contains(polygon, point) ? -std::sqrt(least) : std::sqrt(least);
}

namespace {

/// Shortens a side to its part in the bounds. False if none of it is inside of their edge.
bool clip(const Bounds& bounds, Point& a, Point& b) {
  double begin = 0.0, end = 1.0;
  const auto cut = [&](double from, double to, double least, double most) {
    if (std::max(from, to) <= least || std::min(from, to) >= most) return false;
    const double way = to - from;
    if (way == 0.0) return true;
    const double first = (least - from) / way, last = (most - from) / way;
    begin = std::max(begin, std::min(first, last));
    end = std::min(end, std::max(first, last));
    return true;
  };
  if (!cut(a.x, b.x, bounds.x_min, bounds.x_max) || !cut(a.y, b.y, bounds.y_min, bounds.y_max)) {
    return false;
  }
  const Point from = a, to = b;
  if (begin > 0.0) a = {from.x + begin * (to.x - from.x), from.y + begin * (to.y - from.y)};
  if (end < 1.0) b = {from.x + end * (to.x - from.x), from.y + end * (to.y - from.y)};
  return begin <= end;
}

Point moved_into(const Bounds& bounds, double by, const Point& p) {
  return {std::clamp(p.x, bounds.x_min + by, bounds.x_max - by),
          std::clamp(p.y, bounds.y_min + by, bounds.y_max - by)};
}

}  // namespace

// The places are a convex set. If no border is inside of it, it is in the polygon as soon as one of
// its inner places is.
double distance_in_bounds(const Polygon& polygon, const Bounds& bounds, const Point& point) {
  constexpr double inward = 1e-4;  // distance of the inner place from the edge of the bounds [m]
  const double width = std::min(bounds.x_max - bounds.x_min, bounds.y_max - bounds.y_min);
  if (!(width > 2 * inward)) return distance_from_border(polygon, point);
  const Point place = moved_into(bounds, 0.0, point);
  if (!contains(polygon, moved_into(bounds, inward, point))) {
    return distance_from_border(polygon, point);
  }
  double least = std::numeric_limits<double>::infinity();
  Point a = polygon.back();
  for (const Point& b : polygon) {
    Point from = a, to = b;
    if (clip(bounds, from, to)) least = std::min(least, squared_distance_to_side(place, from, to));
    a = b;
  }
  const double depth = std::sqrt(least);
  return depth > 2 * inward ? -depth : distance_from_border(polygon, point);
}

}  // namespace vandplan::geometry

namespace vandplan {

bool is_convex(std::span<const Point> polygon) {
  bool left = false;
  bool right = false;
  const std::size_t count = polygon.size();
  for (std::size_t i = 0; i < count; ++i) {
    const int turn =
        geometry::orientation(polygon[i], polygon[(i + 1) % count], polygon[(i + 2) % count]);
    left = left || turn > 0;
    right = right || turn < 0;
  }
  return left != right;
}

// A ray to the right of a point inside crosses an odd number of sides.
bool contains(std::span<const Point> polygon, const Point& point) {
  bool is_inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if ((a.y > point.y) == (b.y > point.y)) continue;
    const bool goes_up = b.y > a.y;
    const int side = geometry::orientation(a, b, point);
    if (side != 0 && (side > 0) == goes_up) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace vandplan
