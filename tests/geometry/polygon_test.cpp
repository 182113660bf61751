// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/cases.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

std::string flaw(const Polygon& polygon) { return geometry::flaw_of(polygon, {}); }

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

}  // namespace
}  // namespace vandplan
