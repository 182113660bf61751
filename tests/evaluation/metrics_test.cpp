// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/metrics.h"

#include <gtest/gtest.h>

#include "vandplan/input_error.h"

namespace vandplan::evaluation {
namespace {

constexpr double left = 1.0 / 7.0;

TEST(PathMetrics, CanBeCheckedWithAPencil) {
  // 7 m left = 1 rad, 10 m back straight, 3.5 m back right = 0.5 rad, 4 m ahead still right.
  const Path path{{1.0, 2.0, 3.0}, {{left, 7.0}, {0.0, -10.0}, {-left, -3.5}, {-left, 4.0}}};
  const PathMetrics metrics = metrics_of(path, {.speed = 2.0, .pause = 3.0});
  EXPECT_DOUBLE_EQ(metrics.length, 24.5);
  EXPECT_EQ(metrics.gear_changes, 2);
  EXPECT_DOUBLE_EQ(metrics.reverse_share, 13.5 / 24.5);
  EXPECT_DOUBLE_EQ(metrics.turning, 1.0 + 0.5 + 4.0 / 7.0);
  EXPECT_EQ(metrics.curvature_changes, 2);  // the wheel stays at the last gear change
  EXPECT_DOUBLE_EQ(metrics.driving_time, 24.5 / 2.0 + 2 * 3.0);
}

TEST(PathMetrics, OfClothoidsCanBeCheckedWithAPencil) {
  // To the left within 2 m, then 1 m so, over to the right in reverse within 4 m, 1 m so.
  const double full = 0.2;
  const Path path{{}, {{0.0, 2.0, full / 2}, {full, 1.0}, {full, -4.0, -full / 2}, {-full, -1.0}}};
  const PathMetrics metrics = metrics_of(path, {});
  EXPECT_DOUBLE_EQ(metrics.turning, 0.2 + 0.2 + 2 * 0.2 + 0.2);
  EXPECT_EQ(metrics.curvature_changes, 2);  // as often as the wheel is turned
  const Path with_jump{{}, {{0.0, 2.0, full / 2}, {0.1, 1.0}}};
  EXPECT_EQ(metrics_of(with_jump, {}).curvature_changes, 2);
}

TEST(PathMetrics, DoNotDependOnHowAPathIsCut) {
  const Path whole{{}, {{left, 7.0}, {0.0, -10.0}}};
  const Path cut{{}, {{left, 3.0}, {left, 4.0}, {0.0, 0.0}, {0.0, -4.0}, {0.0, -6.0}}};
  EXPECT_EQ(metrics_of(cut, {}).curvature_changes, metrics_of(whole, {}).curvature_changes);
  EXPECT_EQ(metrics_of(cut, {}).driving_time, metrics_of(whole, {}).driving_time);
}

TEST(PathMetrics, OfAPathThatGoesNowhereAreZero) {
  const PathMetrics metrics = metrics_of({}, {});
  EXPECT_EQ(metrics.length, 0.0);
  EXPECT_EQ(metrics.reverse_share, 0.0);
  EXPECT_EQ(metrics.driving_time, 0.0);
}

TEST(PathMetrics, NeedASpeed) {
  EXPECT_THROW(static_cast<void>(metrics_of({}, {.speed = 0.0})), InputError);
  EXPECT_THROW(static_cast<void>(metrics_of({}, {.pause = -1.0})), InputError);
}

}  // namespace
}  // namespace vandplan::evaluation
