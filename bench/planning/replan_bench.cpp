// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How long does a tick of the replanner take?
//
// usage: replan_bench [SEEDS]
// Processor time of ticks among 20 movers that are predicted anew each time, with constant velocity
// over 6 s, on 100 polygons and on 500 x 500 cells; and of a patch of 100 x 100 cells on
// 4000 x 4000 with the tick after it, on 16 maps. Then contacts and ticks without an answer. With 0
// seeds the patches alone.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "replanning/sensor.h"
#include "support/figure.h"
#include "vandplan/random.h"
#include "vandplan/replanner.h"

namespace {

using namespace vandplan;

double seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double between(Rng& rng, double low, double high) { return low + (high - low) * uniform01(rng); }

Polygon box_at(double x, double y, double half) {
  return {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
}

/// A yard of 120 x 80 m with a lane left free along its middle, and 20 movers that cross it.
Scenario yard(std::uint64_t seed) {
  Rng rng(seed);
  Scenario scenario;
  scenario.bounds = {-10, 110, -40, 40};
  scenario.goal = {100, 0, 0};
  for (int i = 0; i < 20; ++i) {
    const double x = between(rng, 20, 95);
    const double begin = between(rng, 0, 35);
    const double v = between(rng, 1, 6);
    const double side = i % 2 == 0 ? 1 : -1;
    scenario.moving.push_back(
        {{{-1, -0.9}, {3, -0.9}, {3, 0.9}, {-1, 0.9}},
         {{begin, {x, -side * 38, side * 1.5708}}, {begin + 76 / v, {x, side * 38, side * 1.5708}}},
         Afterwards::leaves});
  }
  return scenario;
}

void add_polygons(Scenario& scenario, std::uint64_t seed) {
  Rng rng(seed + 1000);
  while (scenario.obstacles.size() < 100) {
    const double x = between(rng, -5, 105);
    const double y = between(rng, -38, 38);
    if (std::abs(y) < 6) continue;
    scenario.obstacles.push_back(box_at(x, y, between(rng, 0.2, 1.2)));
  }
}

void add_map(Scenario& scenario, std::int32_t side, std::uint64_t seed) {
  Rng rng(seed + 2000);
  const double resolution = 120.0 / side;
  std::vector<Cell> cells(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  OccupancyGrid map{
      .origin = {-10, -60, 0}, .resolution = resolution, .columns = side, .rows = side};
  for (int i = 0; i < 100; ++i) {
    const double x = between(rng, 5, 115);
    const double y = between(rng, 22, 98);
    const double half = between(rng, 0.2, 1.2);
    if (std::abs(y - 60) < 6 + half) continue;
    const auto index = [&](double place) { return static_cast<std::size_t>(place / resolution); };
    for (std::size_t row = index(y - half); row <= index(y + half); ++row) {
      for (std::size_t column = index(x - half); column <= index(x + half); ++column) {
        cells[row * static_cast<std::size_t>(side) + column] = Cell::occupied;
      }
    }
  }
  map.cells = std::move(cells);
  scenario.map = map;
}

struct Figures {
  std::vector<double> ticks;  // [s]
  int without = 0;
  int new_ways = 0;
};

void drive(const Scenario& scenario, Prediction prediction, Figures& figures) {
  LiveDriveOptions options;
  options.prediction = prediction;
  ReplanOptions replan;
  replan.plan.clearance.margin = 0.3;
  Scenario known = scenario;
  if (prediction != Prediction::known) known.moving.clear();
  Replanner replanner(known, replan);
  Pose here = scenario.start;
  for (int i = 0; i < 400; ++i) {
    const double t = 0.1 * i;
    const auto seen = replanning::predicted(scenario.moving, here, t, options);
    const double begin = seconds();
    replanner.set_moving(seen);
    const ReplanAnswer answer = replanner.tick(t);
    if (i > 0) figures.ticks.push_back(seconds() - begin);
    figures.without += answer.is_safe ? 0 : 1;
    if (i > 0 && answer.outcome == TickOutcome::new_way) ++figures.new_ways;
    here = motion_at(answer.drive->path, scenario.vehicle, answer.drive->speeds,
                     t + 0.1 - answer.begin)
               .pose;
  }
}

void report(const char* what, Figures& figures) {
  std::ranges::sort(figures.ticks);
  const auto at = [&](double share) {
    if (figures.ticks.empty()) return figure("%7.3f", std::nan(""));
    const double last = static_cast<double>(figures.ticks.size() - 1);
    return figure("%7.3f", 1e3 * figures.ticks[static_cast<std::size_t>(share * last)]);
  };
  std::printf(
      "%-44s %7zu ticks: %s ms median, %s ms 99 %%, %s ms worst; %d without an "
      "answer, %d route changes\n",
      what, figures.ticks.size(), at(0.5).c_str(), at(0.99).c_str(), at(1.0).c_str(),
      figures.without, figures.new_ways);
  std::fflush(stdout);
}

void patch_large_map(std::uint64_t seed, Figures& all, Figures& new_ways) {
  Scenario scenario = yard(seed);
  scenario.moving.clear();
  add_map(scenario, 4000, seed);
  ReplanOptions replan;
  replan.plan.clearance.margin = 0.3;
  Replanner replanner(scenario, replan);
  (void)replanner.tick(0);
  for (int i = 0; i < 8; ++i) {
    // 3 x 3 m beside or in the way, and away again.
    const bool comes = i % 2 == 0;
    const CellPatch patch{2500, i % 4 == 0 ? 1960 : 2300, 100, 100,
                          std::vector<Cell>(10'000, comes ? Cell::occupied : Cell::free)};
    const CellPatch away{2500, i % 4 == 1 ? 1960 : 2300, 100, 100,
                         std::vector<Cell>(10'000, Cell::free)};
    const double begin = seconds();
    replanner.patch({.cells = {comes ? patch : away}});
    const ReplanAnswer answer = replanner.tick(0.1 * (i + 1));
    const double took = seconds() - begin;
    for (Figures* const figures : {&all, &new_ways}) {
      const bool is_new = answer.outcome == TickOutcome::new_way;
      if (figures == &new_ways && !is_new) continue;
      figures->ticks.push_back(took);
      figures->without += answer.is_safe ? 0 : 1;
      figures->new_ways += is_new ? 1 : 0;
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  if (seeds < 0) {
    std::fputs("usage: replan_bench [SEEDS]\n", stderr);
    return 2;
  }
  for (const Prediction prediction : {Prediction::known, Prediction::constant_velocity}) {
    if (seeds == 0) break;
    Figures polygons;
    Figures cells;
    for (int seed = 1; seed <= seeds; ++seed) {
      Scenario scenario = yard(static_cast<std::uint64_t>(seed));
      Scenario mapped = scenario;
      add_polygons(scenario, static_cast<std::uint64_t>(seed));
      add_map(mapped, 500, static_cast<std::uint64_t>(seed));
      drive(scenario, prediction, polygons);
      drive(mapped, prediction, cells);
    }
    const std::string name(name_of(prediction));
    report(("20 movers, 100 polygons, " + name).c_str(), polygons);
    report(("20 movers, 500 x 500 cells, " + name).c_str(), cells);
  }
  Figures patches;
  Figures new_ways;
  for (std::uint64_t seed = 1; seed <= 16; ++seed) patch_large_map(seed, patches, new_ways);
  report("patch of 100 x 100 on 4000 x 4000 and a tick", patches);
  report("those that take a new way", new_ways);
}
