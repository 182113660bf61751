// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <gtest/gtest.h>

#include <cmath>

#include "support/problems.h"
#include "vandplan/drive.h"
#include "vandplan/input_error.h"
#include "vandplan/motion.h"

namespace vandplan {
namespace {

constexpr double full = 1 / 7.0;  // [1/m]

ExecutableCheck check_of(const std::vector<Segment>& segments, Surroundings things = {}) {
  things.bounds = wide_bounds;
  const Path path{{1, 2, 0.5}, segments};
  return executable(problem_of_path(things, path), path);
}

TEST(Executable, ClothoidsAreDrivenAsTheyAre) {
  const double bend = full / 0.1;
  const ExecutableCheck check = check_of({{0, bend, 0.1},
                                          {full, 3},
                                          {full, bend, -0.1},
                                          {0, -bend, -0.1},
                                          {-full, -2},
                                          {-full, -bend, 0.1}});
  EXPECT_TRUE(check.flowing.passes) << check.flowing.reason;
  EXPECT_TRUE(check.pausing.passes) << check.pausing.reason;
  EXPECT_EQ(check.jumps, 0);
  EXPECT_LT(check.flowing.end_distance, 1e-4);
  EXPECT_LT(check.flowing.end_heading, 1e-4);
}

TEST(Executable, AJumpTakesAPause) {
  const std::vector<Segment> jump = {{0, 3}, {full, 5}};
  const ExecutableCheck check = check_of(jump);
  EXPECT_EQ(check.jumps, 1);
  EXPECT_TRUE(check.pausing.passes) << check.pausing.reason;
  EXPECT_FALSE(check.flowing.passes);
  EXPECT_EQ(check.flowing.reason.rfind("ends ", 0), 0U) << check.flowing.reason;
  // The wheels take that long, and the vehicle does not wait for them.
  EXPECT_NEAR(check.pausing.duration - check.flowing.duration, std::atan(4.5 / 7) / 0.5, 1e-6);
  EXPECT_NEAR(check.pausing.duration, speed_profile({{}, jump}, {}).duration, 1e-9);
}

TEST(Executable, AtGearChangesTheWheelsMayTurn) {
  const ExecutableCheck check = check_of({{full, 3}, {-full, -4}, {full, 1}});
  EXPECT_EQ(check.jumps, 0);
  EXPECT_TRUE(check.flowing.passes) << check.flowing.reason;
  EXPECT_EQ(check.flowing.duration, check.pausing.duration);
}

TEST(Executable, WhatIsTouchedIsSaid) {
  const Path path{{0, 0, 0}, {{0, 10}}};
  const Problem problem =
      problem_of_path({.bounds = wide_bounds, .obstacles = {box(12, -1, 13, 1)}}, path);
  const ExecutableCheck check = executable(problem, path);
  EXPECT_FALSE(check.flowing.passes);
  EXPECT_NE(check.flowing.reason.find(" s the footprint hits obstacles[0]"), std::string::npos)
      << check.flowing.reason;
  EXPECT_LT(check.flowing.end_distance, 1e-6);
}

TEST(Executable, LimitsAreRelaxedByAThousandth) {
  EXPECT_TRUE(check_of({{full * 1.0009, 5}}).flowing.passes);
  const ExecutableCheck tight = check_of({{full * 1.0011, 5}});
  EXPECT_FALSE(tight.flowing.passes);
  EXPECT_EQ(tight.flowing.reason,
            "curvature 0.143014 is tighter than the turning radius of 7 m allows");
}

TEST(Executable, RefusesWhatIsNotFinite) {
  EXPECT_THROW((void)check_of({{0, std::nan("")}}), InputError);
}

}  // namespace
}  // namespace vandplan
