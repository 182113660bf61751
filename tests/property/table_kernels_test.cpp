// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Vector kernels of the tables give the bits of the scalar ones, on every target of this machine.

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstring>
#include <numbers>
#include <string_view>
#include <vector>

#include "random.h"
#include "simd/bound_kernels.h"
#include "simd/table_kernels.h"
#include "simd/target.h"
#include "support/cases.h"

namespace vandplan {
namespace {

/// Makes the kernels run on one target as long as it lives.
class ForcedTarget {
 public:
  explicit ForcedTarget(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }
  ~ForcedTarget() { hwy::SetSupportedTargetsForTest(0); }
  ForcedTarget(const ForcedTarget&) = delete;
  ForcedTarget& operator=(const ForcedTarget&) = delete;
};

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

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

/// Calls `law(nodes, x, y, heading, rng)` on every target with sizes around those of a vector and
/// of a block, and many others.
template <typename Law>
void on_every_target(Law law) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const ForcedTarget forced(target);
    SCOPED_TRACE(hwy::TargetName(target));
    ASSERT_EQ(kernels::simd_target(), std::string_view(hwy::TargetName(target)));
    Rng rng(11);
    for (std::size_t i = 0; i < static_cast<std::size_t>(cases(1000)); ++i) {
      const std::size_t count = i < 300 ? i : rng() % 1000;
      const double reach = uniform01(rng) < 0.5 ? 12.0 : 300.0;
      const Nodes nodes(count, reach, rng);
      const Nodes sample(1, reach, rng);
      SCOPED_TRACE("case " + std::to_string(i));
      law(nodes, sample, rng);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(TableKernels, DistancesHaveTheBitsOfTheScalarOnes) {
  std::vector<float> entries(31 * 31 * 25 * 25);
  Rng entries_rng(12);
  for (float& entry : entries) entry = static_cast<float>(uniform(0.0, 50.0, entries_rng));
  on_every_target([&entries](const Nodes& nodes, const Nodes& sample, Rng& rng) {
    const auto scale = static_cast<float>(uniform(0.5, 2.0, rng));
    const kernels::TableView table{.entries = entries.data(),
                                   .positions = 31,
                                   .headings = 25,
                                   .extent = 30.0F,
                                   .cells_per_metre = 1.0F,
                                   .cells_per_radian = 12 / std::numbers::pi_v<float>,
                                   .to_table = scale,
                                   .from_table = 1.0F / scale};
    const kernels::TableSample to{sample.x[0], sample.y[0], sample.heading[0]};
    std::vector<float> scalar(nodes.x.size()), vector(nodes.x.size());
    kernels::scalar::table_distances(table, nodes.x, nodes.y, nodes.heading, to, scalar);
    kernels::table_distances(table, nodes.x, nodes.y, nodes.heading, to, vector);
    EXPECT_TRUE(same_bits(scalar, vector));
  });
}

TEST(TableKernels, BoundsHaveTheBitsOfTheScalarOnes) {
  std::vector<kernels::BoundEntry> entries(kernels::bound_cells);
  Rng entries_rng(13);
  for (kernels::BoundEntry& entry : entries) {
    entry = {static_cast<std::uint32_t>(entries_rng()), static_cast<std::uint32_t>(entries_rng())};
  }
  on_every_target([&entries](const Nodes& nodes, const Nodes& sample, Rng& rng) {
    const auto radius = static_cast<float>(uniform(0.5, 20.0, rng));
    const kernels::BoundSample to{sample.x[0], sample.y[0], sample.heading[0]};
    const std::size_t count = nodes.x.size();
    std::vector<float> low(count), high(count), vector_low(count), vector_high(count);
    kernels::scalar::length_bounds(entries.data(), nodes.x, nodes.y, nodes.heading, to, radius, low,
                                   high);
    kernels::length_bounds(entries.data(), nodes.x, nodes.y, nodes.heading, to, radius, vector_low,
                           vector_high);
    EXPECT_TRUE(same_bits(low, vector_low));
    EXPECT_TRUE(same_bits(high, vector_high));
  });
}

}  // namespace
}  // namespace vandplan
