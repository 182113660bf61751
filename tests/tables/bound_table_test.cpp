// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/bound_table.h"
#include "vandplan/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "simd/bound_grid.h"
#include "support/bound_law.h"
#include "support/draws.h"
#include "tables/excess.h"
#include "vandplan/path.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;

TEST(BoundTable, HoldsTenMillionRandomPairs) { expect_all_inside(1, 10'000'000); }

TEST(BoundTable, HoldsInTheCornersOfItsCells) {
  Rng rng(3);
  const auto corner = [&rng](int cells) {
    const auto i = static_cast<double>(rng() % static_cast<unsigned>(cells + 1));
    // On the corner, or a few roundings of float beside it.
    const double beside = any_sign(std::pow(10.0, uniform(-9.0, -5.0, rng)), rng);
    return std::clamp(i / cells + (uniform01(rng) < 0.5 ? 0.0 : beside), 0.0, 1.0);
  };
  for (int i = 0; i < cases(1'000'000); ++i) {
    const double distance = tables::distance_at(std::min(corner(simd::radial_cells), 0.9999));
    const double bearing = tables::bearing_at(corner(simd::side_cells));
    const double half_turn = any_sign(corner(simd::turn_cells) * pi / 2, rng);
    const Pose from{0.0, 0.0, -half_turn};
    const Pose to{any_sign(distance * std::cos(bearing), rng),
                  any_sign(distance * std::sin(bearing), rng), half_turn};
    if (!expect_inside({from, to, 1.0})) return;
  }
}

// A path some of whose arcs have the lengths at which words meet ends where they meet.
TEST(BoundTable, HoldsOnTheBordersBetweenWords) {
  Rng rng(4);
  constexpr std::array<double, 8> special{0.0, 1e-12, 1e-7, pi / 3, pi / 2, pi, 2.0, 4.0};
  for (int i = 0; i < cases(1'000'000); ++i) {
    const double curvature = any_sign(1.0, rng);
    Pose to{0.0, 0.0, uniform(-pi, pi, rng)};
    const Pose from = to;
    double same = uniform(0.0, pi / 2, rng);
    for (int k = 0; k < 4; ++k) {
      const double draw = uniform01(rng);
      double length = same;  // arcs of equal length meet too
      if (draw < 0.5) length = special[rng() % special.size()];
      if (draw > 0.75) length = uniform(0.0, 3.0, rng);
      const double turn = k % 2 == 0 ? curvature : uniform01(rng) < 0.4 ? 0.0 : -curvature;
      to = advance(to, {turn, any_sign(length, rng)});
    }
    if (!expect_inside({from, to, 1.0})) return;
  }
}

TEST(BoundTable, HoldsWherePosesAlmostAgree) {
  Rng rng(5);
  const auto tiny = [&rng] {
    return uniform01(rng) < 0.1 ? 0.0 : any_sign(std::pow(10.0, uniform(-16.0, 0.0, rng)), rng);
  };
  for (int i = 0; i < cases(1'000'000); ++i) {
    const Pose from{0.0, 0.0, uniform(-pi, pi, rng)};
    if (!expect_inside({from, {tiny(), tiny(), from.heading + tiny()}, 7.0})) return;
  }
}

TEST(BoundTable, HoldsFarFromTheOrigin) {
  Rng rng(6);
  for (int i = 0; i < cases(100'000); ++i) {
    BoundCase c = any_bound_case(rng);
    for (Pose* pose : {&c.from, &c.to}) {
      pose->x += 8.7e9;
      pose->y -= 4.5e9;
    }
    if (!expect_inside(c)) return;
  }
}

TEST(BoundTable, BatchHoldsForItsFloats) {
  Rng rng(7);
  std::vector<float> x(1000), y(1000), heading(1000), low(1000), high(1000);
  for (int round = 0; round < cases(100); ++round) {
    const Bounds box{-50.0, 50.0, -50.0, 50.0};
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Pose pose = uniform_pose(box, rng);
      x[i] = static_cast<float>(pose.x);
      y[i] = static_cast<float>(pose.y);
      heading[i] = static_cast<float>(pose.heading);
    }
    Pose sample = uniform_pose(box, rng);
    for (double* value : {&sample.x, &sample.y, &sample.heading}) {
      *value = static_cast<double>(static_cast<float>(*value));
    }
    length_bounds({x, y, heading}, sample, 7.0, low, high);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Pose node{static_cast<double>(x[i]), static_cast<double>(y[i]),
                      static_cast<double>(heading[i])};
      const double length = reeds_shepp_length(node, sample, 7.0);
      ASSERT_LE(static_cast<double>(low[i]), length) << as_code(node) << as_code(sample);
      ASSERT_GE(static_cast<double>(high[i]), length) << as_code(node) << as_code(sample);
    }
  }
}

TEST(BoundTable, IsTight) {
  Rng rng(8);
  const auto widths = [&rng](double reach) {
    std::vector<double> width;
    for (int i = 0; i < cases(100'000); ++i) {
      const Pose pose = uniform_pose({-reach, reach, -reach, reach}, rng);
      const Pose sample{0.0, 0.0, uniform(-pi, pi, rng)};
      const auto [low, high] = length_bounds(pose, sample, 7.0);
      width.push_back((high - low) / 7.0);
    }
    std::ranges::sort(width);
    return width;
  };
  const std::vector<double> near = widths(10.0);
  EXPECT_LT(near[near.size() / 2], 0.005);
  EXPECT_LT(near[near.size() / 20 * 19], 0.05);
  const std::vector<double> far = widths(200.0);
  EXPECT_LT(far[far.size() / 2], 0.004);
  EXPECT_LT(far[far.size() / 20 * 19], 0.01);
}

TEST(BoundTable, KeepsItsSize) { EXPECT_LE(bound_table_info().bytes, 4U << 20U); }

}  // namespace
}  // namespace vandplan
