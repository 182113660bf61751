// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Vector kernels of Reeds-Shepp lengths give the bits of the scalar ones, on every target of this
// machine.

#include "simd/length_kernels.h"
#include "vandplan/random.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/pose_pairs.h"
#include "support/simd_targets.h"

namespace vandplan {
namespace {

TEST(LengthKernels, LengthsHaveTheBitsOfTheScalarOnes) {
  on_every_target([](std::size_t count, Rng& rng) {
    const double radius = uniform(0.5, 20.0, rng);
    const Pose sample = uniform_pose({-200, 200, -200, 200}, rng);
    std::vector<float> x(count), y(count), heading(count), scalar(count), vector(count);
    for (std::size_t i = 0; i < count; ++i) {
      const DrawnPair pair = any_pair(radius, rng);  // as seen from the sample
      const Pose node = compose(sample, relative(pair.to, pair.from));
      x[i] = static_cast<float>(node.x);
      y[i] = static_cast<float>(node.y);
      heading[i] = static_cast<float>(node.heading);
    }
    const simd::LengthSample to{static_cast<float>(sample.x), static_cast<float>(sample.y),
                                static_cast<float>(sample.heading)};
    const auto r = static_cast<float>(radius);
    simd::scalar::reeds_shepp_lengths(x, y, heading, to, r, scalar);
    simd::reeds_shepp_lengths(x, y, heading, to, r, vector);
    EXPECT_TRUE(same_bits(scalar, vector));
  });
}

// Small numbers without rounding, so that lanes lie on the borders between words.
TEST(LengthKernels, LengthsHaveTheBitsOfTheScalarOnesOnAGrid) {
  on_every_target([](std::size_t count, Rng& rng) {
    const auto eighths = [&rng](int most) {
      const auto range = static_cast<unsigned>(2 * most + 1);
      return static_cast<float>(static_cast<int>(rng() % range) - most) / 8;
    };
    std::vector<float> x(count), y(count), heading(count), scalar(count), vector(count);
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = eighths(32);
      y[i] = eighths(32);
      heading[i] = eighths(24);
    }
    const simd::LengthSample to{eighths(8), eighths(8), eighths(24)};
    simd::scalar::reeds_shepp_lengths(x, y, heading, to, 1.0F, scalar);
    simd::reeds_shepp_lengths(x, y, heading, to, 1.0F, vector);
    EXPECT_TRUE(same_bits(scalar, vector));
  });
}

}  // namespace
}  // namespace vandplan
