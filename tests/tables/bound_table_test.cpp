// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/random.h"
#include "vandplan/tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "simd/bound_grid.h"
#include "simd/bound_kernels.h"
#include "support/bound_law.h"
#include "support/draws.h"
#include "tables/bound_builder.h"
#include "tables/excess.h"
#include "vandplan/path.h"

namespace vandplan {
namespace {

using std::numbers::pi;

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

// Where a formula loses its meaning or two of them meet: circles that coincide, or are 2, sqrt(8),
// 4 or sqrt(20) radii apart; poses that agree or are 2 or 4 radii apart; turns of nothing and of
// pi.
BoundCase degenerate_case(Rng& rng) {
  const auto beside = [&rng](double value) {
    return uniform01(rng) < 0.3 ? value : value + any_sign(any_size(1e-16, 1e-1, rng), rng);
  };
  constexpr std::array<double, 7> apart{0.0, 2.0, 4.0, 2.0 * std::numbers::sqrt2, 4.47213595499958,
                                        1.0, 6.0};
  const auto any_turn = [&rng] {
    const double draw = uniform01(rng);
    return draw < 0.2 ? 0.0 : draw < 0.4 ? pi : uniform(0.0, pi, rng);
  };
  const double half = beside(any_turn()) / 2;
  const double distance = beside(apart[rng() % apart.size()]);
  const double bearing =
      uniform01(rng) < 0.3 ? beside(any_sign(pi / 4, rng) + pi / 4) : uniform(-pi, pi, rng);
  // From the centre of the poses, or of one of their circles to one of the other's.
  const auto kind = rng() % 3;
  const double x = kind == 1 ? any_sign(2 * std::sin(half), rng) : 0.0;
  const double y = kind == 2 ? any_sign(2 * std::cos(half), rng) : 0.0;
  return {{0.0, 0.0, -half},
          {x + distance * std::cos(bearing), y + distance * std::sin(bearing), half},
          1.0};
}

TEST(BoundTable, HoldsAroundDegeneratePlaces) {
  Rng rng(9);
  for (int i = 0; i < cases(2'000'000); ++i) {
    if (!expect_inside(degenerate_case(rng))) return;
  }
}

/// A pair in float as the look-up takes it: a cell border or any place along each coordinate, a
/// millionth to a billionth beside it, from 1e-9 to 1e6 radii, with headings where the mean turns
/// round.
struct FloatPair {
  float dx, dy, heading_node, heading_sample, radius;
};

FloatPair any_float_pair(Rng& rng) {
  const auto coordinate = [&rng](int cells) {
    if (uniform01(rng) < 0.5) return uniform01(rng);
    const auto border = static_cast<double>(rng() % static_cast<unsigned>(cells + 1)) / cells;
    const double beside = any_sign(any_size(1e-9, 1e-6, rng), rng);
    return std::clamp(border + (uniform01(rng) < 0.3 ? 0.0 : beside), 0.0, 1.0);
  };
  const double radius = any_size(0.1, 100.0, rng);
  const double distance =
      uniform01(rng) < 0.5
          ? any_size(1e-9, 1e6, rng)
          : tables::distance_at(std::min(coordinate(simd::radial_cells), 1 - 1e-6));
  const double bearing = any_sign(tables::bearing_at(coordinate(simd::side_cells)), rng) +
                         (uniform01(rng) < 0.5 ? pi : 0.0);
  const double half = any_sign(coordinate(simd::turn_cells) * pi / 2, rng);
  constexpr std::array<double, 5> special{0.0, pi / 4, pi / 2, 3 * pi / 4, pi};
  const double mean =
      uniform01(rng) < 0.5 ? uniform(-pi, pi, rng) : any_sign(special[rng() % special.size()], rng);
  const auto in_float = [](double value) { return static_cast<float>(value); };
  return {in_float(radius * distance * std::cos(mean + bearing)),
          in_float(radius * distance * std::sin(mean + bearing)), in_float(wrap_angle(mean - half)),
          in_float(wrap_angle(mean + half)), in_float(radius)};
}

/// The coordinates of a pair and its distance [turning radii] in extended precision.
struct PrecisePair {
  long double distance;
  std::array<long double, 3> coordinates;

  explicit PrecisePair(const FloatPair& p) {
    constexpr long double pi_l = std::numbers::pi_v<long double>;
    const long double dx = p.dx, dy = p.dy, h0 = p.heading_node, h1 = p.heading_sample;
    const long double mean = (h0 + h1) / 2;
    const long double along = std::abs(dx * std::cos(mean) + dy * std::sin(mean));
    const long double across = std::abs(dy * std::cos(mean) - dx * std::sin(mean));
    const long double turn = std::abs(h0 - h1);
    const long double sum = along + across;
    distance = std::hypot(dx, dy) / static_cast<long double>(p.radius);
    coordinates = {distance / (distance + static_cast<long double>(simd::radial_reach)),
                   sum > 0 ? across / sum : 0, std::abs(std::min(turn, 2 * pi_l - turn)) / pi_l};
  }
};

/// A table whose planes are all the same one, which rises along one coordinate by `slope` units
/// across each cell, with nothing between low and high.
std::vector<simd::BoundEntry> one_plane(std::size_t along, int slope) {
  std::vector<simd::BoundEntry> entries;
  const int step = along == 2 ? 1 : simd::slope_step;
  const std::array<unsigned, 3> place{21, 10, 0};
  for (int i = 0; i < simd::bound_cells; ++i) {
    const std::array<int, 3> cell{i / simd::turn_cells / simd::side_cells,
                                  i / simd::turn_cells % simd::side_cells, i % simd::turn_cells};
    entries.push_back({static_cast<std::uint32_t>(cell[along] * slope * step) << 16,
                       static_cast<std::uint32_t>(slope) << place[along]});
  }
  return entries;
}

// Planes that join, so that no border hides an error, and are as steep as the length can be: 4
// along side and pi along turn; along radial, where an error shrinks with distance, as steep as
// entries can say.
TEST(BoundTable, LooksUpWithinItsMargin) {
  constexpr std::array<int, 3> slopes{127, 255, 511};
  constexpr std::array<int, 3> cells{simd::radial_cells, simd::side_cells, simd::turn_cells};
  for (std::size_t along = 0; along < 3; ++along) {
    const std::vector<simd::BoundEntry> entries = one_plane(along, slopes[along]);
    const double rise = slopes[along] * cells[along] * (along == 2 ? 1 : simd::slope_step) *
                        simd::bound_unit;  // [turning radii]
    Rng rng(10 + along);
    double worst = 0.0;
    for (int i = 0; i < cases(1'000'000); ++i) {
      const FloatPair p = any_float_pair(rng);
      const auto [low, high] = simd::length_bounds(entries.data(), p.dx, p.dy, p.heading_node,
                                                   p.heading_sample, p.radius);
      const PrecisePair precise(p);
      const long double excess = static_cast<long double>(rise) * precise.coordinates[along];
      const long double length = precise.distance + excess;
      const auto radius = static_cast<long double>(p.radius);
      worst =
          std::max(worst, static_cast<double>(length - static_cast<long double>(high) / radius));
      if (length < precise.coordinates[2] * std::numbers::pi_v<long double>) continue;  // low: turn
      worst = std::max(worst, static_cast<double>(static_cast<long double>(low) / radius - length));
    }
    RecordProperty("worst_along_" + std::to_string(along), as_code(worst));
    EXPECT_LT(worst, tables::look_up_rounding) << "along " << along;
    const double least = along == 0 ? 0.0 : tables::look_up_rounding / 20;
    EXPECT_GE(worst, least) << "along " << along;  // along radial the part of the distance hides it
  }
}

// What docs/proofs/bound_table.md argues with: how much the length can change.
TEST(BoundTable, LengthsChangeNoFasterThanRoundingIsArguedWith) {
  Rng rng(13);
  for (int i = 0; i < cases(300'000); ++i) {
    const auto [from, to, radius] =
        uniform01(rng) < 0.5 ? degenerate_case(rng) : any_bound_case(rng);
    const auto scaled = [from = from, to = to, radius = radius](double scale) {
      const Pose there{scale * (to.x - from.x), scale * (to.y - from.y), to.heading};
      return reeds_shepp_length({0, 0, from.heading}, there, radius) / radius;
    };
    SCOPED_TRACE(as_code(from) + as_code(to) + as_code(radius));
    const double length = scaled(1.0);
    const double distance = std::hypot(to.x - from.x, to.y - from.y) / radius;
    const double none = 1e-9 * (1 + length);
    const double turn = any_sign(any_size(1e-9, 1.0, rng), rng);  // (1)
    const double turned =
        reeds_shepp_length(from, {to.x, to.y, to.heading + turn}, radius) / radius;
    ASSERT_LE(std::abs(turned - length), std::abs(turn) + none);
    const double scale = 1 + any_size(1e-9, 3.0, rng);  // (2)
    const double stretched = scaled(scale);
    ASSERT_GE(stretched, length - none);
    ASSERT_LE(stretched, scale * length + none);
    if (distance > 6.5) {  // (3)
      const double change = stretched - scale * distance - (length - distance);
      ASSERT_LE(change, none);
      ASSERT_GE(change, -4 * (1 / distance - 1 / (scale * distance)) - none);
    }
    ASSERT_LT(length - distance, 3.2);  // (5)
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
