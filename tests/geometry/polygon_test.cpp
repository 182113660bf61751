// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/orientation.h"
#include "support/cases.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

std::string flaw(const Polygon& polygon) { return geometry::flaw_of(polygon, {}); }

TEST(Polygon, ContainsWhatLiesInside) {
  const Polygon hook = {{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {0, 1}};
  const Polygon turned = {hook.rbegin(), hook.rend()};
  for (const Polygon& polygon : {hook, turned}) {
    EXPECT_TRUE(contains(polygon, {0.5, 0.5}));
    EXPECT_TRUE(contains(polygon, {3.5, 3.9}));
    EXPECT_FALSE(contains(polygon, {1, 2}));   // in its bay
    EXPECT_FALSE(contains(polygon, {-1, 1}));  // level with corners
    EXPECT_FALSE(contains(polygon, {-1, 4}));
    EXPECT_FALSE(contains(polygon, {5, 0.5}));
  }
  // A millionth of the last digit decides beside a side that leans.
  const Polygon leaning = {{0, 0}, {3, 1}, {0, 1}};
  EXPECT_TRUE(contains(leaning, {std::nextafter(1.5, 0), 0.5}));
  EXPECT_FALSE(contains(leaning, {std::nextafter(1.5, 2), 0.5}));
}

TEST(Polygon, RepeatedCornersAreDropped) {
  const Polygon square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(geometry::cleaned({{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}, {0, 0}}), square);
  EXPECT_EQ(geometry::cleaned({{0, 0}, {1, 1}, {0, 0}}), Polygon({{0, 0}, {1, 1}}));
}

TEST(Polygon, APointBecomesATriangleAroundIt) {
  const Polygon speck = geometry::cleaned({{2, 3}, {2, 3}, {2, 3}});
  EXPECT_EQ(flaw(speck), "");
  const Bounds box = bounding_box(speck);
  EXPECT_TRUE(contains(box, {2, 3}));
  EXPECT_LT(box.x_max - box.x_min, 1e-5);
  EXPECT_LT(box.y_max - box.y_min, 1e-5);
}

TEST(Polygon, SimplePolygonsHaveNoFlaw) {
  EXPECT_EQ(flaw({{0, 0}, {1, 0}, {0, 1}}), "");
  EXPECT_EQ(flaw({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), "");              // clockwise
  EXPECT_EQ(flaw({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}), "");      // concave
  EXPECT_EQ(flaw({{0, 0}, {1, 0}, {2, 0}, {2, 1}}), "");              // straight corner
  EXPECT_EQ(flaw({{0, 0}, {1000, 0}, {1000, 1e-6}, {0, 1e-6}}), "");  // sliver
  EXPECT_EQ(flaw({{0, 0}, {4, 0}, {4, 3}, {1, 3}, {1, 2}, {3, 2}, {3, 1}, {0, 1}}), "");  // hook
}

TEST(Polygon, CornersOnOneLineHaveNoArea) {
  EXPECT_EQ(flaw({{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}}),
            "has no area, expected corners that are not on one line");
  EXPECT_EQ(flaw({{0, 0}, {1, 1}}), "has no area, expected corners that are not on one line");
  EXPECT_EQ(flaw({{0, 0}, {3, 0}, {1, 0}, {2, 0}}),
            "has no area, expected corners that are not on one line");
}

TEST(Polygon, CrossingSidesAreNamedInTheFrameOfTheReader) {
  EXPECT_EQ(geometry::flaw_of({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {1000, -20}),
            "crosses or touches itself where the sides that begin at [1000, -20] and [1001, -20] "
            "meet, expected a simple polygon");
}

TEST(Polygon, TouchingAndFoldingSidesAreFlaws) {
  const std::string words = "crosses or touches itself";
  const Polygon corner_on_side = {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}};
  const Polygon corner_on_corner = {{0, 0}, {2, 1}, {4, 0}, {4, 2}, {2, 1}, {0, 2}};
  const Polygon spike = {{0, 0}, {4, 0}, {2, 0}, {2, 3}};
  const Polygon spike_at_the_seam = {{2, 0}, {2, 3}, {0, 0}, {4, 0}};
  const Polygon shared_side = {{0, 0}, {3, 0}, {3, 1}, {2, 0}, {1, 0}, {0, 1}};
  for (const Polygon& polygon :
       {corner_on_side, corner_on_corner, spike, spike_at_the_seam, shared_side}) {
    EXPECT_EQ(flaw(polygon).substr(0, words.size()), words);
  }
}

/// Corners at random distances around the origin, in order, from a random one on, either way round.
Polygon random_star(double nearest, double furthest, Rng& rng) {
  const auto count = static_cast<std::size_t>(uniform(5, 30, rng));
  Polygon star;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const double radius = uniform(nearest, furthest, rng);
    star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  if (rng() % 2 == 0) std::reverse(star.begin(), star.end());
  std::rotate(star.begin(), star.begin() + static_cast<long>(rng() % count), star.end());
  return star;
}

TEST(Polygon, StarsAreSimple) {
  for_each_case(3, 20'000, [](Rng& rng) {
    const Polygon star = random_star(0.1, 1, rng);
    ASSERT_EQ(flaw(star), "") << as_code(star);
  });
}

TEST(Polygon, ExchangingTwoCornersOfAConvexPolygonCrossesItsSides) {
  for_each_case(4, 20'000, [](Rng& rng) {
    Polygon polygon = random_star(1, 1, rng);
    std::swap(polygon[0], polygon[1 + rng() % (polygon.size() - 1)]);
    ASSERT_NE(flaw(polygon), "") << as_code(polygon);
  });
}

TEST(Polygon, AllPlacesOfTheBoundsUpToTheDepthAreInside) {
  const Bounds bounds{-3, 3, -3, 3};  // many corners lie on their edge
  int more = 0;
  for_each_case(6, 50'000, [&](Rng& rng) {
    const auto whole = [&rng] { return std::floor(uniform(-4, 5, rng)); };
    Polygon polygon(static_cast<std::size_t>(uniform(3, 7, rng)));
    for (Point& corner : polygon) corner = {whole(), whole()};
    if (!flaw(polygon).empty()) return;
    const Point middle{uniform(-4, 4, rng), uniform(-4, 4, rng)};
    const double distance = geometry::distance_in_bounds(polygon, bounds, middle);
    const double of_all = geometry::distance_from_border(polygon, middle);
    ASSERT_LE(distance, std::max(of_all, 0.0)) << as_code(polygon);
    if (distance < 0 && distance < of_all) ++more;
    for (int i = 0; i < 20 && distance < 0; ++i) {
      const double way = std::min(-distance, 9.0) * (1 - 1e-9);
      const double angle = uniform(0, 7, rng), far = uniform(0, way, rng);
      const Point place{middle.x + far * std::cos(angle), middle.y + far * std::sin(angle)};
      if (contains(bounds, place)) {
        ASSERT_TRUE(contains(polygon, place)) << as_code(polygon);
      }
    }
  });
  EXPECT_GT(more, 10);  // sanitizers have few cases
}

// ---- Whole numbers tell exactly who meets whom ----

struct Node {
  long x, y;
};

long turn(const Node& a, const Node& b, const Node& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool lies_on(const Node& p, const Node& a, const Node& b) {
  return turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool have_common_point(const Node& a, const Node& b, const Node& c, const Node& d) {
  const auto differ = [](long one, long other) {
    return (one < 0 && other > 0) || (one > 0 && other < 0);
  };
  return lies_on(a, c, d) || lies_on(b, c, d) || lies_on(c, a, b) || lies_on(d, a, b) ||
         (differ(turn(a, b, c), turn(a, b, d)) && differ(turn(c, d, a), turn(c, d, b)));
}

bool is_simple(const std::vector<Node>& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Node& a = corners[i];
    const Node& b = corners[(i + 1) % count];
    const Node& after = corners[(i + 2) % count];
    // The next side may have no more than the corner in common, nor may this one with it.
    if (lies_on(after, a, b) || lies_on(a, b, after)) return false;
    for (std::size_t j = i + 2; j < count; ++j) {
      if (i == 0 && j + 1 == count) continue;
      if (have_common_point(a, b, corners[j], corners[(j + 1) % count])) return false;
    }
  }
  return true;
}

TEST(Polygon, CornersOnASmallGridAgreeWithComparingAllPairs) {
  int simple = 0;
  for_each_case(5, 100'000, [&](Rng& rng) {
    const auto count = static_cast<std::size_t>(uniform(3, 9, rng));
    const double side = uniform(2, 7, rng);
    std::vector<Node> nodes;
    Polygon corners;
    while (nodes.size() < count) {
      const Node node{static_cast<long>(uniform(0, side, rng)),
                      static_cast<long>(uniform(0, side, rng))};
      const bool repeats = !nodes.empty() && nodes.back().x == node.x && nodes.back().y == node.y;
      if (repeats) continue;
      nodes.push_back(node);
      corners.push_back({static_cast<double>(node.x), static_cast<double>(node.y)});
    }
    if (corners.front() == corners.back()) return;
    const bool is_line = std::all_of(nodes.begin(), nodes.end(), [&](const Node& node) {
      return turn(nodes[0], nodes[1], node) == 0;
    });
    const bool expected = !is_line && is_simple(nodes);
    simple += expected;
    ASSERT_EQ(flaw(corners).empty(), expected) << as_code(corners);
  });
  EXPECT_GT(simple, cases(100'000) / 10);
}

TEST(Polygon, OrientationIsRightWherePlainDoublesAreWrong) {
  const Point q{12, 12};
  const Point r{24, 24};
  int wrong = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const Point p{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
      const int expected = (j > i) - (j < i);
      ASSERT_EQ(geometry::orientation(q, r, p), expected) << i << ' ' << j;
      ASSERT_EQ(geometry::orientation(p, q, r), expected) << i << ' ' << j;
      ASSERT_EQ(geometry::orientation(q, p, r), -expected) << i << ' ' << j;
      const double area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
      wrong += (area > 0) - (area < 0) != expected;
    }
  }
  EXPECT_GT(wrong, 100);
}

TEST(Polygon, ManyWideSidesAreNoTrouble) {
  // Needles that all cross the middle of the star's box: pairs would be five thousand million.
  Polygon star;
  for (int i = 0; i < 100'000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 100'000;
    const double radius = i % 2 == 0 ? 1 : 100;
    star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  EXPECT_EQ(flaw(star), "");
  std::swap(star[40'000], star[60'000]);
  EXPECT_NE(flaw(star), "");
}

}  // namespace
}  // namespace vandplan
