// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How soon is a large map ready, how much memory does it take, and how soon is there a way across?
// usage: large_map_bench SEEDS CELLS
//        large_map_bench FOLDER CELLS
//
// A site of CELLS x CELLS cells of 5 cm (CELLS >= 3000) with buildings in lots and streets between
// them; "noisy" has single occupied and unknown cells in the lots, too. It is written as PGM, read,
// and crossed from corner to corner by two vehicles that share its world. A line (CSV) for each
// kind, medians over the seeds; the second line's memory is that of both. Times are processor time.
// FOLDER: gets the sites as files.
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/rounds.h"
#include "support/temporary_folder.h"
#include "vandplan/files.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

constexpr double resolution = 0.05;  // [m]
constexpr int lot = 1200;            // side of a lot with its half of the streets [cells]
constexpr int least_cells = 3000;
constexpr std::array kinds = {"site", "noisy"};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1e3;
}

/// Columns and rows of cells, from the first up to before the last; rows count from the top.
struct Block {
  int x_begin, x_end, y_begin, y_end;
};

/// Four in each lot.
std::vector<Block> buildings_of(int cells) {
  Rng rng(5);
  const auto any = [&](int low, int high) { return static_cast<int>(uniform(low, high, rng)); };
  std::vector<Block> buildings;
  for (int y = 0; y + lot <= cells; y += lot) {
    for (int x = 0; x + lot <= cells; x += lot) {
      for (int i = 0; i < 4; ++i) {
        const int width = any(lot / 6, lot / 3);
        const int height = any(lot / 6, lot / 3);
        const int left = x + any(lot / 8, lot - lot / 8 - width);
        const int top = y + any(lot / 8, lot - lot / 8 - height);
        buildings.push_back({left, left + width, top, top + height});
      }
    }
  }
  return buildings;
}

/// Row by row: the map is never held as a whole.
void write_image(const std::string& file, int cells, bool is_noisy) {
  const std::vector<Block> buildings = buildings_of(cells);
  FileWriter writer(file);
  writer.write("P5\n" + std::to_string(cells) + " " + std::to_string(cells) + "\n255\n");
  Rng rng(6);
  for (int y = 0; y < cells; ++y) {
    std::string row(static_cast<std::size_t>(cells), '\xFE');
    for (int i = 0; is_noisy && i < cells / 1000; ++i) {
      const auto x = static_cast<int>(uniform(0, cells, rng));
      const bool is_in_lot = std::min({x % lot, lot - x % lot, y % lot, lot - y % lot}) > lot / 8;
      if (is_in_lot) row[static_cast<std::size_t>(x)] = i % 2 == 0 ? '\0' : '\xCD';
    }
    for (const Block& block : buildings) {
      if (y < block.y_begin || y >= block.y_end) continue;
      std::fill(row.begin() + block.x_begin, row.begin() + block.x_end, '\0');
    }
    writer.write(row);
  }
  writer.commit();
}

/// From the first crossing of two streets to the last one. Returns the scenario's file.
std::string write_site(const std::string& folder, const std::string& kind, int cells) {
  const std::string name = folder + "/" + kind + "-" + std::to_string(cells);
  write_image(name + ".pgm", cells, kind == "noisy");
  write_file(name + ".map.yaml", "image: \"" + name +
                                     ".pgm\"\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                     "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  const auto text = [](double x) { return std::to_string(x); };
  const std::string side = text(cells * resolution);
  const double first = lot * resolution;
  const double last = (cells - 1) / lot * first;
  write_file(name + ".yaml", "name: " + kind + "\nvehicle: two-axle-truck\nbounds: {x: [0, " +
                                 side + "], y: [0, " + side + "]}\nstart: {x: " + text(first) +
                                 ", y: " + text(cells * resolution - last) +
                                 ", heading: 0}\ngoal: {x: " + text(last) +
                                 ", y: " + text(cells * resolution - first) +
                                 ", heading: 0}\nmap: \"" + name + ".map.yaml\"\n");
  return name + ".yaml";
}

struct FirstPath {
  double time, length;
};

/// Medians over the seeds. Throws where there is no way across.
FirstPath first_path(const Problem& problem, int seeds) {
  std::vector<double> times, lengths;
  for (int seed = 1; seed <= seeds; ++seed) {
    PlanOptions options;
    options.budget.seed = static_cast<std::uint64_t>(seed);
    options.budget.target_gap = 1e3;  // any path will do
    options.budget.time_limit = 10;
    const PlanResult result = plan(problem, default_planner(), options);
    if (!result.path) throw std::runtime_error("no path");
    times.push_back(result.anytime.front().time);
    lengths.push_back(length(*result.path));
  }
  return {median(times), median(lengths)};
}

void print(const std::string& kind, int cells, const char* vehicle, double ready,
           const FirstPath& path) {
  std::printf("%s,%d,%s,%.3f,%.4f,%.0f,%.0f\n", kind.c_str(), cells, vehicle, ready, path.time,
              path.length, peak_memory());
  std::fflush(stdout);
}

void measure(const std::string& kind, int cells, int seeds) {
  const TemporaryFolder folder;
  const std::string site = write_site(folder.path(), kind, cells);
  const double begin = now();
  const ScenarioProblems read = read_problems(site);
  const Problem& problem = read.problems.front();
  const double ready = now() - begin;
  print(kind, cells, "two-axle-truck", ready, first_path(problem, seeds));
  const double again = now();
  const Problem bus =
      make_problem(problem.world(), vehicle_named("city-bus"), problem.start(), problem.goal());
  const double ready_again = now() - again;
  print(kind, cells, "city-bus", ready_again, first_path(bus, seeds));
}

int run(int argc, char** argv) {
  const int cells = argc == 3 ? std::atoi(argv[2]) : 0;
  if (cells < least_cells) {
    std::fprintf(stderr,
                 "usage: large_map_bench SEEDS CELLS\n"
                 "       large_map_bench FOLDER CELLS\n");
    return 2;
  }
  const int seeds = std::atoi(argv[1]);
  if (seeds == 0) {
    for (const char* const kind : kinds) (void)write_site(argv[1], kind, cells);
    return 0;
  }
  std::printf("kind,cells along a side,vehicle,ready [s],first path [s],length [m],memory [MB]\n");
  for (const char* const kind : kinds) measure(kind, cells, seeds);
  return 0;
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  try {
    return vandplan::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
