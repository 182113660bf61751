// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "tables/rig_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/cases.h"
#include "support/draws.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"
#include "vandplan/steering.h"
#include "vandplan/tables.h"

namespace vandplan {
namespace {

using std::numbers::pi;

Vehicle rig() {
  Vehicle vehicle;
  vehicle.hitch = 0.5;
  vehicle.trailer = Trailer{};
  return vehicle;
}

constexpr RigTableOptions small{.reach = 20, .cells = 4, .headings = 8, .hitch_angles = 3};

TEST(RigTable, AnEntryIsTheLengthBetweenTheMiddlesOfItsCell) {
  const RigTable table(rig(), small);
  EXPECT_EQ(table.entries().size(), 8u * 4 * 8 * 3 * 3);
  const RigSteering steering(rig());
  const double wide = 0.8 * rig().max_hitch_angle;
  // Cell (5, 2): from 5 to 10 m ahead, 10 to 15 m to the left.
  const State from{{0, 0, 0}, wide};
  const State to{{7.5, 12.5, pi / 4}, -wide};
  EXPECT_NEAR(table.distance(from, to), steering.steer(from, to)->length, 0.0501);
  EXPECT_EQ(table.distance(from, {{5.01, 14.9, pi / 4 + 0.39}, -wide + 0.3}),
            table.distance(from, to));
  EXPECT_NE(table.distance(from, {{4.99, 14.9, pi / 4}, -wide}), table.distance(from, to));
}

TEST(RigTable, SeesWhatIsMovedTurnedAndMirroredAlike) {
  const RigTable table(rig(), small);
  for_each_case(3, 2000, [&](Rng& rng) {
    const State from{{}, uniform(-1.2, 1.2, rng)};
    const State to{uniform_pose({-30, 30, 0.001, 30}, rng), uniform(-1.2, 1.2, rng)};
    const double length = table.distance(from, to);
    const Pose frame = uniform_pose({-100, 100, -100, 100}, rng);
    // A pose on the border between two cells may be rounded into either.
    const State moved{compose(frame, to.pose), to.hitch_angle};
    const double again = table.distance({frame, from.hitch_angle}, moved);
    const Pose back = relative(frame, moved.pose);
    EXPECT_EQ(again, table.distance(from, {back, to.hitch_angle}));
    const Pose mirrored{to.pose.x, -to.pose.y, -to.pose.heading};
    EXPECT_EQ(table.distance({{}, -from.hitch_angle}, {mirrored, -to.hitch_angle}), length);
  });
}

TEST(RigTable, BeyondItsReachTheRestIsStraight) {
  const RigTable table(rig(), small);
  const State from{};
  const double last = table.distance(from, {{19.9, 10.1, 0}, 0});
  EXPECT_NEAR(table.distance(from, {{60, 30.3, 0}, 0}), last + std::hypot(40, 20.2), 1e-9);
  EXPECT_TRUE(std::isfinite(table.distance(from, {{-1e6, -1e6, 3}, 0.5})));
}

TEST(RigTable, IsTheSameOnAnyNumberOfThreads) {
  const RigTable one(rig(), small);
  const RigTable three(rig(), small, 3);
  EXPECT_TRUE(std::ranges::equal(one.entries(), three.entries()));
}

TEST(RigTable, ScalesWithTheRig) {
  const RigTable table(rig(), small);
  const RigTable twice = table.scaled(2.0);
  const State from{{1, 2, 0.3}, 0.2}, to{{9, -4, 2}, -0.4};
  const State far_from{{2, 4, 0.3}, 0.2}, far_to{{18, -8, 2}, -0.4};
  EXPECT_EQ(twice.distance(far_from, far_to), 2 * table.distance(from, to));
}

TEST(RigTable, TheEmbeddedOneGuessesLengthsOfItsRig) {
  const Vehicle vehicle = vehicle_named("tractor-semitrailer");
  const RigTable table = embedded_rig_table(vehicle);
  EXPECT_EQ(table.unit(), 0.1);
  EXPECT_EQ(table.options(), RigTableOptions{});
  const RigSteering steering(vehicle);
  // The middles of cells: whatever of the rig differs changes the lengths.
  for_each_case(4, 300, [&](Rng& rng) {
    const auto any = [&](int count) { return static_cast<int>(uniform(0, count, rng)); };
    const double angles[] = {-0.96, -0.24, 0.0, 0.24, 0.96};
    const State from{{}, angles[any(5)]};
    const State to{{2.5 * any(24) - 28.75, 2.5 * any(12) + 1.25, any(24) * pi / 12},
                   angles[any(5)]};
    EXPECT_NEAR(table.distance(from, to), steering.steer(from, to)->length, 0.0501);
  });
}

TEST(RigLengthBound, IsNeverAboveALength) {
  int by_trailer = 0;
  for_each_case(5, 1000, [&](Rng& rng) {
    Vehicle vehicle = rig();
    vehicle.hitch = uniform(-2, 1, rng);
    vehicle.max_hitch_angle = uniform(0.5, 1.5, rng);
    vehicle.trailer->wheelbase = uniform(3, 12, rng);
    const double most = vehicle.max_hitch_angle, reach = any_size(1, 60, rng);
    const State from{uniform_pose({-reach, reach, -reach, reach}, rng), uniform(-most, most, rng)};
    const State to{uniform_pose({-reach, reach, -reach, reach}, rng), uniform(-most, most, rng)};
    const double bound = rig_length_bound(vehicle, from, to);
    const auto piece = RigSteering(vehicle).steer(from, to);
    ASSERT_TRUE(piece);
    EXPECT_LE(bound, piece->length + 1e-9);
    const double of_tractor = length_bounds(from.pose, to.pose, vehicle.min_turning_radius).low;
    EXPECT_GE(bound, of_tractor);
    by_trailer += bound > of_tractor ? 1 : 0;
  });
  EXPECT_GT(by_trailer, cases(1000) / 10);
  // As good as exact on a line.
  EXPECT_NEAR(rig_length_bound(rig(), {}, {{40, 0, 0}, 0}), 40, 0.1);
}

TEST(RigTable, RefusesWhatIsOutOfRange) {
  const auto refusal = [](const RigTableOptions& options) {
    try {
      const RigTable table(rig(), options);
    } catch (const InputError& error) {
      return error.where() + " " + error.problem();
    }
    return std::string();
  };
  EXPECT_EQ(refusal({.reach = NAN}), "reach is nan, expected 0.001 to 1000000 m");
  EXPECT_EQ(refusal({.cells = 0}), "cells is 0, expected 1 to 100");
  EXPECT_EQ(refusal({.headings = 361}), "headings is 361, expected 1 to 360");
  EXPECT_EQ(refusal({.hitch_angles = 4}), "hitch_angles is 4, expected an odd number, 1 to 25");
  EXPECT_THROW(RigTable(Vehicle{}, small), InputError);
}

}  // namespace
}  // namespace vandplan
