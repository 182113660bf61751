// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which sources of routes does the anytime planner have?
//
// Tasks, rules, guides and connectors outlive the sources.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "planners/anytime/lattice.h"
#include "planners/anytime/source.h"
#include "search/guide.h"
#include "search/route.h"
#include "vandplan/planner.h"

namespace vandplan::anytime {

/// Lattice searches from coarse to fine, all from the same end of the task. With prices they go by
/// length until a route is known. Afterwards different searches take turns (`rotation`); if only a
/// fine one found a route, because a slot is tight, it is repeated by price instead, and finer ones
/// follow. Over a whole site there is one search, in a strip (`strung`), and others only if that
/// finds no route. The stage is the number of searches begun before there is a route.
[[nodiscard]] std::unique_ptr<Source> ladder_from_start(const Task& task, const CostRule& rule);
[[nodiscard]] std::unique_ptr<Source> ladder_from_goal(const Task& task, const CostRule& rule);

/// Lattice searches from one root, with different cells and greediness, that take turns. Each goes
/// on where it was, and none blocks the others. With prices, ways of many kinds cost about as much
/// as the best: around the other side, or with another number of strokes. One search finds one of
/// them first. A turn has `turn` expansions, a step is one. The connector has the prices in the
/// direction of the search. Routes lead from the root to the target.
[[nodiscard]] std::unique_ptr<Source> rotation(const LocalPose& root, const LocalPose& target,
                                               const DrivenBeside& beside,
                                               std::span<const LatticeOptions> searches,
                                               std::int64_t turn, const Guide& guide,
                                               Connector& connector);

/// Makes one route along a way of points from the task's start to its goal, without its cost. The
/// way is pulled straight, like a string around obstacles. The vehicle drives exactly from corner
/// to corner, so work grows with the length of the way. `way` has both ends, and its steps are
/// about equally long.
[[nodiscard]] std::unique_ptr<Source> strung(const Task& task, std::vector<Point> way,
                                             Connector& connector);

/// Replaces random stretches of a long route by results of a lattice search between their ends. A
/// result is shortened first. If it is cheaper than the stretch, it becomes a part of the route.
/// `set_route`, with a length above 0, comes before the first step.
[[nodiscard]] std::unique_ptr<Source> detours(const Task& task, const CostRule& rule,
                                              std::uint64_t seed);

/// Searches everywhere for routes of other kinds. Two fields hold the cost of driving from each
/// pose to the goal, and from the start to each pose. Where both add up to little more than the
/// least cost, a way leads through. Ways of different kinds become routes of arcs and lines. A
/// cutoff comes before the first step. The stage is the number of passes done; the first pass has
/// the coarsest cells. Method: docs/algorithms/anytime.md, "Survey".
[[nodiscard]] std::unique_ptr<Source> survey(const Task& task, const CostRule& rule);

/// Makes a free route of each path that a source of the caller proposes, if it finds one. `paths`
/// must not be null.
[[nodiscard]] std::unique_ptr<Source> proposals(const Task& task, const CostRule& rule,
                                                std::unique_ptr<PathSource> paths,
                                                std::uint64_t seed);

}  // namespace vandplan::anytime
