// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Exact lengths to many nodes, and the nearest of them: ours against OMPL's Reeds-Shepp space and
// its tree of neighbours (GNAT). Both in turns on the same nodes and samples, R = 7 m; figures are
// medians over the rounds.
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/datastructures/NearestNeighborsGNAT.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "support/ompl_poses.h"
#include "support/rounds.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan {
namespace {

constexpr double radius = 7;
constexpr std::size_t rounds = 9;

/// Poses, and the same for OMPL.
struct Poses {
  std::vector<Pose> ours;
  OmplPoses<ompl::base::ReedsSheppStateSpace> theirs{radius};

  Poses(std::size_t count, double reach, Rng& rng) {
    for (std::size_t i = 0; i < count; ++i) {
      ours.push_back(uniform_pose({-reach, reach, -reach, reach}, rng));
      theirs.add(ours.back());
    }
  }
};

void compare_lengths(double reach) {
  Rng rng(1);
  const Poses nodes(5000, reach, rng);
  const Poses samples(64, reach, rng);
  std::vector<float> x, y, heading, out(nodes.ours.size());
  for (const Pose& pose : nodes.ours) {
    x.push_back(static_cast<float>(pose.x));
    y.push_back(static_cast<float>(pose.y));
    heading.push_back(static_cast<float>(pose.heading));
  }
  double sum = 0;
  double worst = 0;
  std::vector<double> theirs, ours, ratios;
  for (std::size_t round = 0; round < rounds; ++round) {
    const auto* const sample = samples.theirs[round];
    theirs.push_back(nanoseconds(nodes.ours.size(), [&] {
      for (std::size_t i = 0; i < nodes.ours.size(); ++i) {
        sum += nodes.theirs.distance(nodes.theirs[i], sample);
      }
    }));
    ours.push_back(nanoseconds(nodes.ours.size() * samples.ours.size(), [&] {
      for (const Pose& pose : samples.ours) reeds_shepp_lengths({x, y, heading}, pose, radius, out);
    }));
    ratios.push_back(theirs.back() / ours.back());
    reeds_shepp_lengths({x, y, heading}, samples.ours[round], radius, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double length = nodes.theirs.distance(nodes.theirs[i], sample);
      worst = std::max(worst, std::abs(static_cast<double>(out[i]) - length) / (length + radius));
    }
  }
  std::printf("%5.0f m %12.0f ns %9.2f ns %8.0f times %12.1e %s\n", reach, median(theirs),
              median(ours), median(ratios), worst, sum > 0 ? "" : "?");
}

void compare_nearest(std::size_t count, double reach) {
  Rng rng(2);
  const Poses nodes(count, reach, rng);
  const Poses samples(256, reach, rng);
  // The lengths are equal; ours build the tree of 100 000 nodes in seconds instead of minutes.
  bool building = true;
  long lengths = 0;
  ompl::NearestNeighborsGNAT<std::size_t> tree;
  const auto at = [&](std::size_t i) {
    return i < count ? nodes.ours[i] : samples.ours[i - count];
  };
  const auto state = [&](std::size_t i) {
    return i < count ? nodes.theirs[i] : samples.theirs[i - count];
  };
  tree.setDistanceFunction([&](const std::size_t& a, const std::size_t& b) {
    ++lengths;
    return building ? reeds_shepp_length(at(a), at(b), radius)
                    : nodes.theirs.distance(state(a), state(b));
  });
  NearestNodes index(radius);
  for (std::size_t i = 0; i < count; ++i) {
    index.add(nodes.ours[i]);
    tree.add(i);
  }
  building = false;
  lengths = 0;

  double sum = 0;
  int different = 0;
  std::vector<double> theirs, ours, ratios, solves;
  for (std::size_t round = 0; round < rounds; ++round) {
    const std::size_t chunk = samples.ours.size() / rounds;
    theirs.push_back(nanoseconds(chunk, [&] {
      for (std::size_t i = 0; i < chunk; ++i) {
        const std::size_t sample = round * chunk + i;
        const std::size_t found = tree.nearest(count + sample);
        const double least = index.nearest(samples.ours[sample])->length;
        different += reeds_shepp_length(at(found), at(count + sample), radius) > least + 1e-6;
      }
    }));
    constexpr int repeats = 40;
    ours.push_back(nanoseconds(samples.ours.size() * repeats, [&] {
      for (int i = 0; i < repeats; ++i) {
        for (const Pose& sample : samples.ours) sum += index.nearest(sample)->length;
      }
    }));
    ratios.push_back(theirs.back() / ours.back());
  }
  for (const Pose& sample : samples.ours) {
    solves.push_back(static_cast<double>(index.nearest(sample)->exact_solves));
  }
  const double per_query =
      static_cast<double>(lengths) / static_cast<double>(samples.ours.size() / rounds * rounds);
  std::printf("%7zu %5.0f m %9.0f us %9.0f %9.2f us %6.0f %8.0f times %10d %s\n", count, reach,
              median(theirs) / 1000, per_query, median(ours) / 1000, median(solves), median(ratios),
              different, sum > 0 ? "" : "?");
}

}  // namespace
}  // namespace vandplan

int main() {
  using namespace vandplan;
  std::printf("Length of one pose to each of 5 000 nodes\n");
  std::printf("%7s %15s %12s %14s %12s\n", "within", "OMPL", "ours, batch", "ratio", "difference");
  for (const double reach : {10.0, 50.0, 200.0}) compare_lengths(reach);
  std::printf("\nThe nearest of all nodes, and how many exact lengths a query takes\n");
  std::printf("%7s %7s %12s %9s %12s %6s %14s %10s\n", "nodes", "within", "OMPL", "lengths", "ours",
              "median", "ratio", "different");
  for (const std::size_t count : {std::size_t{5000}, std::size_t{100000}}) {
    for (const double reach : {50.0, 200.0}) compare_nearest(count, reach);
  }
}
