// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a planner hold while it improves a path?

#include <span>
#include <vector>

#include "vandplan/search.h"

namespace vandplan::search {

/// Piece of a route and the exact pose at its end.
struct Leg {
  Piece piece;
  LocalPose end;
  double clearance_cost = 0.0;  ///< Cost that small clearance adds [m].
};

/// Route from the start through intermediate poses to the goal.
struct Route {
  LocalPose start;
  std::vector<Leg> legs;
  double cost = 0.0;

  [[nodiscard]] double length() const;
  /// Pose where leg `i` begins.
  [[nodiscard]] const LocalPose& begin_of(std::size_t i) const {
    return i == 0 ? start : legs[i - 1].end;
  }

  /// Puts `fresh` in the place of the legs [first, last). The cost is not computed.
  void replace(std::size_t first, std::size_t last, std::span<const Leg> fresh);
  /// Adds legs at the end. The cost is not computed.
  void append(std::span<const Leg> more) { replace(legs.size(), legs.size(), more); }
};

/// Relative gain of a cost that counts as progress.
inline constexpr double progress = 1e-3;
/// Rounding of a cost, relative.
inline constexpr double rounding_of_cost = 1e-12;

/// Largest number of segments of a Reeds-Shepp word.
inline constexpr std::size_t segments_of_leg = 5;

/// Appends a segment that ends at `end`. It extends the last segment if both are lines or arcs of
/// equal curvature in one gear. Otherwise it joins the last leg, or begins a new leg if
/// `begins_leg` is set or the last leg has `most` segments.
void drive_on(std::vector<Leg>& legs, const Segment& segment, const LocalPose& end,
              std::size_t most = segments_of_leg, bool begins_leg = false);

/// Gears and curvatures before leg `first` and from leg `last` on. `ends`: those before and after
/// the route.
[[nodiscard]] DrivenBeside driven_around(const DrivenBeside& ends, const Route& route,
                                         std::size_t first, std::size_t last);

/// Cost of a route [m], with the `clearance_cost` stored in its legs.
[[nodiscard]] double cost_of(const CostRule& rule, const Route& route);

/// Computes `clearance_cost` of all legs, and the cost of the route.
void price(const Connector& connector, Route& route);

/// Route driven backwards, from its end to its start.
[[nodiscard]] Route reversed(const Route& route);

/// Part of a route from `begin` to `end` [m], 0 <= begin <= end <= its length; empty if they are
/// equal. The cost is not computed.
[[nodiscard]] Route part_of(const Route& route, double begin, double end);

/// Segments between two driven distances [m]; pieces of a nanometre are left out.
[[nodiscard]] std::vector<Segment> part_of(std::span<const Segment> segments, double begin,
                                           double end);

/// Place on a route nearest to `s` where it can be cut [m]. This is `s` if the wheels turn at once,
/// otherwise a place that `nearest_cut` finds on its pieces.
[[nodiscard]] double nearest_cut(const Task& task, const Route& route, double s);

/// Whether two routes between the same poses change gear equally often and stay within `near` [m]
/// of each other, judged at a few places.
[[nodiscard]] bool are_alike(const Route& a, const Route& b, double near);

[[nodiscard]] Path path_of(const Route& route);

}  // namespace vandplan::search
