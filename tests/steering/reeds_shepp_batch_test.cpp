// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How far are batch lengths, in float, from the exact ones?

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "simd/length_kernels.h"
#include "support/cases.h"
#include "support/pose_pairs.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using std::numbers::pi;

/// The error of the float length as a share of length + radius.
double error(const Pose& node, const Pose& sample, double radius) {
  const float length = simd::reeds_shepp_length(
      static_cast<float>(node.x - sample.x), static_cast<float>(node.y - sample.y),
      static_cast<float>(wrap_angle(node.heading)), static_cast<float>(wrap_angle(sample.heading)),
      static_cast<float>(radius));
  const double exact = reeds_shepp_length(node, sample, radius);
  return std::abs(static_cast<double>(length) - exact) / (exact + radius);
}

/// `n` pairs that `draw(radius, rng)` gives stay within half of the error that is allowed for.
template <typename Draw>
void expect_small_errors(std::uint64_t seed, int n, Draw draw) {
  Rng rng(seed);
  for (int i = 0; i < cases(n); ++i) {
    const double radius = uniform(0.5, 20.0, rng);
    const DrawnPair pair = draw(radius, rng);
    const double e = error(pair.from, pair.to, radius);
    ASSERT_LE(e, static_cast<double>(simd::length_error) / 2)
        << as_code(pair.from) << ", " << as_code(pair.to) << ", " << as_code(radius);
  }
}

TEST(ReedsSheppBatch, ErrorsAreSmall) { expect_small_errors(1, 5'000'000, any_pair); }

TEST(ReedsSheppBatch, ErrorsAreSmallAtAnyDistance) {
  expect_small_errors(2, 5'000'000, [](double radius, Rng& rng) {
    const double distance = radius * std::pow(10.0, uniform(-6.0, 4.0, rng));
    const double bearing = uniform(-pi, pi, rng);
    DrawnPair pair{
        {0, 0, uniform(-pi, pi, rng)},
        {distance * std::cos(bearing), distance * std::sin(bearing), uniform(-pi, pi, rng)}};
    if (uniform01(rng) < 0.5) {
      const double turn = std::pow(10.0, uniform(-8.0, 0.0, rng));
      pair.to.heading = pair.from.heading + (uniform01(rng) < 0.7 ? turn : pi - turn);
    }
    return pair;
  });
}

// Where the length is steepest: a shift sideways, or almost, by headings that almost agree.
TEST(ReedsSheppBatch, ErrorsAreSmallWhereTheLengthIsSteep) {
  expect_small_errors(3, 5'000'000, [](double radius, Rng& rng) {
    const double shift = std::pow(10.0, uniform(-6.0, 1.0, rng));
    const double less = shift * (uniform01(rng) < 0.5 ? shift : 1.0);
    const bool sideways = uniform01(rng) < 0.5;
    const double other = shift * shift * uniform(-2.0, 2.0, rng);
    const Pose local{radius * (sideways ? other : shift), radius * (sideways ? shift : other),
                     less * uniform(-2.0, 2.0, rng)};
    const Pose from{0, 0, uniform(-pi, pi, rng)};
    return DrawnPair{from, compose(from, local)};
  });
}

TEST(ReedsSheppBatch, EqualPosesAreAtNoDistance) {
  for (const double heading : {0.0, 1.0, pi / 2, -pi, 3.0}) {
    EXPECT_EQ(error({5, 6, heading}, {5, 6, heading}, 7.0), 0.0);
  }
}

TEST(ReedsSheppBatch, LengthsBelongToTheirNodes) {
  Rng rng(4);
  const Pose sample = uniform_pose({-50, 50, -50, 50}, rng);
  for (const std::size_t count : {0U, 1U, 3U, 100U}) {
    std::vector<float> x, y, heading, out(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Pose node = uniform_pose({-50, 50, -50, 50}, rng);
      x.push_back(static_cast<float>(node.x));
      y.push_back(static_cast<float>(node.y));
      heading.push_back(static_cast<float>(node.heading));
    }
    reeds_shepp_lengths({x, y, heading}, sample, 7.0, out);
    for (std::size_t i = 0; i < count; ++i) {
      const Pose node{static_cast<double>(x[i]), static_cast<double>(y[i]),
                      static_cast<double>(heading[i])};
      EXPECT_NEAR(static_cast<double>(out[i]), reeds_shepp_length(node, sample, 7.0), 1e-3);
    }
  }
}

// Also where there are no vectors; on every target of the machine: length_kernels_test.
TEST(ReedsSheppBatch, PairsHaveTheExactLengths) {
  Rng rng(5);
  for (const std::size_t count : {0U, 1U, 3U, 100U}) {
    std::vector<Pose> from, to;
    std::vector<double> out(count);
    for (std::size_t i = 0; i < count; ++i) {
      const DrawnPair pair = any_pair(7.0, rng);
      from.push_back(pair.from);
      to.push_back(pair.to);
    }
    reeds_shepp_lengths(from, to, 7.0, out);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(out[i], reeds_shepp_length(from[i], to[i], 7.0));
    }
    const Pose sample{1, 2, 3};
    reeds_shepp_lengths(from, {&sample, 1}, 7.0, out);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(out[i], reeds_shepp_length(from[i], sample, 7.0));
    }
  }
}

}  // namespace
}  // namespace vandplan
