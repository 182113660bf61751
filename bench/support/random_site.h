// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// A site of any size: how does work grow with the number of buildings and with the way?

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "vandplan/files.h"
#include "vandplan/problem.h"
#include "vandplan/random.h"

namespace vandplan {

/// A convex building of 3 to 8 corners on a circle of 2 to 8 m, in whole millimetres; empty where
/// the draw has corners too near to each other.
inline Polygon random_building(const Point& centre, Rng& rng) {
  constexpr double turn = 2 * std::numbers::pi;
  const double radius = uniform(2, 8, rng);
  std::vector<double> angles(static_cast<std::size_t>(uniform(3, 9, rng)));
  for (double& angle : angles) angle = uniform(0, turn, rng);
  std::sort(angles.begin(), angles.end());
  Polygon building;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const bool is_last = i + 1 == angles.size();
    const double next = is_last ? angles[0] + turn : angles[i + 1];
    if (next - angles[i] < 0.2) return {};
    const auto rounded = [](double x) { return std::round(1e3 * x) / 1e3; };
    building.push_back({rounded(centre.x + radius * std::cos(angles[i])),
                        rounded(centre.y + radius * std::sin(angles[i]))});
  }
  return building;
}

/// From one corner of a square to the opposite one through so many buildings, one for each `area`
/// [m^2]; places within 12 m of start and goal are free.
inline Scenario random_site(const std::string& name, int buildings, double area) {
  const double side = std::sqrt(buildings * area);
  Rng rng(static_cast<std::uint64_t>(buildings));
  Scenario site{.name = name,
                .vehicle = vehicle_named("two-axle-truck"),
                .bounds = {-30, side + 30, -30, side + 30},
                .goal = {side, side, std::numbers::pi / 2}};
  while (site.obstacles.size() < static_cast<std::size_t>(buildings)) {
    const double x = uniform(-10, side + 10, rng);
    const double y = uniform(-10, side + 10, rng);
    constexpr double free = 20.0;  // from the middle of a building [m]
    if (std::min(std::hypot(x, y), std::hypot(x - side, y - side)) < free) continue;
    Polygon building = random_building({x, y}, rng);
    if (!building.empty()) site.obstacles.push_back(std::move(building));
  }
  return site;
}

}  // namespace vandplan
