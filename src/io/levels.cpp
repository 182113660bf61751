// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "io/levels.h"

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/polygon.h"
#include "io/ground.h"
#include "io/lane_edges.h"

namespace vandplan::io {
namespace {

constexpr double gap = 0.01;  // Distance up to which two patches of ground touch [m].

/// A place and its height.
struct Place {
  Point at;
  double height = 0.0;
};

/// Ground whose height is a linear function of the place: a triangle of a lane, or an area.
struct Patch {
  std::size_t owner = 0;  // Index of the lane; areas are counted after the lanes.
  Ring ring;
  Place origin = {};
  Point slope = {};  // Change of the height per metre, along each axis.

  [[nodiscard]] double height_at(const Point& point) const {
    return origin.height + slope.x * (point.x - origin.at.x) + slope.y * (point.y - origin.at.y);
  }
};

/// Adds the triangle of three places, if it has an area.
void add_triangle(const Place& a, const Place& b, const Place& c, std::size_t owner,
                  std::vector<Patch>& patches) {
  auto ring = ring_of({a.at, b.at, c.at});
  if (!ring || ring->corners.size() < 3) return;
  const Point p = {b.at.x - a.at.x, b.at.y - a.at.y};
  const Point q = {c.at.x - a.at.x, c.at.y - a.at.y};
  const double area = p.x * q.y - p.y * q.x;
  const double up = b.height - a.height;
  const double on = c.height - a.height;
  const Point slope = {(up * q.y - on * p.y) / area, (on * p.x - up * q.x) / area};
  patches.push_back({owner, std::move(*ring), a, slope});
}

std::vector<Patch> patches_of(const Roads& roads) {
  std::vector<Patch> patches;
  for (std::size_t i = 0; i < roads.lanes.size(); ++i) {
    const Lane& lane = roads.lanes[i];
    const Edges edges(lane);
    const auto left = [&](const Cut& cut) {
      return Place{lane.left[cut.left], lane.left_heights[cut.left]};
    };
    const auto right = [&](const Cut& cut) {
      return Place{lane.right[cut.right], lane.right_heights[cut.right]};
    };
    for (Cut at; !edges.is_end(at);) {
      const Cut next = edges.after(at);
      const Place third = next.left > at.left ? left(next) : right(next);
      add_triangle(left(at), right(at), third, i, patches);
      at = next;
    }
  }
  for (std::size_t i = 0; i < roads.areas.size(); ++i) {
    const auto& [outline, height] = roads.areas[i];
    if (auto ring = ring_of(outline)) {
      patches.push_back({roads.lanes.size() + i, std::move(*ring), {{}, height}});
    }
  }
  return patches;
}

/// Adds the corners of one polygon that touch the other.
void add_corners(const Polygon& one, const Polygon& other, std::vector<Point>& points) {
  std::ranges::copy_if(one, std::back_inserter(points), [&](const Point& corner) {
    return contains(other, corner) || geometry::distance_from_border(other, corner) <= gap;
  });
}

/// Adds the place where two sides cross.
void add_crossing(const Point& a, const Point& b, const Point& c, const Point& d,
                  std::vector<Point>& points) {
  const Point p = {b.x - a.x, b.y - a.y};
  const Point q = {d.x - c.x, d.y - c.y};
  const double turn = p.x * q.y - p.y * q.x;
  if (turn == 0.0) return;
  const double share = ((c.x - a.x) * q.y - (c.y - a.y) * q.x) / turn;
  const double other = ((c.x - a.x) * p.y - (c.y - a.y) * p.x) / turn;
  if (share < 0.0 || share > 1.0 || other < 0.0 || other > 1.0) return;
  points.push_back(between(a, b, share));
}

/// Corners of what two polygons have in common; empty if they do not touch.
std::vector<Point> common_corners(const Polygon& one, const Polygon& other) {
  std::vector<Point> points;
  add_corners(one, other, points);
  add_corners(other, one, points);
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < other.size(); ++k) {
      add_crossing(one[i], one[(i + 1) % one.size()], other[k], other[(k + 1) % other.size()],
                   points);
    }
  }
  return points;
}

/// How lanes and areas lie to each other.
struct Neighbours {
  std::vector<std::set<std::size_t>> beside;                 // What each one touches.
  std::set<std::pair<std::size_t, std::size_t>> above = {};  // Pairs that cross above each other.
};

Neighbours neighbours_of(const std::vector<Patch>& patches, const Ground& ground,
                         std::size_t owners) {
  Neighbours neighbours{std::vector<std::set<std::size_t>>(owners)};
  Effort effort;
  for (const Patch& one : patches) {
    const Bounds& box = one.ring.box;
    for (const std::size_t index :
         ground.near({box.x_min - gap, box.x_max + gap, box.y_min - gap, box.y_max + gap})) {
      const Patch& other = patches[index];
      if (other.owner <= one.owner || neighbours.beside[one.owner].contains(other.owner)) continue;
      effort.spend(one.ring.corners.size() * other.ring.corners.size());
      const auto points = common_corners(one.ring.corners, other.ring.corners);
      if (points.empty()) continue;
      Interval rise{1e300, -1e300};
      for (const Point& point : points) {
        const double difference = one.height_at(point) - other.height_at(point);
        rise = {std::min(rise.least, difference), std::max(rise.most, difference)};
      }
      if (rise.least < clear_height && rise.most > -clear_height) {
        neighbours.beside[one.owner].insert(other.owner);
        neighbours.beside[other.owner].insert(one.owner);
      } else {
        neighbours.above.insert({one.owner, other.owner});
      }
    }
  }
  return neighbours;
}

/// Which lanes and areas one reaches from one of them.
std::vector<bool> reached_from(std::size_t first, const Neighbours& neighbours) {
  std::vector<bool> is_reached(neighbours.beside.size(), false);
  std::vector<std::size_t> open = {first};
  is_reached[first] = true;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const std::size_t next : neighbours.beside[at]) {
      if (is_reached[next]) continue;
      is_reached[next] = true;
      open.push_back(next);
    }
  }
  return is_reached;
}

/// Which lanes and areas stay: not those above or below the ones that are reached, nor what those
/// lead to.
std::vector<bool> without_bridges(const std::vector<bool>& is_reached,
                                  const Neighbours& neighbours) {
  std::vector<bool> stays(is_reached.size(), true);
  for (const auto& [one, other] : neighbours.above) {
    if (is_reached[one] == is_reached[other]) continue;
    const std::vector<bool> goes = reached_from(is_reached[one] ? other : one, neighbours);
    for (std::size_t i = 0; i < goes.size(); ++i) stays[i] = stays[i] && !goes[i];
  }
  return stays;
}

/// Owners of the patches that hold a point, the lowest first.
std::vector<std::size_t> owners_at(const Point& point, const std::vector<Patch>& patches) {
  std::vector<std::pair<double, std::size_t>> found;
  for (const Patch& patch : patches) {
    if (!contains(patch.ring.box, point) || !contains(patch.ring.corners, point)) continue;
    found.emplace_back(patch.height_at(point), patch.owner);
  }
  std::ranges::sort(found);
  std::vector<std::size_t> owners;
  owners.reserve(found.size());
  for (const auto& [height, owner] : found) owners.push_back(owner);
  return owners;
}

/// Whether an obstacle is at the height of ground that stays. Beside all of that it is, too.
bool is_in_the_way(const MapObstacle& obstacle, const std::vector<Patch>& patches,
                   const Ground& ground, const std::vector<bool>& stays) {
  bool is_beside_all = true;
  for (const std::size_t index : ground.near(bounding_box(obstacle.outline))) {
    const Patch& patch = patches[index];
    if (!stays[patch.owner]) continue;
    for (const Point& point : common_corners(obstacle.outline, patch.ring.corners)) {
      is_beside_all = false;
      const double height = patch.height_at(point);
      const auto& [bottom, top] = obstacle.heights;
      if (bottom < height + clear_height && top > height) return true;
    }
  }
  return is_beside_all;
}

/// Whether all heights are so alike that nothing is above anything else.
bool is_level(const Roads& roads) {
  Interval heights{1e300, -1e300};
  const auto add = [&](double height) {
    heights = {std::min(heights.least, height), std::max(heights.most, height)};
  };
  for (const Lane& lane : roads.lanes) {
    std::ranges::for_each(lane.left_heights, add);
    std::ranges::for_each(lane.right_heights, add);
  }
  for (const MapArea& area : roads.areas) add(area.height);
  return heights.most - heights.least < clear_height;
}

/// Takes away what does not stay. Returns how many.
template <typename Thing, typename Stays>
int keep(std::vector<Thing>& things, const Stays& stays) {
  std::vector<Thing> kept;
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (stays(i)) kept.push_back(std::move(things[i]));
  }
  const auto gone = static_cast<int>(things.size() - kept.size());
  things = std::move(kept);
  return gone;
}

void leave_out(const char* what, int count, Roads& roads) {
  if (count > 0) roads.left_out[what] += count;
}

}  // namespace

void keep_level(const Point& start, const Point& goal, Roads& roads) {
  for (Lane& lane : roads.lanes) {
    lane.left_heights.resize(lane.left.size(), 0.0);
    lane.right_heights.resize(lane.right.size(), 0.0);
  }
  if (is_level(roads)) return;
  const std::vector<Patch> patches = patches_of(roads);
  std::vector<Ring> rings;
  rings.reserve(patches.size());
  for (const Patch& patch : patches) rings.push_back(patch.ring);
  const Ground ground(std::move(rings));
  const std::size_t lanes = roads.lanes.size();
  const Neighbours neighbours = neighbours_of(patches, ground, lanes + roads.areas.size());
  const std::vector<std::size_t> starts = owners_at(start, patches);
  const std::vector<std::size_t> goals = owners_at(goal, patches);
  std::vector<bool> stays(lanes + roads.areas.size(), true);
  for (const std::size_t first : starts) {
    const std::vector<bool> reached = reached_from(first, neighbours);
    const bool is_reached = std::ranges::any_of(goals, [&](std::size_t at) { return reached[at]; });
    if (first == starts.front() || is_reached) stays = without_bridges(reached, neighbours);
    if (is_reached) break;
  }
  const int crossings = static_cast<int>(std::ranges::count_if(
      neighbours.above, [&](const auto& pair) { return stays[pair.first] && stays[pair.second]; }));
  leave_out("height where two lanes cross", crossings, roads);
  const int obstacles = keep(roads.obstacles, [&](std::size_t i) {
    return is_in_the_way(roads.obstacles[i], patches, ground, stays);
  });
  leave_out("obstacle on another level", obstacles, roads);
  leave_out("lane on another level", keep(roads.lanes, [&](std::size_t i) { return stays[i]; }),
            roads);
  leave_out("area on another level",
            keep(roads.areas, [&](std::size_t i) { return stays[lanes + i]; }), roads);
}

}  // namespace vandplan::io
