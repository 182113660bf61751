// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Bridges: what is on the level of the start?
#include "io/levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "support/cases.h"
#include "vandplan/random.h"

namespace vandplan::io {
namespace {

/// A lane along the x axis over a box, which rises evenly, and how high it is where it begins.
struct Slab {
  Bounds box;
  double height = 0.0;
  double slope = 0.0;

  [[nodiscard]] double height_at(double x) const { return height + slope * (x - box.x_min); }
};

/// The slab as a lane with so many more corners on each edge, at any places.
Lane lane_of(const Slab& slab, int left, int right, Rng& rng) {
  Lane lane;
  const auto add = [&](int more, double y, std::vector<Point>& edge, std::vector<double>& heights) {
    std::vector<double> places = {slab.box.x_min, slab.box.x_max};
    for (int i = 0; i < more; ++i) places.push_back(uniform(slab.box.x_min, slab.box.x_max, rng));
    std::ranges::sort(places);
    for (const double x : places) {
      edge.push_back({x, y});
      heights.push_back(slab.height_at(x));
    }
  };
  add(left, slab.box.y_max, lane.left, lane.left_heights);
  add(right, slab.box.y_min, lane.right, lane.right_heights);
  return lane;
}

/// Whether two slabs have a place in common in the plan, or would have if their places were off by
/// `slack`.
bool cross(const Slab& a, const Slab& b, double slack = 0.0) {
  const auto overlap = [&](double low, double high, double other_low, double other_high) {
    return std::max(low, other_low) - slack <= std::min(high, other_high) + slack;
  };
  return overlap(a.box.x_min, a.box.x_max, b.box.x_min, b.box.x_max) &&
         overlap(a.box.y_min, a.box.y_max, b.box.y_min, b.box.y_max);
}

/// Whether their heights differ by less than a vehicle's at such a place.
bool meet(const Slab& a, const Slab& b, double slack = 0.0) {
  if (!cross(a, b, slack)) return false;
  const auto difference = [&](double x) { return a.height_at(x) - b.height_at(x); };
  const double first = difference(std::max(a.box.x_min, b.box.x_min) - slack);
  const double last = difference(std::min(a.box.x_max, b.box.x_max) + slack);
  const double clear = clear_height + slack;
  return std::min(first, last) < clear && std::max(first, last) > -clear;
}

/// Whether it is a matter of centimetres whether some of the slabs cross or meet.
bool is_close(const std::vector<Slab>& slabs) {
  for (const Slab& a : slabs) {
    for (const Slab& b : slabs) {
      if (meet(a, b, 0.02) != meet(a, b, -0.02)) return true;
      if (cross(a, b, 0.02) != cross(a, b, -0.02)) return true;
    }
  }
  return false;
}

/// Indices of the slabs that one reaches from a place, by the slow obvious way.
std::vector<bool> reached(const std::vector<Slab>& slabs, std::size_t first) {
  std::vector<bool> is_reached(slabs.size(), false);
  is_reached[first] = true;
  for (std::size_t round = 0; round < slabs.size(); ++round) {
    for (std::size_t i = 0; i < slabs.size(); ++i) {
      for (std::size_t k = 0; k < slabs.size(); ++k) {
        if (is_reached[i] && meet(slabs[i], slabs[k])) is_reached[k] = true;
      }
    }
  }
  return is_reached;
}

/// Which slabs stay when a vehicle starts on one of them.
std::vector<bool> staying(const std::vector<Slab>& slabs, std::size_t first) {
  const std::vector<bool> is_reached = reached(slabs, first);
  std::vector<bool> stays(slabs.size(), true);
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    for (std::size_t k = 0; k < slabs.size(); ++k) {
      if (!is_reached[i] || is_reached[k] || !cross(slabs[i], slabs[k])) continue;
      const std::vector<bool> goes = reached(slabs, k);
      for (std::size_t m = 0; m < slabs.size(); ++m) stays[m] = stays[m] && !goes[m];
    }
  }
  return stays;
}

/// The slab on which a vehicle starts: the lowest from which one reaches the goal, or the lowest.
std::optional<std::size_t> first_slab(const std::vector<Slab>& slabs, const Point& start,
                                      const Point& goal) {
  std::vector<std::pair<double, std::size_t>> starts;
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    if (contains(slabs[i].box, start)) starts.emplace_back(slabs[i].height_at(start.x), i);
  }
  if (starts.empty()) return {};
  std::ranges::sort(starts);
  for (const auto& [height, i] : starts) {
    const std::vector<bool> is_reached = reached(slabs, i);
    for (std::size_t k = 0; k < slabs.size(); ++k) {
      if (is_reached[k] && contains(slabs[k].box, goal)) return i;
    }
  }
  return starts.front().second;
}

TEST(Levels, WhatIsAboveOrBelowTheWayGoes) {
  int with_bridge = 0;
  for_each_case(5, 3000, [&](Rng& rng) {
    std::vector<Slab> slabs;
    Roads roads;
    const int count = 2 + static_cast<int>(uniform(0, 7, rng));
    for (int i = 0; i < count; ++i) {
      const double x = uniform(0, 60, rng);
      const double y = uniform(0, 40, rng);
      slabs.push_back({{x, x + uniform(5, 50, rng), y, y + uniform(3, 20, rng)},
                       uniform(-8, 8, rng),
                       uniform(-0.2, 0.2, rng)});
      roads.lanes.push_back(lane_of(slabs.back(), static_cast<int>(uniform(0, 4, rng)),
                                    static_cast<int>(uniform(0, 4, rng)), rng));
      roads.lanes.back().name = std::to_string(i);
    }
    if (is_close(slabs)) return;
    const auto any_place = [&] { return Point{uniform(0, 70, rng), uniform(0, 50, rng)}; };
    const Point start = any_place();
    const Point goal = any_place();
    const std::optional<std::size_t> first = first_slab(slabs, start, goal);
    const std::vector<bool> stays =
        first ? staying(slabs, *first) : std::vector<bool>(slabs.size(), true);
    keep_level(start, goal, roads);
    std::vector<std::string> expected;
    for (std::size_t i = 0; i < slabs.size(); ++i) {
      if (stays[i]) expected.push_back(std::to_string(i));
    }
    std::vector<std::string> kept;
    for (const Lane& lane : roads.lanes) kept.push_back(lane.name);
    ASSERT_EQ(kept, expected);
    const auto gone = static_cast<int>(slabs.size() - kept.size());
    ASSERT_EQ(gone > 0 ? roads.left_out.at("lane on another level") : 0, gone);
    with_bridge += gone > 0 ? 1 : 0;
  });
  EXPECT_GT(with_bridge, is_sanitized ? 0 : 50);
}

/// A street along the x axis and a bridge over it, 6 m above.
Roads street_and_bridge() {
  Roads roads;
  roads.lanes.push_back(
      {.name = "street", .left = {{0, 3}, {100, 3}}, .right = {{0, 0}, {100, 0}}});
  roads.lanes.push_back({.name = "bridge",
                         .left = {{40, -50}, {40, 50}},
                         .right = {{43, -50}, {43, 50}},
                         .left_heights = {6, 6},
                         .right_heights = {6, 6}});
  return roads;
}

Polygon square_at(double x, double y) { return {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}; }

TEST(Levels, AnObstacleIsInTheWayAtItsHeight) {
  const auto obstacles_from = [](const Point& start) {
    Roads roads = street_and_bridge();
    roads.obstacles = {{square_at(41, 1), "pillar", {0, 5.5}},
                       {square_at(41.5, 1), "post on the bridge", {6, 7}},
                       {square_at(41, 2), "beam", {4.4, 5.5}},
                       {square_at(42, 2), "high beam", {4.5, 5.5}},
                       {square_at(70, 20), "elsewhere", {50, 60}},
                       {square_at(41, 1), "house", {}}};
    roads.obstacles.back().heights = MapObstacle{}.heights;
    keep_level(start, start, roads);
    std::string names;
    for (const MapObstacle& obstacle : roads.obstacles) names += obstacle.place + ", ";
    return names;
  };
  EXPECT_EQ(obstacles_from({5, 1}), "pillar, beam, elsewhere, house, ");
  EXPECT_EQ(obstacles_from({41, 30}), "post on the bridge, elsewhere, house, ");
}

TEST(Levels, AreasHaveALevelToo) {
  Roads roads = street_and_bridge();
  roads.areas = {{square_at(43, 20), 6}, {square_at(10, 3), 0}};
  Roads above = roads;
  keep_level({5, 1}, {6, 1}, roads);
  ASSERT_EQ(roads.areas.size(), 1U);
  EXPECT_EQ(roads.areas[0].height, 0);
  EXPECT_EQ(roads.left_out.at("area on another level"), 1);
  keep_level({43.5, 20.5}, {41, 30}, above);
  ASSERT_EQ(above.areas.size(), 1U);
  EXPECT_EQ(above.areas[0].height, 6);
}

TEST(Levels, ABridgeThatARampLeadsToBecomesACrossing) {
  Roads roads = street_and_bridge();
  roads.lanes.push_back({.name = "ramp",
                         .left = {{100, 3}, {140, 40}, {43, 50}},
                         .right = {{100, 0}, {143, 40}, {40, 53}},
                         .left_heights = {0, 3, 6},
                         .right_heights = {0, 3, 6}});
  keep_level({5, 1}, {6, 1}, roads);
  EXPECT_EQ(roads.lanes.size(), 3U);
  EXPECT_EQ(roads.left_out, (std::map<std::string, int>{{"height where two lanes cross", 1}}));
}

}  // namespace
}  // namespace vandplan::io
