// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Where the curvature may jump, and what is driven before the start and after the goal.
#include "search/wheels.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "../support/problems.h"
#include "planners/commands/wheels.h"

namespace vandplan {
namespace {

using search::Driven, search::DrivenBeside;

constexpr std::array all_kinds = {Steering::reeds_shepp, Steering::continuous_between_stops,
                                  Steering::continuous};

Problem turned_wheels() {
  return make_problem(world_of({.bounds = wide_bounds}), {}, {0, 0, 0}, {30, 3, 0}, {0.1, -0.05});
}

// Nothing is known of the wheels where the vehicle has not driven, nor before a gear that is given.
TEST(MayJump, IsWhereTheVehicleStands) {
  for (const int next : {1, -1}) {
    const std::vector<Driven> standing = {{}, {0, 0.1}, {-next, 0.1}, {-next}, {next}};
    const Driven rolling{next, 0.1};
    for (const Driven& before : standing) {
      EXPECT_TRUE(may_jump(Steering::reeds_shepp, before, next));
      EXPECT_TRUE(may_jump(Steering::continuous_between_stops, before, next)) << before.gear;
      EXPECT_FALSE(may_jump(Steering::continuous, before, next));
    }
    EXPECT_TRUE(may_jump(Steering::reeds_shepp, rolling, next));
    EXPECT_FALSE(may_jump(Steering::continuous_between_stops, rolling, next));
    EXPECT_FALSE(may_jump(Steering::continuous, rolling, next));
  }
}

TEST(MayJump, IsTheSameForPiecesAndForCommands) {
  const Problem problem = turned_wheels();
  for (const Steering steering : all_kinds) {
    const Task task = task_of(problem, {}, steering);
    const search::Connector connector(task);
    const commands::Wheels wheels(task.vehicle, steering);
    for (const int gear : {-1, 0, 1}) {
      for (const double curvature : {0.0, 0.1, Driven::any}) {
        for (const int next : {1, -1}) {
          const Driven before{gear, curvature};
          EXPECT_EQ(connector.may_jump(before, next), wheels.may_jump(before, next));
        }
      }
    }
  }
}

TEST(DrivenAtEnds, AreWhatTheTaskSays) {
  const Problem problem = turned_wheels();
  for (const Steering steering : all_kinds) {
    const DrivenBeside ends = search::driven_at_ends(task_of(problem, {}, steering), -1);
    EXPECT_EQ(ends.before.gear, -1);
    EXPECT_EQ(ends.after.gear, 0);
    const bool is_known = steering == Steering::continuous;
    EXPECT_EQ(ends.before.is_known(), is_known);
    EXPECT_EQ(ends.after.is_known(), is_known);
    if (!is_known) continue;
    EXPECT_EQ(ends.before.curvature, 0.1);
    EXPECT_EQ(ends.after.curvature, -0.05);
  }
}

}  // namespace
}  // namespace vandplan
