// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How much slower does a planner become where zones lie about?
// usage: zones_bench FIRST LAST ITERATIONS ZONES
//
// Random worlds FIRST to LAST, without zones and with ZONES of them: prices, speeds and one-way
// streets in turn, 4 m to 20 m wide. Both are planned in turn, three times, as a driver. A line for
// each world: processor time of an iteration [us], and the ratio; then the ratio of all.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <vector>

#include "support/figure.h"
#include "support/plans.h"
#include "support/random_world.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;

/// A rectangle in the bounds with one rule: a price, a speed or a direction.
Zone any_zone(const Bounds& bounds, int number, Rng& rng) {
  const Point middle{uniform(bounds.x_min, bounds.x_max, rng),
                     uniform(bounds.y_min, bounds.y_max, rng)};
  const double heading = uniform(-pi, pi, rng);
  const double half = uniform(2, 10, rng), wide = uniform(2, 10, rng);
  Zone zone;
  for (const auto& [u, v] :
       {Point{-half, -wide}, Point{half, -wide}, Point{half, wide}, Point{-half, wide}}) {
    zone.area.push_back({middle.x + std::cos(heading) * u - std::sin(heading) * v,
                         middle.y + std::sin(heading) * u + std::cos(heading) * v});
  }
  if (number % 3 == 0) zone.cost = uniform(1.2, 4, rng);
  if (number % 3 == 1) zone.max_speed = uniform(0.5, 3, rng);
  if (number % 3 == 2) zone.direction = HeadingRange{heading - 1.5, heading + 1.5};
  return zone;
}

Problem with_zones(const Problem& problem, int zones, std::uint64_t seed) {
  Surroundings ground = problem.world()->without_fences();
  Rng rng(seed);
  for (int i = 0; i < zones; ++i) ground.zones.push_back(any_zone(ground.bounds, i, rng));
  const auto world = std::make_shared<const World>(ground, Point{});
  return make_problem(world, problem.vehicle(), problem.start(), problem.goal());
}

struct Planned {
  bool is_solved = false;
  double time = never;  // of an iteration [s]
};

Planned planned(const Problem& problem, std::int64_t iterations) {
  PlanOptions options;
  options.budget.max_iterations = iterations;
  const PlanResult result = plan(problem, options);
  const auto done = static_cast<double>(std::max<std::int64_t>(result.iterations, 1));
  return {result.path.has_value(), result.time_total / done};
}

void run(std::uint64_t first, std::uint64_t last, std::int64_t iterations, int zones) {
  std::vector<double> ratios;
  for (std::uint64_t number = first; number <= last; ++number) {
    const Problem plain = random_world(number);
    const Problem zoned = with_zones(plain, zones, number);
    std::array<double, 2> times = {never, never};
    bool is_solved = true;
    for (int i = 0; i < 3 && is_solved; ++i) {
      const std::array<Planned, 2> both = {planned(plain, iterations), planned(zoned, iterations)};
      for (std::size_t k = 0; k < both.size(); ++k) {
        times[k] = std::min(times[k], both[k].time);
        is_solved = is_solved && both[k].is_solved;
      }
    }
    if (!is_solved) {
      std::printf("%llu is not solved\n", static_cast<unsigned long long>(number));
      continue;
    }
    ratios.push_back(times[1] / times[0]);
    std::printf("%llu %6.2f us, with zones %6.2f us: %.2f times\n",
                static_cast<unsigned long long>(number), 1e6 * times[0], 1e6 * times[1],
                ratios.back());
    std::fflush(stdout);
  }
  std::printf("%zu solved; %s times in the median, 90 %% %s\n", ratios.size(),
              figure("%.2f", quantile(ratios, 0.5)).c_str(),
              figure("%.2f", quantile(ratios, 0.9)).c_str());
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: zones_bench FIRST LAST ITERATIONS ZONES\n");
    return 2;
  }
  vandplan::run(std::strtoull(argv[1], nullptr, 10), std::strtoull(argv[2], nullptr, 10),
                std::strtoll(argv[3], nullptr, 10), std::atoi(argv[4]));
}
