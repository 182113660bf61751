// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which poses of a set of goals are tried?

#include <array>
#include <cstddef>
#include <vector>

#include "vandplan/problem.h"

namespace vandplan::planning {

/// Where in a region of goals a goal is: each number of 0 to 1 goes over one interval of the
/// region.
struct GoalPoint {
  std::size_t region = 0;         ///< its number in the set
  std::array<double, 4> at = {};  ///< x, y, heading, hitch angle
  bool is_turned = false;         ///< by half a turn: of regions that hold both
  bool operator==(const GoalPoint&) const = default;
};

/// Where the vehicle is at that goal; heading in [-pi, pi).
[[nodiscard]] Local<RigState> state_of(const Task& task, const GoalPoint& point);

/// How many intervals region number `region` has: of x, y, heading and hitch angle.
[[nodiscard]] std::size_t number_of_intervals(const Task& task, std::size_t region);

/// Hands goals of region number `region`, evenly spread over its intervals, to `take` until that
/// has said true of `most` of them. A region of one pose has one, and another one that is turned.
template <class Take>
void spread(const Task& task, std::size_t region, std::size_t most, Take take);

/// Goals beside another one of its region: forth and back along each interval, by that share of it.
[[nodiscard]] std::vector<GoalPoint> beside(const Task& task, const GoalPoint& point, double share);

/// Number `i` of a sequence of points that are evenly spread over a region, wherever it is cut off.
[[nodiscard]] GoalPoint point_of_sequence(const Task& task, std::size_t region, std::size_t i);

/// Whether a point is in the region; those of an area are spread over the box around it.
[[nodiscard]] bool is_in_region(const Task& task, const GoalPoint& point);

/// Numbers of points to look at before a region counts as having no more.
inline constexpr std::size_t most_looks = 4096;

template <class Take>
void spread(const Task& task, std::size_t region, std::size_t most, Take take) {
  const GoalRegion& of = task.goal_set[region];
  const std::size_t looks = is_continuous(of) ? most_looks : of.either_way ? 2 : 1;
  for (std::size_t i = 0, taken = 0; i < looks && taken < most; ++i) {
    const GoalPoint point = point_of_sequence(task, region, i);
    if (is_in_region(task, point) && take(point)) ++taken;
  }
}

/// No path from the start to a region of the set is shorter, whatever stands in the way [m]. Halves
/// parts of the region so often, at most 2000 times.
[[nodiscard]] double least_length_to(const Task& task, std::size_t region, std::size_t halvings);

}  // namespace vandplan::planning
