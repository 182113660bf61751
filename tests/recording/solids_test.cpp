// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "recording/solids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/cases.h"

namespace vandplan::recording {
namespace {

constexpr Colour any_colour{0, 0, 0};

double area_of(const Polygon& polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    area += (a.x * b.y - a.y * b.x) / 2;
  }
  return area;
}

/// Sum of the areas of all triangles that lie at the height `z`, each of which turns left.
double area_of_lid(const Triangles& prism, double z) {
  double sum = 0.0;
  for (std::size_t i = 0; i < prism.corners.size(); i += 3) {
    Polygon triangle;
    for (std::size_t j = i; j < i + 3; ++j) {
      const Place& place = prism.points.at(prism.corners[j]);
      if (place.z == z) triangle.push_back({place.x, place.y});
    }
    if (triangle.size() < 3) continue;
    EXPECT_GE(area_of(triangle), 0.0);
    sum += area_of(triangle);
  }
  return sum;
}

TEST(Solids, APrismOfABoxHasFiveFaces) {
  const Triangles prism = prism_of({{0, 0}, {0, 2}, {3, 2}, {3, 0}}, 1.5, any_colour);
  EXPECT_EQ(prism.points.size(), 8U);
  EXPECT_EQ(prism.corners.size(), 3U * (4 * 2 + 2));
  EXPECT_DOUBLE_EQ(area_of_lid(prism, 1.5), 6.0);
}

TEST(Solids, TheLidCoversAPolygonOnce) {
  for_each_case(1, 300, [](Rng& rng) {
    // A star with corners at random distances, in either orientation.
    const int count = 3 + static_cast<int>(20 * uniform01(rng));
    Polygon star;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * std::numbers::pi * k / count;
      const double radius = uniform(0.5, 5.0, rng);
      star.push_back({1e4 + radius * std::cos(angle), radius * std::sin(angle)});
    }
    const double area = area_of(star);
    if (rng() % 2 == 1) std::reverse(star.begin(), star.end());
    EXPECT_NEAR(area_of_lid(prism_of(star, 2.0, any_colour), 2.0), area, 1e-6);
  });
}

TEST(Solids, CornersOnASideAndConcaveCornersAreCut) {
  // A U, with a corner in the middle of its lowest side.
  const Polygon u = {{0, 0}, {3, 0}, {6, 0}, {6, 5}, {4, 5}, {4, 1}, {2, 1}, {2, 5}, {0, 5}};
  EXPECT_DOUBLE_EQ(area_of_lid(prism_of(u, 1.0, any_colour), 1.0), area_of(u));
}

TEST(Solids, AnOutlineIsALoopThroughAllCorners) {
  const Line line = outline_of({{0, 0}, {1, 0}, {0, 1}}, any_colour);
  EXPECT_EQ(line.join, Join::loop);
  EXPECT_EQ(line.points.size(), 3U);
  EXPECT_GT(line.points.front().z, 0.0);
}

}  // namespace
}  // namespace vandplan::recording
