// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Which of many poses is nearest by driven length, and how far are they, roughly and quickly?

#include <vandplan/steering.h>
#include <vandplan/tables.h>

#include <cstdio>

int main() {
  const double radius = 7;  // turning radius [m]
  const vandplan::Pose sample{3, -2, 0.7};

  vandplan::NearestNodes nodes(radius);
  double least = 1e9;  // least of the exact lengths [m], computed one by one
  for (int i = 0; i < 1000; ++i) {
    const vandplan::Pose node{-50.0 + i % 40 * 2.5, -50.0 + i / 40 * 4.0, i * 0.1};
    nodes.add(node);
    const double length = vandplan::reeds_shepp_length(node, sample, radius);
    if (length < least) least = length;
  }
  const auto nearest = nodes.nearest(sample);
  if (!nearest) return 1;
  std::printf("node %d is nearest, %.3f m away; %lld of 1000 lengths were computed\n",
              nearest->node, nearest->length, static_cast<long long>(nearest->exact_solves));

  // A table of lengths as in the thesis, and a table that bounds lengths from below and above.
  const vandplan::HeuristicTable table({.extent = 10, .step = 1, .heading_cells = 8});
  const vandplan::Pose node{8, 3, -1};
  const double exact = vandplan::reeds_shepp_length(node, sample, radius);
  const auto [low, high] = vandplan::length_bounds(node, sample, radius);
  std::printf("exact %.3f m; by the table %.3f m; at least %.3f m, at most %.3f m\n", exact,
              table.distance(node, sample, radius), low, high);

  return nearest->length == least && low <= exact && exact <= high ? 0 : 1;
}
