// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "vandplan/input_error.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"

namespace vandplan {
namespace {

using std::numbers::pi;

// A table whose entries are their own positions: a look-up shows which cell it read.
HeuristicTable numbered_table(const HeuristicTableOptions& options) {
  const HeuristicTable shape(options);
  std::vector<float> entries(shape.entries().size());
  for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = static_cast<float>(i);
  return {options, entries};
}

TEST(HeuristicTable, HoldsAsManyEntriesAsTheThesisSays) {
  EXPECT_EQ(thesis_table(1).entries().size(), 11U * 11U * 9U * 9U);
  EXPECT_EQ(thesis_table(2).entries().size(), 21U * 21U * 9U * 9U);
  EXPECT_EQ(thesis_table(3).entries().size(), 11U * 11U * 25U * 25U);
  EXPECT_EQ(thesis_table(4).entries().size(), 600'625U);
}

TEST(HeuristicTable, EmbeddedTablesAreTheOnesThatWouldBeBuilt) {
  for (int number = 1; number <= 4; ++number) {
    const HeuristicTable built(thesis_table_options(number));
    EXPECT_TRUE(std::ranges::equal(thesis_table(number).entries(), built.entries())) << number;
  }
}

TEST(HeuristicTable, EveryEntryIsTheReedsSheppLengthOfItsGridPoint) {
  const HeuristicTable table = thesis_table(3);
  for (int x = 0; x < table.positions(); ++x) {
    for (int y = 0; y < table.positions(); ++y) {
      for (int node = 0; node < table.headings(); ++node) {
        for (int sample = 0; sample < table.headings(); ++sample) {
          const Pose from{1.0 * x, 1.0 * y, -pi + node * pi / 12};
          const Pose to{0.0, 0.0, -pi + sample * pi / 12};
          const auto length = static_cast<float>(reeds_shepp_length(from, to, 7.0));
          ASSERT_FLOAT_EQ(table.entries()[table.index_of({x, y, node, sample})], length)
              << x << ' ' << y << ' ' << node << ' ' << sample;
        }
      }
    }
  }
}

// Beside the grid heading -pi + index * pi / 6, inside [-pi, pi).
double near_grid_heading(int index) { return -pi + index * pi / 6 + (index < 12 ? 0.2 : -0.2); }

TEST(HeuristicTable, LookUpReadsTheCellThatFillWrote) {
  const HeuristicTableOptions options{
      .extent = 6.0, .step = 1.5, .heading_cells = 12, .turning_radius = 7.0};
  const HeuristicTable table = numbered_table(options);
  for (int x = 0; x + 1 < table.positions(); ++x) {
    for (int y = 0; y + 1 < table.positions(); ++y) {
      for (int node = 0; node < table.headings(); ++node) {
        for (int sample = 0; sample < table.headings(); ++sample) {
          const Pose from{1.5 * x + 1.4, 1.5 * y + 0.1, near_grid_heading(node)};
          const Pose to{0.0, 0.0, near_grid_heading(sample)};
          ASSERT_EQ(table.distance(from, to, 7.0),
                    static_cast<double>(table.index_of({x, y, node, sample})));
        }
      }
    }
  }
}

TEST(HeuristicTable, TheIndexMeetsEveryEntryOnceInOrder) {
  const HeuristicTable table = thesis_table(4);
  std::size_t next = 0;
  for (int x = 0; x < table.positions(); ++x) {
    for (int y = 0; y < table.positions(); ++y) {
      for (int node = 0; node < table.headings(); ++node) {
        for (int sample = 0; sample < table.headings(); ++sample) {
          ASSERT_EQ(table.index_of({x, y, node, sample}), next++);
        }
      }
    }
  }
  EXPECT_EQ(next, table.entries().size());
}

TEST(HeuristicTable, FoldsTheNodeIntoTheFirstQuadrant) {
  const HeuristicTable table = thesis_table(4);
  const Pose sample{100.0, -50.0, 0.3};
  const double first = table.distance({105.5, -42.5, 1.0}, sample, 7.0);
  EXPECT_EQ(table.distance({105.5, -57.5, -1.0}, {100.0, -50.0, -0.3}, 7.0), first);
  EXPECT_EQ(table.distance({94.5, -42.5, pi - 1.0}, {100.0, -50.0, pi - 0.3}, 7.0), first);
  EXPECT_EQ(table.distance({94.5, -57.5, 1.0 - pi}, {100.0, -50.0, 0.3 - pi}, 7.0), first);
  const HeuristicTable::GridPoint cell{5, 7, 16, 13};  // 1.0 and 0.3 rad in steps of pi/12 from -pi
  EXPECT_EQ(first, static_cast<double>(table.entries()[table.index_of(cell)]));
}

TEST(HeuristicTable, AnswersEuclidFromTheEdgeOfTheWindowOn) {
  const HeuristicTable table = numbered_table(thesis_table_options(1));
  const Pose sample{0.0, 0.0, 0.0};
  EXPECT_EQ(table.distance({10.0, 0.0, 0.5}, sample, 7.0), 10.0);
  EXPECT_EQ(table.distance({3.0, -10.0, 0.5}, sample, 7.0), static_cast<double>(std::sqrt(109.0F)));
  EXPECT_EQ(table.distance({-30.0, 40.0, 0.5}, sample, 7.0), 50.0);
  EXPECT_NE(table.distance({9.999, 9.999, 0.5}, sample, 7.0), std::hypot(9.999, 9.999));
}

TEST(HeuristicTable, ScalesWithTheTurningRadius) {
  const HeuristicTable table = thesis_table(4);
  const Pose node{8.5, -3.5, 2.0};
  const Pose sample{1.0, 1.0, -0.4};
  const Pose half_node{4.25, -1.75, 2.0};
  const Pose half_sample{0.5, 0.5, -0.4};
  EXPECT_EQ(table.distance(half_node, half_sample, 3.5), table.distance(node, sample, 7.0) / 2);
}

TEST(HeuristicTable, BatchGivesWhatSingleLookUpsGive) {
  const HeuristicTable table = thesis_table(4);
  Rng rng(7);
  const Bounds box{-40.0, 40.0, -40.0, 40.0};
  std::vector<float> x, y, heading;
  for (int i = 0; i < 1000; ++i) {
    const Pose pose = uniform_pose(box, rng);
    x.push_back(static_cast<float>(pose.x));
    y.push_back(static_cast<float>(pose.y));
    heading.push_back(static_cast<float>(pose.heading));
  }
  std::vector<float> lengths(x.size());
  const Pose sample{1.0, -2.0, 0.7};
  table.distances({x, y, heading}, sample, 5.5, lengths);
  for (std::size_t i = 0; i < x.size(); ++i) {
    // x - 1 and y + 2 of such floats may round; the batch takes the difference in float.
    const Pose node{static_cast<double>(x[i] - 1.0F), static_cast<double>(y[i] + 2.0F),
                    static_cast<double>(heading[i])};
    ASSERT_EQ(static_cast<double>(lengths[i]), table.distance(node, {0.0, 0.0, 0.7}, 5.5)) << i;
  }
}

TEST(HeuristicTable, CopiesOutliveTheTableTheyCameFrom) {
  HeuristicTable copy = thesis_table(1);
  {
    const HeuristicTable table({.extent = 2.0, .step = 1.0, .heading_cells = 4});
    copy = table;
  }
  const auto straight = copy.index_of({2, 0, 2, 2});  // two metres ahead, both headings 0
  EXPECT_FLOAT_EQ(copy.entries()[straight], 2.0F);
}

TEST(HeuristicTable, RefusesOptionsOutOfRange) {
  const auto build = [](const HeuristicTableOptions& options) { HeuristicTable{options}; };
  EXPECT_THROW(build({.extent = 0.0}), InputError);
  EXPECT_THROW(build({.extent = std::nan("")}), InputError);
  EXPECT_THROW(build({.step = -1.0}), InputError);
  EXPECT_THROW(build({.extent = 10.0, .step = 3.0}), InputError);
  EXPECT_THROW(build({.heading_cells = 0}), InputError);
  EXPECT_THROW(build({.turning_radius = 0.0}), InputError);
  EXPECT_THROW(build({.extent = 1e6, .step = 1e-3}), InputError);
}

TEST(HeuristicTable, RefusesEntriesThatDoNotFitTheOptions) {
  EXPECT_THROW((HeuristicTable{thesis_table_options(1), std::vector<float>(10)}), InputError);
}

// ---- what is no number ----

TEST(HeuristicTable, NumbersThatAreNoneReadNothingOutsideOfTheTable) {
  const HeuristicTable table = numbered_table({.extent = 2.0, .step = 1.0, .heading_cells = 4});
  const double nan = std::nan("");
  const double infinity = HUGE_VAL;
  const auto last = static_cast<double>(table.entries().size() - 1);
  for (const double heading : {nan, -nan, infinity, 1e30}) {
    const double length = table.distance({1, 1, heading}, {0, 0, heading}, 7.0);
    EXPECT_TRUE(length >= 0.0 && length <= last) << length;
  }
  EXPECT_TRUE(std::isnan(table.distance({nan, 1, 0}, {0, 0, 0}, 7.0)));
  EXPECT_TRUE(std::isnan(table.distance({1, nan, 0}, {0, 0, 0}, 7.0)));
  for (const double radius : {1e-300, 1e300}) {
    (void)table.distance({0, 0, 1}, {0, 0, 2}, radius);
    (void)table.distance({1, 1, 1}, {0, 0, 2}, radius);
  }
  for (const double radius : {0.0, nan, -7.0, infinity}) {
    EXPECT_THROW((void)table.distance({1, 1, 1}, {0, 0, 2}, radius), InputError) << radius;
  }
}

TEST(HeuristicTable, NumbersThatAreNoneReadNothingOutsideInBatches) {
  const HeuristicTable table = numbered_table({.extent = 2.0, .step = 1.0, .heading_cells = 4});
  const float nan = std::nanf("");
  const std::vector<float> x(19, 1.0F);
  for (const float odd : {nan, -nan, HUGE_VALF, 1e30F, -1e30F}) {
    std::vector<float> some = x;
    for (std::size_t i = 0; i < some.size(); i += 2) some[i] = odd;
    std::vector<float> out(x.size());
    table.distances({x, x, some}, {0, 0, 1}, 7.0, out);
    for (const float length : out) {
      EXPECT_TRUE(length >= 0.0F && length <= static_cast<float>(table.entries().size() - 1));
    }
    table.distances({some, x, x}, {0, 0, 1}, 7.0, out);
    EXPECT_FALSE(out[0] <= 3.0F);
    EXPECT_LE(out[1], static_cast<float>(table.entries().size() - 1));
    table.distances({x, x, x}, {0, 0, static_cast<double>(odd)}, 7.0, out);
    const auto radius = static_cast<double>(odd);
    if (radius > 0.0 && std::isfinite(radius)) {
      table.distances({x, x, x}, {0, 0, 1}, radius, out);
    } else {
      EXPECT_THROW(table.distances({x, x, x}, {0, 0, 1}, radius, out), InputError) << radius;
    }
    table.distances({some, some, some}, {0, 0, 1}, 1e-300, out);
  }
}

TEST(LengthBounds, NumbersThatAreNoneReadNothingOutsideOfTheTable) {
  const double nan = std::nan("");
  for (const double odd : {nan, -nan, HUGE_VAL, 1e30, -1e30}) {
    (void)length_bounds({odd, 1, 0}, {0, 0, 0}, 7.0);
    (void)length_bounds({1, 1, odd}, {0, 0, 0}, 7.0);
    std::vector<float> x(19, 1.0F);
    std::vector<float> some = x;
    some[3] = static_cast<float>(odd);
    std::vector<float> low(x.size()), high(x.size());
    length_bounds({some, x, x}, {0, 0, 1}, 7.0, low, high);
    EXPECT_LT(high[0], 40.0F);
    EXPECT_FALSE(high[3] < 40.0F);
    length_bounds({x, x, some}, {0, 0, 1}, 7.0, low, high);
    if (odd > 0.0 && std::isfinite(odd)) {
      (void)length_bounds({1, 1, 0}, {0, 0, 0}, odd);
      length_bounds({x, x, x}, {0, 0, 1}, odd, low, high);
    } else {
      EXPECT_THROW((void)length_bounds({1, 1, 0}, {0, 0, 0}, odd), InputError) << odd;
      EXPECT_THROW(length_bounds({x, x, x}, {0, 0, 1}, odd, low, high), InputError) << odd;
    }
  }
  EXPECT_TRUE(std::isnan(length_bounds({nan, 1, 0}, {0, 0, 0}, 7.0).high));
}

TEST(HeuristicTable, LengthsHaveRanges) {
  for (const double length : {1e200, 1e7, 1e-7, HUGE_VAL}) {
    EXPECT_THROW(HeuristicTable({.turning_radius = length}), InputError) << length;
    EXPECT_THROW(HeuristicTable({.extent = length, .step = length}), InputError) << length;
  }
}

}  // namespace
}  // namespace vandplan
