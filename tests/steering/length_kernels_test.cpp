// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Vector kernels of Reeds-Shepp lengths and of directions give the bits of the scalar functions, on
// every target of this machine.

#include "simd/length_kernels.h"
#include "vandplan/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "base/trigonometry.h"
#include "base/trigonometry_series.h"
#include "simd/pair_kernels.h"
#include "simd/turn_kernels.h"
#include "support/pose_pairs.h"
#include "support/simd_targets.h"
#include "vandplan/steering.h"

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

// ---- pairs, in double ----

bool is_same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}

/// Every pair has the bits of `reeds_shepp_length`; so has one pose with all others, either way.
void expect_exact_bits(std::span<const Pose> from, std::span<const Pose> to, double radius) {
  std::vector<double> out(from.size());
  const auto expect = [&](std::span<const Pose> a, std::span<const Pose> b) {
    reeds_shepp_lengths(a, b, radius, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Pose& first = a[a.size() == 1 ? 0 : i];
      const Pose& second = b[b.size() == 1 ? 0 : i];
      const double exact = reeds_shepp_length(first, second, radius);
      ASSERT_TRUE(is_same(out[i], exact))
          << as_code(out[i]) << " is not " << as_code(exact) << ": " << as_code(first) << ", "
          << as_code(second) << ", " << as_code(radius);
    }
  };
  expect(from, to);
  if (from.empty()) return;
  expect(from.first(1), to);
  expect(from, to.first(1));
}

TEST(LengthKernels, PairsHaveTheBitsOfTheExactLength) {
  on_every_target([](std::size_t count, Rng& rng) {
    const double radius = uniform(0.5, 20.0, rng);
    std::vector<Pose> from(count), to(count);
    for (std::size_t i = 0; i < count; ++i) {
      const DrawnPair pair = rng() % 4 == 0 ? grid_pair(rng) : any_pair(radius, rng);
      from[i] = pair.from;
      to[i] = pair.to;
      if (rng() % 8 == 0) to[i].heading += 6.283185307179586 * static_cast<double>(rng() % 100);
    }
    expect_exact_bits(from, to, rng() % 4 == 0 ? 1.0 : radius);
  });
}

// Grid points of the unit radius lie on the borders between words.
TEST(LengthKernels, PairsHaveTheBitsOfTheExactLengthOnAGrid) {
  on_every_target([](std::size_t count, Rng& rng) {
    const auto eighths = [&rng](int most) {
      const auto range = static_cast<unsigned>(2 * most + 1);
      return static_cast<double>(static_cast<int>(rng() % range) - most) / 8;
    };
    std::vector<Pose> from(count), to(count);
    for (std::size_t i = 0; i < count; ++i) {
      from[i] = {eighths(8), eighths(8), eighths(24)};
      to[i] = {eighths(32), eighths(32), rng() % 2 == 0 ? from[i].heading : eighths(24)};
    }
    expect_exact_bits(from, to, 1.0);
  });
}

TEST(LengthKernels, PairsThatAreNotForVectorsHaveTheBitsOfTheExactLength) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Pose> odd = {{1, 2, 3},        {1, 2, 1e5},   {1, 2, -799.5},   {1, 2, 801},
                                 {1e200, 2, 3},    {-1e99, 2, 3}, {1, -1e101, 3},   {nan, 2, 3},
                                 {1, infinity, 3}, {1, 2, nan},   {1, 2, -infinity}};
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const ForcedTarget forced(target);
    SCOPED_TRACE(hwy::TargetName(target));
    for (const Pose& other : odd) {
      const std::vector<Pose> others(odd.size(), other);
      expect_exact_bits(odd, others, 7.0);
      expect_exact_bits(others, odd, 7.0);
    }
  }
}

TEST(LengthKernels, VectorsLeaveOutOnlyWhatIsNotForThem) {
  const Pose from{1, 2, -300};
  const Pose to{9, 5, 300};
  double length = std::numeric_limits<double>::quiet_NaN();
  simd::exact_lengths({&from.x, 3}, {&to.x, 3}, 7.0, {&length, 1});
  EXPECT_EQ(length, reeds_shepp_length(from, to, 7.0));
}

// Angles of all sizes that are allowed, and beside the multiples of pi/4, where quarters change.
TEST(TurnKernels, SinesAndCosinesHaveTheBitsOfTheScalarFunction) {
  on_every_target([](std::size_t batches, Rng& rng) {
    const std::size_t count = batches * simd::turns_of_batch;
    std::vector<double> angles(count), sines(count), cosines(count);
    for (double& angle : angles) {
      const double eighths = std::round(uniform(-500, 500, rng)) * std::numbers::pi / 4;
      const double any = std::exp2(uniform(-40, 8.6, rng)) * (rng() % 2 == 0 ? 1 : -1);
      angle = rng() % 2 == 0 ? eighths + any * 1e-15 : any;
      angle = std::clamp(angle, -base::series::moderate, base::series::moderate);
    }
    simd::sines_and_cosines(angles, sines, cosines);
    for (std::size_t i = 0; i < count; ++i) {
      const base::SinCos exact = base::sin_cos(angles[i]);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(sines[i]), std::bit_cast<std::uint64_t>(exact.sin));
      EXPECT_EQ(std::bit_cast<std::uint64_t>(cosines[i]), std::bit_cast<std::uint64_t>(exact.cos));
    }
  });
}

}  // namespace
}  // namespace vandplan
