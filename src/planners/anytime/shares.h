// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much of the work does each island get?
//
// Why so much: docs/algorithms/anytime.md, "What was tried, and what it brought".

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "planners/anytime/island.h"

namespace vandplan::anytime {

inline constexpr std::size_t island_count = 14;

/// An island, and its iterations in one round: none before its first one, so that what is cheap is
/// tried first; then until there is a route, and from then on.
struct Plan {
  Work work;
  std::int64_t first_round;
  std::int64_t before;
  std::int64_t after;
  std::int64_t after_with_prices;  // looking for other kinds of path is worth more then
  std::int64_t after_with_bending;
  std::int64_t beside_relaxed;  // islands
};

inline constexpr std::array<Plan, island_count> plans = {
    {{Work::search_from_goal, 1, 64, 64, 160, 40, 24},
     {Work::search_from_start, 2, 64, 64, 160, 40, 24},
     {Work::random_trees, 0, 16, 32, 32, 1, 1},
     {Work::refine, 0, 0, 256, 96, 2, 1},
     {Work::bound, 0, 0, 2, 2, 1, 1},
     {Work::detours, 0, 0, 0, 96, 24, 16},
     {Work::bend, 0, 0, 24, 0, 96, 96},
     {Work::survey, 0, 0, 0, 0, 16, 16},
     {Work::search_from_goal, 0, 0, 0, 0, 0, 60},
     {Work::search_from_start, 0, 0, 0, 0, 0, 60},
     {Work::random_trees, 0, 0, 0, 0, 0, 1},
     {Work::refine, 0, 0, 0, 0, 0, 5},
     {Work::detours, 0, 0, 0, 0, 0, 24},
     {Work::adapt, 0, 0, 0, 0, 0, 16}}};

/// Those whose work is told apart.
inline constexpr std::size_t bound_island = 4;
inline constexpr std::size_t bend_island = 6;
inline constexpr std::size_t survey_island = 7;
// Islands join late from the survey on, those behind it where the curvature is continuous.
inline constexpr std::size_t first_later = survey_island;
inline constexpr std::size_t first_relaxed = survey_island + 1;
inline constexpr std::size_t adapt_island = 13;
static_assert(plans[bound_island].work == Work::bound && plans[bend_island].work == Work::bend &&
              plans[survey_island].work == Work::survey && plans[adapt_island].work == Work::adapt);

/// Of the survey until its first way is found, beside relaxed islands, and of its first look: what
/// that brings cannot come too soon.
inline constexpr std::int64_t first_glance = 200;
inline constexpr std::int64_t first_look = 100;

/// Over a whole site: the first five of these islands, and sometimes detours. A second way, which
/// is nearly the shortest, comes first.
inline constexpr std::array<Plan, island_count> far_plans = {
    {{Work::search_from_goal, 1, 64, 256, 256, 0, 0},
     {Work::search_from_start, 64, 64, 16, 16, 0, 0},
     {Work::random_trees, 0, 16, 0, 0, 0, 0},
     {Work::refine, 0, 0, 256, 256, 0, 0},
     {Work::bound, 0, 0, 4, 1, 0, 0}}};

/// Where a gap is to be proven, or a route was known: of the islands in the order of `plans`, after
/// how many rounds with a route they join, and their share. Rounds are short, and what mostly
/// proves the gap, and betters the route, comes first.
struct GapPlan {
  std::int64_t first_round;
  std::int64_t share;
};

inline constexpr std::array<GapPlan, island_count> gap_plans = {
    {{1, 48}, {6, 48}, {6, 16}, {0, 48}, {0, 1}, {6, 48}, {0, 24}}};

/// How often a share counts in a round: rounds grow with time, so that islands on several threads
/// seldom wait for each other.
constexpr std::int64_t growth(std::int64_t round) {
  return std::min<std::int64_t>(1 + round / 8, 16);
}
/// How often a share is due, in eighths, before a round with bending, of those that have a route.
/// Rounds are short at first, as what one island found is to be known to the others soon.
constexpr std::int64_t eighths_due(std::int64_t round) {
  constexpr std::int64_t growing = 126;
  const std::int64_t grown = std::min(round, growing);
  return grown * (grown + 3) / 2 + (round - grown) * (growing + 2);
}
/// The share itself in such a round: a trial takes longer, and the first ones bring most.
constexpr std::int64_t share_with_bending(std::int64_t share, std::int64_t round) {
  return share * eighths_due(round + 1) / 8 - share * eighths_due(round) / 8;
}

}  // namespace vandplan::anytime
