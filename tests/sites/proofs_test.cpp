// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Is it told which of many goals walls and zones part from a start, and only those?
#include "sites/proofs.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "support/problems.h"
#include "support/sites.h"

namespace vandplan {
namespace {

using namespace sites;

using Numbers = std::vector<std::size_t>;

constexpr Pose outside{-20, 0, 0};
constexpr Pose within{20, 0, 0};

/// A room around `within`, with a gate in the wall on the left.
Surroundings room_with_gate(double width) {
  return {.bounds = area,
          .obstacles = {box(8, 12, 34, 13), box(8, -13, 34, -12), box(33, -13, 34, 13),
                        box(8, width / 2, 9, 13), box(8, -13, 9, -width / 2)}};
}

Numbers unreachable(const Surroundings& ground, const Pose& start, const std::vector<Pose>& goals,
                    const PlanOptions& options = drivers_options()) {
  return unreachable_goals(problem_in(ground, start, goals.front()), start, goals, options);
}

TEST(UnreachableGoals, AreFoundAmongThoseThatCanBeReached) {
  const std::vector<Pose> goals = {{-30, 5, 1}, within, {0, 20, 2}, {25, 4, 0}};
  EXPECT_EQ(unreachable(room_with_gate(0), outside, goals), (Numbers{1, 3}));
  EXPECT_EQ(unreachable(room_with_gate(0), within, goals), (Numbers{0, 2}));
  EXPECT_EQ(unreachable(room_with_gate(0), within, {within}), Numbers{});
}

// The vehicle is 2.55 m wide, and its rear axle may come as near to walls as 0.9 m.
TEST(UnreachableGoals, LieBehindGatesThatAreNarrowerThanTheVehicle) {
  const std::vector<Pose> goals = {within, {-30, 5, 1}, {24, 2, 1}};
  EXPECT_EQ(unreachable(room_with_gate(2.4), outside, goals), (Numbers{0, 2}));
  EXPECT_EQ(unreachable(room_with_gate(2.7), outside, goals), Numbers{});
  PlanOptions wide = drivers_options();
  wide.clearance.margin = 0.2;
  EXPECT_EQ(unreachable(room_with_gate(2.7), outside, goals, wide), (Numbers{0, 2}));
}

TEST(UnreachableGoals, LieBehindZonesInWhichTheOtherGearIsDriven) {
  Surroundings ground = room_with_gate(8);
  ground.zones.push_back({.area = box(4, -8, 12, 8), .gears = AllowedGears::reverse});
  const std::vector<Pose> goals = {{-30, 5, 1}, within};
  EXPECT_EQ(unreachable(ground, outside, goals), Numbers{});
  PlanOptions forward = drivers_options();
  forward.cost.gears = AllowedGears::forward;
  EXPECT_EQ(unreachable(ground, outside, goals, forward), Numbers{1});
}

TEST(UnreachableGoals, LieBehindStreetsThatOnlyLeadAway) {
  Surroundings ground = room_with_gate(8);
  constexpr double pi = std::numbers::pi;
  ground.zones.push_back(
      {.area = box(4, -8, 12, 8), .direction = HeadingRange{pi - 0.4, pi + 0.4}});
  EXPECT_EQ(unreachable(ground, outside, {{-30, 5, 1}, within}), Numbers{1});
  EXPECT_EQ(unreachable(ground, within, {{-30, 5, 1}, {24, 2, 1}}), Numbers{});
}

}  // namespace
}  // namespace vandplan
