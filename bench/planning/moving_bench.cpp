// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How soon and how well does the default planner plan among moving obstacles?
//
// usage: moving_bench WORLDS ITERATIONS [BEST]
// Random worlds of five kinds, WORLDS of each: a truck leaves the dock that is the goal; a door
// that slides; a gate through which somebody comes; a crossing; a lane in which somebody stops. A
// line (CSV) for each world: first drive (iterations, and the processor time of a run that ends
// there), cost of prices and 2 m for each second after ITERATIONS, the same over that of the best
// of twelve runs of BEST iterations, and segments below 5 cm. Then medians and 95 % by kind.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include "support/plans.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace {

using namespace vandplan;

constexpr double pi = std::numbers::pi;
const char* const kinds[] = {"dock", "door", "gate", "crossing", "stopped"};

double seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double between(Rng& rng, double low, double high) { return low + (high - low) * uniform01(rng); }

Polygon box(double x_min, double y_min, double x_max, double y_max) {
  return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

const Polygon truck = box(-1.6, -1.27, 5.9, 1.27);

Scenario dock(Rng& rng) {
  Scenario s;
  s.bounds = {-45, 45, -27, 12};
  s.start = {between(rng, -32, -22), between(rng, -15, -10), 0};
  const double x = between(rng, -4, 4);
  s.goal = {x, 7.4, -pi / 2};
  for (const double side : {-1.0, 1.0}) {
    for (double k = 0; k < 2; ++k) {
      const double middle = x + side * (3.9 + 3.9 * k);
      s.obstacles.push_back(box(middle - 1.3, 0, middle + 1.3, 9));
    }
  }
  const double t = between(rng, 2, 18);
  s.moving.push_back({truck,
                      {{t, {x, 7.6, -pi / 2}},
                       {t + 12, {x, -8, -pi / 2}},
                       {t + 18, {x + 8, -15, -0.3}},
                       {t + 30, {45, -18, 0}}},
                      Afterwards::leaves});
  return s;
}

Scenario door(Rng& rng) {
  Scenario s;
  s.bounds = {-20, 75, -25, 25};
  s.start = {0, between(rng, -8, 8), 0};
  s.goal = {55, between(rng, -8, 8), 0};
  s.obstacles = {box(29.6, 3, 30.4, 25), box(29.6, -25, 30.4, -3)};
  const double open = between(rng, 2, 20);
  const double shut = open + between(rng, 15, 30);
  s.moving.push_back({box(-0.3, -3, 0.3, 3),
                      {{open, {30, 0, 0}},
                       {open + 5, {30, 6.2, 0}},
                       {shut, {30, 6.2, 0}},
                       {shut + 5, {30, 0, 0}}}});
  return s;
}

Scenario gate(Rng& rng) {
  Scenario s;
  const double x = between(rng, 25, 35);
  const double half = between(rng, 2.2, 3.5);
  s.bounds = {-25, x + 60, -25, 25};
  s.goal = {x + 40, 0, 0};
  s.obstacles = {box(x, -25, x + 1, -half), box(x, half, x + 1, 25)};
  const double t = between(rng, 0, 8);
  const double slow = between(rng, 14, 26);
  s.moving.push_back(
      {truck,
       {{t, {x + 30, 0, pi}}, {t + slow, {x - 10, 0, pi}}, {t + slow + 6, {x - 20, -9, pi}}},
       Afterwards::leaves});
  return s;
}

Scenario crossing(Rng& rng) {
  Scenario s;
  s.bounds = {-20, 90, -30, 30};
  s.goal = {70, between(rng, -5, 5), 0};
  for (int i = 0; i < 5; ++i) {
    const double x = between(rng, 15, 60);
    const double t = between(rng, 0, 15);
    const double side = i % 2 == 0 ? 1 : -1;
    s.moving.push_back({truck,
                        {{t, {x, -29 * side, side * pi / 2}},
                         {t + between(rng, 8, 25), {x, 29 * side, side * pi / 2}}},
                        Afterwards::leaves});
  }
  return s;
}

Scenario stopped(Rng& rng) {
  Scenario s;
  s.bounds = {-20, 90, -8, 8};
  s.goal = {70, -2, 0};
  const double x = between(rng, 25, 45);
  const double t = between(rng, 4, 12);
  s.moving.push_back({truck, {{0, {x - 15, -1, 0}}, {t, {x, -1, 0}}}});
  s.moving.push_back(
      {truck, {{0, {85, 3, pi}}, {between(rng, 15, 30), {-10, 3, pi}}}, Afterwards::leaves});
  return s;
}

Scenario world(std::size_t kind, std::uint64_t seed) {
  Rng rng(1000 * kind + seed);
  Scenario (*const make[])(Rng&) = {dock, door, gate, crossing, stopped};
  Scenario s = make[kind](rng);
  s.vehicle = {.wheelbase = 4.5,
               .front_overhang = 1.4,
               .rear_overhang = 1.6,
               .width = 2.55,
               .min_turning_radius = 7};
  s.vehicle.limits.max_acceleration = 1;
  s.vehicle.limits.max_steering_rate = 0.5;
  s.vehicle.limits.max_speed = {3, 1.5};
  return s;
}

double cost_of(const PlanResult& result) {
  return result.path ? result.cost + 2 * result.speeds->duration : never;
}

PlanResult planned(const Scenario& scenario, std::int64_t iterations, std::uint64_t seed) {
  PlanOptions options;
  options.budget.max_iterations = iterations;
  options.budget.seed = seed;
  return plan(scenario, options);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::fprintf(stderr, "usage: moving_bench WORLDS ITERATIONS [BEST]\n"), 2;
  const int worlds = std::atoi(argv[1]);
  const std::int64_t iterations = std::atoll(argv[2]);
  const std::int64_t most = argc > 3 ? std::atoll(argv[3]) : 0;
  std::vector<double> all_first, all_excess;
  int all_crumbs = 0;
  std::printf("world,first_iteration,first_ms,cost,excess,crumbs,gear_changes\n");
  for (std::size_t kind = 0; kind < std::size(kinds); ++kind) {
    std::vector<double> first_times, excesses;
    for (int i = 0; i < worlds; ++i) {
      const Scenario scenario = world(kind, static_cast<std::uint64_t>(i));
      const PlanResult result = planned(scenario, iterations, 1);
      double best = cost_of(result);
      for (std::uint64_t seed = 1; most > 0 && seed <= 12; ++seed) {
        best = std::min(best, cost_of(planned(scenario, most, seed)));
      }
      const double excess = std::isinf(best) ? 0.0 : cost_of(result) / best - 1;
      int crumbs = 0;
      std::int64_t first = iterations;
      if (result.path) {
        first = result.anytime.front().iteration;
        for (const Segment& s : result.path->segments) crumbs += std::abs(s.length) < 0.05;
      }
      const double begin = seconds();
      (void)planned(scenario, std::max<std::int64_t>(first, 1), 1);
      const double time = result.path ? seconds() - begin : never;
      first_times.push_back(time);
      excesses.push_back(excess);
      all_crumbs += crumbs;
      std::printf("%s-%d,%lld,%.2f,%.2f,%.4f,%d,%d\n", kinds[kind], i,
                  static_cast<long long>(first), 1e3 * time, cost_of(result), excess, crumbs,
                  result.path ? gear_changes(result.path->segments) : 0);
    }
    std::printf("# %s: first drive %.1f ms, 95 %%: %.1f ms; excess %.2f %%, worst %.2f %%\n",
                kinds[kind], 1e3 * quantile(first_times, 0.5), 1e3 * quantile(first_times, 0.95),
                1e2 * quantile(excesses, 0.5), 1e2 * quantile(excesses, 1.0));
    all_first.insert(all_first.end(), first_times.begin(), first_times.end());
    all_excess.insert(all_excess.end(), excesses.begin(), excesses.end());
  }
  std::printf(
      "# all: first drive %.1f ms, 95 %%: %.1f ms; excess %.2f %%, worst %.2f %%; crumbs %d\n",
      1e3 * quantile(all_first, 0.5), 1e3 * quantile(all_first, 0.95),
      1e2 * quantile(all_excess, 0.5), 1e2 * quantile(all_excess, 1.0), all_crumbs);
}
