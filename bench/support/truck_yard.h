// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// A yard of 100 x 100 m with 50 crates, where a truck drives at a driver's prices.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "vandplan/problem.h"
#include "vandplan/random.h"

namespace vandplan::truck_yard {

inline constexpr double side = 100.0;  // [m]
inline constexpr std::size_t crates = 50;
/// vehicles/two-axle-truck.yaml
inline const Vehicle truck{.wheelbase = 6.1,
                           .front_overhang = 1.2,
                           .rear_overhang = 1.8,
                           .width = 2.4,
                           .min_turning_radius = 9.84,
                           .limits = {.max_steering_rate = 0.71}};

/// The yard: crates of 1 to 5 m, and a goal at one side.
inline Scenario scenario() {
  Rng rng(42);
  Scenario scenario{.name = "yard",
                    .vehicle = truck,
                    .bounds = {0, side, 0, side},
                    .start = {15, 15, 0},
                    .goal = {50, 12, std::numbers::pi / 2}};
  while (scenario.obstacles.size() < crates) {
    const Point corner{uniform(0, side - 5, rng), uniform(0, side - 5, rng)};
    if (std::hypot(corner.x - 50, corner.y - 15) < 14) continue;
    const double width = uniform(1, 5, rng);
    const double height = uniform(1, 5, rng);
    scenario.obstacles.push_back({corner,
                                  {corner.x + width, corner.y},
                                  {corner.x + width, corner.y + height},
                                  {corner.x, corner.y + height}});
  }
  return scenario;
}

inline Problem yard() { return make_problem(scenario()); }

/// Random free poses of the yard.
inline std::vector<Pose> free_poses(const Problem& problem, std::size_t count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Pose> poses;
  while (poses.size() < count) {
    const Pose pose{uniform(5, side - 5, rng), uniform(5, side - 5, rng),
                    uniform(-std::numbers::pi, std::numbers::pi, rng)};
    const LocalPose local = to_local(*problem.world(), pose);
    if (problem.task().checker->is_free(local)) poses.push_back(pose);
  }
  return poses;
}

}  // namespace vandplan::truck_yard
