// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How close do tables come to the exact length? In turning radii, R = 7 m, over 10^6 random pairs
// within some metres of each other. With --curve: along a shift sideways, as CSV [m].
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "vandplan/random.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan {
namespace {

constexpr double radius = 7;
constexpr double pi = std::numbers::pi;

struct Pair {
  Pose node, sample;
  double length;
};

std::vector<Pair> pairs_within(double reach) {
  Rng rng(1);
  std::vector<Pair> pairs(1'000'000);
  for (Pair& pair : pairs) {
    pair.node = uniform_pose({-reach, reach, -reach, reach}, rng);
    pair.sample = {0.0, 0.0, uniform(-pi, pi, rng)};
    pair.length = reeds_shepp_length(pair.node, pair.sample, radius);
  }
  return pairs;
}

void print(const std::string& what, std::size_t bytes, double reach, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  std::printf("%-28s %7.2f MB %5.0f m %9.5f %9.5f %9.5f\n", what.c_str(),
              static_cast<double>(bytes) / 1e6, reach, at(0.5), at(0.95), at(1.0));
}

void compare_tables() {
  const HeuristicTable like_bounds({.extent = 20, .step = 1, .heading_cells = 24});
  std::printf("%-28s %10s %7s %9s %9s %9s\n", "", "memory", "within", "median", "95 %", "worst");
  for (const double reach : {10.0, 50.0, 200.0}) {
    const std::vector<Pair> pairs = pairs_within(reach);
    std::vector<double> width, from_middle;
    for (const auto& [node, sample, length] : pairs) {
      const auto [low, high] = length_bounds(node, sample, radius);
      width.push_back((high - low) / radius);
      from_middle.push_back(std::abs(length - (low + high) / 2) / radius);
    }
    const std::size_t bytes = bound_table_info().bytes;
    print("bounds, high - low", bytes, reach, width);
    print("bounds, error of the middle", bytes, reach, from_middle);
    const auto add = [&](const std::string& name, const HeuristicTable& table) {
      std::vector<double> error;
      for (const auto& [node, sample, length] : pairs) {
        error.push_back(std::abs(table.distance(node, sample, radius) - length) / radius);
      }
      print(name, table.entries().size_bytes(), reach, error);
    };
    add("error of 20 m, 1 m, pi/12", like_bounds);
    for (const int number : {1, 2, 3, 4}) {
      add("error of table " + std::to_string(number), thesis_table(number));
    }
  }
}

// The sample at the origin, the node beside it; both head along x.
void print_curve() {
  const HeuristicTable table = thesis_table(4);
  std::printf("shift,exact,low,high,table_4,euclid\n");
  for (int i = 0; i <= 350; ++i) {
    const Pose node{0.0, i * 0.04, 0.0};
    const Pose sample{};
    const auto [low, high] = length_bounds(node, sample, radius);
    std::printf("%.2f,%.5f,%.5f,%.5f,%.5f,%.5f\n", node.y, reeds_shepp_length(node, sample, radius),
                low, high, table.distance(node, sample, radius), node.y);
  }
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--curve") == 0) {
    vandplan::print_curve();
  } else {
    vandplan::compare_tables();
  }
}
