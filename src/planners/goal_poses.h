// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which poses of a set of goals are tried?

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "steering/words.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// A goal in a region: each number from 0 to 1 is a place in one interval of the region.
struct GoalPoint {
  std::size_t region = 0;         ///< index of the region in the set
  std::array<double, 4> at = {};  ///< 0 to 1 in the intervals of x, y, heading, hitch angle
  bool is_turned = false;         ///< whether the heading has half a turn more
  bool is_backed_into = false;    ///< whether the straight last stretch is driven in reverse
  bool operator==(const GoalPoint&) const = default;
};

/// State of the vehicle at a goal, in the world's frame; heading in [-pi, pi).
[[nodiscard]] LocalState state_of(const Task& task, const GoalPoint& point);

/// Number of goals of one pose of a region: it may be turned round, and the straight last stretch
/// may be driven in both gears.
[[nodiscard]] std::size_t goals_of_pose(const GoalRegion& region);

/// The goal of the set at which a state is, except for the judge's tolerance; none if there is
/// none.
[[nodiscard]] std::optional<GoalPoint> point_at(const Task& task, const LocalState& state);

/// Straight last stretch before a goal [m]; negative in reverse, 0 if the region asks for none.
[[nodiscard]] double last_stretch(const Task& task, const GoalPoint& point);

/// Number of intervals of a region that are longer than 0: of x, y, heading and hitch angle.
[[nodiscard]] std::size_t number_of_intervals(const Task& task, std::size_t region);

/// Calls `take` with goals evenly spread over a region, until it has returned true `most` times or
/// there are no more. A region of one pose has the `goals_of_pose`.
template <class Take>
void spread(const Task& task, std::size_t region, std::size_t most, Take take);

/// Goals beside `point`: forth and back along each interval of its region, by `share` of the
/// interval.
[[nodiscard]] std::vector<GoalPoint> beside(const Task& task, const GoalPoint& point, double share);

/// Point `i` of a sequence that is evenly spread over a region, wherever it is cut off.
[[nodiscard]] GoalPoint point_of_sequence(const Task& task, std::size_t region, std::size_t i);

/// Whether a point is in its region. Points of an area are spread over the box around it.
[[nodiscard]] bool is_in_region(const Task& task, const GoalPoint& point);

/// Number of points after which a region counts as having no more.
inline constexpr std::size_t max_points = 4096;

template <class Take>
void spread(const Task& task, std::size_t region, std::size_t most, Take take) {
  const GoalRegion& of = task.goal_set[region];
  const std::size_t looks = is_continuous(of) ? max_points : goals_of_pose(of);
  for (std::size_t i = 0, taken = 0; i < looks && taken < most; ++i) {
    const GoalPoint point = point_of_sequence(task, region, i);
    if (is_in_region(task, point) && take(point)) ++taken;
  }
}

/// Part of a region: all points whose numbers differ from those of the middle by at most `half`.
struct RegionPart {
  GoalPoint middle;
  std::array<double, 4> half;
};

/// All of a region with this index, in one part for each way that its poses may be turned.
[[nodiscard]] std::vector<RegionPart> whole(const GoalRegion& region, std::size_t index);

/// Both halves of a part, cut along the interval with the longest way from end to end. `radius`:
/// turning radius [m].
[[nodiscard]] std::array<RegionPart, 2> halves(const GoalRegion& region, double radius,
                                               const RegionPart& part);

/// Both halves of a part, cut along the interval in which a body moves most that reaches `reach`
/// [m] from its axle.
[[nodiscard]] std::array<RegionPart, 2> halves_in_space(const GoalRegion& region, double reach,
                                                        const RegionPart& part);

/// Where the vehicle is in a part, up to the judge's tolerance.
struct PlacedPart {
  Pose pose;              ///< all poses are near this one
  steering::Closing off;  ///< how far they are off it
  Bounds box;             ///< box around all places of the rear axle [m]
};
[[nodiscard]] PlacedPart placed(const Vehicle& vehicle, const GoalRegion& region,
                                const RegionPart& part);

/// Lower bound of the length of all paths from the start to a region of the set [m], on open
/// ground. Halves parts of the region `halvings` times, at most 2000 times, and not once the budget
/// is interrupted.
[[nodiscard]] double length_lower_bound_to(const Task& task, std::size_t region,
                                           std::size_t halvings, const search::Budget& budget);

}  // namespace vandplan::planning
