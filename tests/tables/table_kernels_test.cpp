// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Vector kernels of the tables give the bits of the scalar ones, on every target of this machine.

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "simd/bound_kernels.h"
#include "simd/table_kernels.h"
#include "support/simd_targets.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

/// Nodes with coordinates up to `reach`, on axes and grid lines among them.
struct Nodes {
  std::vector<float> x, y, heading;

  Nodes(std::size_t count, double reach, Rng& rng) {
    const auto draw = [&rng](double limit, double grid) {
      const double value = uniform(-limit, limit, rng);
      const bool snapped = uniform01(rng) < 0.3;
      return static_cast<float>(snapped ? grid * static_cast<double>(static_cast<int>(value / grid))
                                        : value);
    };
    for (std::size_t i = 0; i < count; ++i) {
      x.push_back(draw(reach, 1.0));
      y.push_back(draw(reach, 1.0));
      heading.push_back(draw(std::numbers::pi, std::numbers::pi / 12));
    }
  }
};

/// Calls `law(nodes, sample, rng)` on every target.
template <typename Law>
void with_nodes_on_every_target(Law law) {
  on_every_target([&law](std::size_t count, Rng& rng) {
    const double reach = uniform01(rng) < 0.5 ? 12.0 : 300.0;
    const Nodes nodes(count, reach, rng);
    const Nodes sample(1, reach, rng);
    law(nodes, sample, rng);
  });
}

TEST(TableKernels, DistancesHaveTheBitsOfTheScalarOnes) {
  std::vector<float> entries(31 * 31 * 25 * 25);
  Rng entries_rng(12);
  for (float& entry : entries) entry = static_cast<float>(uniform(0.0, 50.0, entries_rng));
  with_nodes_on_every_target([&entries](const Nodes& nodes, const Nodes& sample, Rng& rng) {
    const auto scale = static_cast<float>(uniform(0.5, 2.0, rng));
    const simd::TableView table{.entries = entries.data(),
                                .positions = 31,
                                .headings = 25,
                                .extent = 30.0F,
                                .cells_per_metre = 1.0F,
                                .cells_per_radian = 12 / std::numbers::pi_v<float>,
                                .to_table = scale,
                                .from_table = 1.0F / scale};
    const simd::TableSample to{sample.x[0], sample.y[0], sample.heading[0]};
    std::vector<float> scalar(nodes.x.size()), vector(nodes.x.size());
    simd::scalar::table_distances(table, nodes.x, nodes.y, nodes.heading, to, scalar);
    simd::table_distances(table, nodes.x, nodes.y, nodes.heading, to, vector);
    EXPECT_TRUE(same_bits(scalar, vector));
  });
}

TEST(TableKernels, BoundsHaveTheBitsOfTheScalarOnes) {
  std::vector<simd::BoundEntry> entries(simd::bound_cells);
  Rng entries_rng(13);
  for (simd::BoundEntry& entry : entries) {
    entry = {static_cast<std::uint32_t>(entries_rng()), static_cast<std::uint32_t>(entries_rng())};
  }
  with_nodes_on_every_target([&entries](const Nodes& nodes, const Nodes& sample, Rng& rng) {
    const auto radius = static_cast<float>(uniform(0.5, 20.0, rng));
    const simd::BoundSample to{sample.x[0], sample.y[0], sample.heading[0]};
    const std::size_t count = nodes.x.size();
    std::vector<float> low(count), high(count), vector_low(count), vector_high(count);
    simd::scalar::length_bounds(entries.data(), nodes.x, nodes.y, nodes.heading, to, radius, low,
                                high);
    simd::length_bounds(entries.data(), nodes.x, nodes.y, nodes.heading, to, radius, vector_low,
                        vector_high);
    EXPECT_TRUE(same_bits(low, vector_low));
    EXPECT_TRUE(same_bits(high, vector_high));
  });
}

}  // namespace
}  // namespace vandplan
