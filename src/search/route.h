// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a planner hold while it improves a path?

#include <vector>

#include "vandplan/search.h"

namespace vandplan::search {

/// A piece and the exact pose it leads to.
struct Leg {
  Piece piece;
  LocalPose end;
  double clearance_cost = 0.0;  ///< what being near things adds to its cost [m]
};

/// From the start through via poses to the goal.
struct Route {
  LocalPose start;
  std::vector<Leg> legs;
  double cost = 0.0;

  [[nodiscard]] double length() const;
  /// Where leg `i` begins.
  [[nodiscard]] const LocalPose& begin_of(std::size_t i) const {
    return i == 0 ? start : legs[i - 1].end;
  }
};

/// As many arcs and lines as a word of Reeds and Shepp has.
inline constexpr std::size_t segments_of_leg = 5;

/// Drives on to `end`: the last segment goes on where both are alike, an arc or a line in the same
/// gear; else the segment begins a leg, if it has to or the last one has `most` of them, or joins
/// that one.
void drive_on(std::vector<Leg>& legs, const Segment& segment, const LocalPose& end,
              std::size_t most = segments_of_leg, bool begins_leg = false);

/// What is driven before the start and after the goal, as far as the task and the rule say.
[[nodiscard]] Gears gears_at_ends(const Task& task, const CostRule& rule);

/// What a piece between `gears` has to fit: wheels that turn at once begin with any curvature, and
/// anything may follow.
[[nodiscard]] Gears fitted_gears(const Task& task, const Gears& gears);

/// The gears driven before leg `first` and from leg `last` on; `beside` is what is driven before
/// and after the route.
[[nodiscard]] Gears gears_around(const Gears& beside, const Route& route, std::size_t first,
                                 std::size_t last);

/// From the first leg to the last, with the `clearance_cost` that they have.
[[nodiscard]] double cost_of(const CostRule& rule, const Route& route);

/// Finds the `clearance_cost` of all legs, and the cost of the route.
void price(const Connector& connector, Route& route);

/// A route driven backwards: from its end to its start.
[[nodiscard]] Route reversed(const Route& route);

/// What of a route is driven from `begin` to `end` [m], 0 <= begin < end <= its length; without a
/// cost. Empty if they are equal.
[[nodiscard]] Route part_of(const Route& route, double begin, double end);

/// The place [m] on a route of the task nearest to `s` where it can be cut: `s` itself if the
/// wheels turn at once, or else where `nearest_cut` lets its pieces be cut.
[[nodiscard]] double nearest_cut(const Task& task, const Route& route, double s);

/// Whether two routes between the same poses change gear alike and stay within `near` [m] of each
/// other, as far as a few places on them tell.
[[nodiscard]] bool are_alike(const Route& a, const Route& b, double near);

[[nodiscard]] Path path_of(const Route& route);

}  // namespace vandplan::search
