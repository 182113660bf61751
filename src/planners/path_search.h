// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a planner go on piece by piece?
//
// A path search can be continued. A planner that has several of them, such as the one among moving
// obstacles, lets each go on in turn.

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// What is proven of all paths of a task, whatever the gears and curvatures at the ends.
struct Proven {
  /// Lower bound of the length of paths with exact ends, around obstacles [m]. Ends that are off
  /// make a path shorter by no more than they are off.
  double shortest = 0.0;
  /// Lower bound of the length of paths with exact ends, with headings [m]. Ends that are off may
  /// make a path shorter by `OpenGround::leeway`.
  double shortest_turn = 0.0;
  /// What zones and masks add at least to the cost that the lengths tell.
  double added = 0.0;
  /// Lower bound of the cost, by rules and prices of zones and masks alone.
  double in_zones = 0.0;
  /// What is proven not to get from the start to the goal, such as "nothing as wide as the
  /// vehicle"; empty: none.
  std::string_view walled_in = {};
};

/// A planner that can be continued. What it has found after a number of iterations does not depend
/// on how many it is granted later.
class PathSearch {
 public:
  virtual ~PathSearch() = default;

  /// Goes on for one round of at most `most` iterations. False if nothing is left to do or the time
  /// is over.
  virtual bool advance(std::int64_t most) = 0;
  /// Goes on for one round, which only the budget limits. False as above.
  bool advance() { return advance(std::numeric_limits<std::int64_t>::max()); }
  /// The cheapest path so far, tidied; none while no path is known.
  [[nodiscard]] virtual std::optional<std::vector<Segment>> path() = 0;
  /// Number of iterations so far.
  [[nodiscard]] virtual std::int64_t iterations() const = 0;
  /// Status, counters and the path, as if the search ended here.
  [[nodiscard]] virtual PlannerAnswer answer() = 0;
  /// What is proven so far.
  [[nodiscard]] virtual Proven proven() const { return {}; }
};

/// Begins a search for paths to the one goal of a task. `known` is a path of the task's frame to a
/// goal nearby, or null. The task outlives the search.
using SearchTo = std::function<std::unique_ptr<PathSearch>(
    const Task& task, const PlanOptions& options, const Path* known)>;

/// Searches of a planner that cannot be continued: each round plans anew, with twice the iterations
/// of the round before. Known paths are ignored.
[[nodiscard]] SearchTo restarted_search(
    std::function<PlannerAnswer(const Task&, const PlanOptions&)> planner);

}  // namespace vandplan::planning
