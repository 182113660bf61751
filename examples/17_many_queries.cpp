// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I get the lengths of all ways between many places faster than by planning each way?

#include <vandplan/graphs.h>
#include <vandplan/judge.h>
#include <vandplan/steering.h>

#include <cstdio>
#include <memory>
#include <vector>

int main() {
  const vandplan::Vehicle truck;
  const auto yard = std::make_shared<const vandplan::World>(
      vandplan::Surroundings{.bounds = {-60, 60, -40, 40},
                             .obstacles = {{{-40, -4}, {-5, -4}, {-5, 4}, {-40, 4}},
                                           {{5, -4}, {40, -4}, {40, 4}, {5, 4}}}},
      vandplan::Point{0, 0});

  std::vector<vandplan::Pose> docks;  // on both sides of two halls, heading away from them
  for (int i = 0; i < 4; ++i) docks.push_back({-33.0 + 22 * i, 7, 3.141592653589793 / 2});
  for (int i = 0; i < 4; ++i) docks.push_back({-33.0 + 22 * i, -7, -3.141592653589793 / 2});

  // The roadmap is built once and answers any number of queries, from any thread. An edge is
  // checked when a query needs it, and the result is remembered.
  const vandplan::Roadmap roadmap = vandplan::build_roadmap(*yard, truck, {.nodes = 4000});
  std::printf("%lld poses, %lld edges\n     ", static_cast<long long>(roadmap.nodes()),
              static_cast<long long>(roadmap.edges()));
  for (std::size_t to = 0; to < docks.size(); ++to) std::printf("  dock %zu", to);

  int valid = 0;
  int longer = 0;  // ways that are longer than on open ground
  std::vector<double> open_ground(docks.size());
  for (std::size_t from = 0; from < docks.size(); ++from) {
    std::printf("\nfrom %zu", from);
    const std::vector<vandplan::Pose> start = {docks[from]};
    vandplan::reeds_shepp_lengths(start, docks, truck.min_turning_radius, open_ground);
    for (std::size_t to = 0; to < docks.size(); ++to) {
      // Poses of a roadmap are in the frame of the world.
      const auto answer = roadmap.route(vandplan::to_local(*yard, docks[from]),
                                        vandplan::to_local(*yard, docks[to]));
      if (!answer.route) return 1;
      std::printf("  %6.1f", answer.route->length);
      longer += answer.route->length > open_ground[to] + 1e-6 ? 1 : 0;
      const auto problem = vandplan::make_problem(yard, truck, docks[from], docks[to]);
      valid += vandplan::check_path(problem, {docks[from], answer.route->segments}).valid ? 1 : 0;
    }
  }
  // All ways can be driven, but are longer than necessary. Plan the way that is driven:
  // 04_many_pairs.
  std::printf("\n%d of 64 ways are valid, %d are longer than on open ground [m]\n", valid, longer);
  return valid == 64 && longer > 0 ? 0 : 1;
}
