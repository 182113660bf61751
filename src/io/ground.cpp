// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/ground.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::io {
namespace {

constexpr double gap = 0.01;        // Width of gaps between rings that count as ground [m].
constexpr double hairline = 0.001;  // Thickness of walls; sides that are shorter are joined [m].
constexpr double depth = 0.1;       // Depth from which two rings overlap [m].

/// Corners without those that are within a hairline of the corner before.
Polygon without_short_sides(const Polygon& polygon) {
  Polygon corners;
  for (const Point& corner : polygon) {
    if (corners.empty() || distance(corners.back(), corner) >= hairline) corners.push_back(corner);
  }
  while (corners.size() > 1 && distance(corners.front(), corners.back()) < hairline) {
    corners.pop_back();
  }
  return corners;
}

/// A line beside a side of a ring.
struct Side {
  Point from;
  Point to;

  [[nodiscard]] Bounds box() const {
    const Point ends[] = {from, to};
    return bounding_box(ends);
  }
};

/// The side that begins at a corner, moved outwards [m].
Side side_of(const Ring& ring, std::size_t corner, double outwards) {
  const Point& a = ring.corners[corner];
  const Point& b = ring.corners[(corner + 1) % ring.corners.size()];
  const double share = outwards / distance(a, b);
  const Point out = {(b.y - a.y) * share, (a.x - b.x) * share};
  return {{a.x + out.x, a.y + out.y}, {b.x + out.x, b.y + out.y}};
}

/// Adds the place at which a side meets the line from `c` to `d`, as share of the side.
void add_cut(const Side& side, const Point& c, const Point& d, std::vector<double>& cuts) {
  const Point along = {side.to.x - side.from.x, side.to.y - side.from.y};
  const Point across = {d.x - c.x, d.y - c.y};
  const double turn = along.x * across.y - along.y * across.x;
  if (turn == 0.0) return;
  const Point way = {c.x - side.from.x, c.y - side.from.y};
  const double share = (way.x * across.y - way.y * across.x) / turn;
  const double other = (way.x * along.y - way.y * along.x) / turn;
  if (share > 0.0 && share < 1.0 && other >= 0.0 && other <= 1.0) cuts.push_back(share);
}

/// Parts of a side, as shares of it, that lie within at least one ring or, if `within` is false,
/// within none. Parts that are not the whole side and shorter than `least` [m] are left out.
std::vector<Interval> parts(const Side& side, std::span<const Ring* const> rings, bool within,
                            double least, Effort& effort) {
  std::vector<double> cuts = {0.0, 1.0};
  std::size_t corners = 0;
  for (const Ring* const ring : rings) {
    corners += ring->corners.size();
    for (std::size_t i = 0; i < ring->corners.size(); ++i) {
      add_cut(side, ring->corners[i], ring->corners[(i + 1) % ring->corners.size()], cuts);
    }
  }
  effort.spend(cuts.size() * (corners + 100));
  std::sort(cuts.begin(), cuts.end());
  std::vector<Interval> found;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Point middle = between(side.from, side.to, (cuts[i] + cuts[i + 1]) / 2);
    const bool is_within = std::ranges::any_of(
        rings, [&](const Ring* ring) { return contains(ring->corners, middle); });
    if (is_within != within) continue;
    if (!found.empty() && found.back().most == cuts[i]) {
      found.back().most = cuts[i + 1];
    } else {
      found.push_back({cuts[i], cuts[i + 1]});
    }
  }
  const double length = distance(side.from, side.to);
  std::erase_if(found, [&](const Interval& part) {
    const bool is_whole = part.least == 0.0 && part.most == 1.0;
    return !is_whole && (part.most - part.least) * length < least;
  });
  return found;
}

/// Whether a side lies in both rings, as a whole or for more than `depth`.
bool is_in_both(const Side& side, const Ring& one, const Ring& other, Effort& effort) {
  const Ring* const ones[] = {&one};
  const Ring* const others[] = {&other};
  const std::vector<Interval> theirs = parts(side, others, true, 0.0, effort);
  if (theirs.empty()) return false;
  const double length = distance(side.from, side.to);
  const double least = std::min(1.0, depth / length);
  for (const Interval& mine : parts(side, ones, true, 0.0, effort)) {
    for (const Interval& their : theirs) {
      const double share = std::min(mine.most, their.most) - std::max(mine.least, their.least);
      if (share >= least) return true;
    }
  }
  return false;
}

/// Whether a side of one ring, moved inwards by `depth`, is in the other. At sharp corners the
/// moved side reaches out of its own ring; only what is within counts.
bool reaches_into(const Ring& one, const Ring& other, Effort& effort) {
  for (std::size_t i = 0; i < one.corners.size(); ++i) {
    if (is_in_both(side_of(one, i, -depth), one, other, effort)) return true;
  }
  return false;
}

}  // namespace

double twice_area(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    sum +=
        (a.x - polygon[0].x) * (b.y - polygon[0].y) - (b.x - polygon[0].x) * (a.y - polygon[0].y);
  }
  return sum;
}

double distance(const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y); }

Point between(const Point& a, const Point& b, double share) {
  return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
}

Point rounded(const Point& point) {
  const auto short_number = [](double x) { return std::round(x * 1e4) / 1e4 + 0.0; };  // No -0.
  return {short_number(point.x), short_number(point.y)};
}

std::optional<Ring> ring_of(const Polygon& polygon) {
  Polygon corners = without_short_sides(polygon);
  if (corners.size() < 3 || twice_area(corners) == 0.0) return {};
  if (twice_area(corners) < 0.0) std::reverse(corners.begin(), corners.end());
  const Bounds box = bounding_box(corners);
  return Ring{std::move(corners), box};
}

std::vector<Polygon> walls_around(const Ground& ground) {
  Effort effort;
  std::vector<Polygon> walls;
  for (const Ring& ring : ground.rings()) {
    for (std::size_t i = 0; i < ring.corners.size(); ++i) {
      const Side beyond = side_of(ring, i, gap);
      std::vector<const Ring*> near;
      for (const std::size_t index : ground.near(beyond.box())) {
        const Ring& other = ground.rings()[index];
        if (&other != &ring) near.push_back(&other);
      }
      const Side inner = side_of(ring, i, 0.0);
      const Side outer = side_of(ring, i, hairline);
      for (const auto& [begin, end] : parts(beyond, near, false, gap, effort)) {
        walls.push_back({rounded(between(inner.from, inner.to, begin)),
                         rounded(between(outer.from, outer.to, begin)),
                         rounded(between(outer.from, outer.to, end)),
                         rounded(between(inner.from, inner.to, end))});
      }
    }
  }
  return walls;
}

bool overlap(const Ring& one, const Ring& other, Effort& effort) {
  return reaches_into(one, other, effort) || reaches_into(other, one, effort);
}

bool touch(const Polygon& polygon, const Ring& ring) {
  const auto is_in = [](const Polygon& area) {
    return [&area](const Point& point) { return contains(area, point); };
  };
  if (std::ranges::any_of(polygon, is_in(ring.corners))) return true;
  if (std::ranges::any_of(ring.corners, is_in(polygon))) return true;
  std::vector<double> cuts;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Side side = {polygon[i], polygon[(i + 1) % polygon.size()]};
    for (std::size_t k = 0; k < ring.corners.size(); ++k) {
      add_cut(side, ring.corners[k], ring.corners[(k + 1) % ring.corners.size()], cuts);
    }
  }
  return !cuts.empty();
}

}  // namespace vandplan::io
