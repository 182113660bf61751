// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much of the work does each worker get, and when?
//
// Reasons for the numbers: docs/lab/anytime.md.

#include <algorithm>
#include <cstdint>

namespace vandplan::anytime {

/// Share of a worker from a given round on.
struct Turn {
  std::int64_t first_round;  ///< first round in which the worker gets iterations
  std::int64_t share;        ///< iterations of the worker in each round
};

/// The iterations of one worker in a round, in each kind of run.
struct Row {
  Turn until_route = {};  ///< share while there is no route; cheap workers begin first
  // Shares with a route grow with the rounds: by `growing_share` in `by_prices`, by `growth` in all
  // others.

  /// Iterations with a route, if the cost is the length, or over a site.
  std::int64_t by_length = 0;
  std::int64_t by_time = 0;  ///< iterations with a route, if time has a price
  /// Iterations with a route, if the path has prices and routes are bent.
  std::int64_t by_prices = 0;
  /// Share with a route, if `target_gap` is set or the run began with a known path. `first_round`
  /// counts rounds with a route. Rounds are short then, and workers that prove most gaps come
  /// first.
  Turn with_gap_or_known = {};
  Turn far_until_route = {};  ///< share over a whole site, while there is no route
};

namespace shares {

inline constexpr Row search_from_goal{.until_route = {0, 64},
                                      .by_length = 64,
                                      .by_time = 160,
                                      .by_prices = 24,
                                      .with_gap_or_known = {1, 48},
                                      .far_until_route = {0, 64}};
inline constexpr Row search_from_start{.until_route = {1, 64},
                                       .by_length = 64,
                                       .by_time = 160,
                                       .by_prices = 24,
                                       .with_gap_or_known = {6, 48},
                                       .far_until_route = {64, 64}};
/// Iterations of a round that move to the searches from one end, if their present search is so many
/// steps finer than that from the other end. Neither end is ever left without any.
constexpr std::int64_t moved_to_finer_search(std::int64_t levels) {
  return 15 * std::clamp<std::int64_t>(levels, -4, 4);
}
inline constexpr Row refine{.by_length = 256, .with_gap_or_known = {0, 48}};
inline constexpr Row length_prover{
    .by_length = 2, .by_time = 2, .by_prices = 1, .with_gap_or_known = {0, 1}};
inline constexpr Row bend{.by_length = 24, .by_prices = 96, .with_gap_or_known = {0, 24}};

/// Share of the survey [iterations a round].
inline constexpr std::int64_t survey = 16;
/// Share of the survey in its first pass [iterations a round]. It is large, because a first route
/// of another kind is wanted soon.
inline constexpr std::int64_t first_pass = 50;

/// Rounds from one round of detours to the next, over a whole site. Detours and refining have
/// different rounds, because each would lose what the other gained in the same round.
inline constexpr std::int64_t far_cycle = 4;
/// Iterations of the detours in each of their rounds.
inline constexpr std::int64_t far_detours = 4096;

/// Trials in a round of "cheapest drive", the worker that compares routes by the cost of the whole
/// drive.
inline constexpr std::int64_t cheapest_drive = 192;

/// Iteration at which the survey begins, if there is a route. Earlier it would delay workers that
/// gain more.
inline constexpr std::int64_t first_survey = 500;
/// Rounds with a route after which the survey begins in any case: all other workers may have ended.
inline constexpr std::int64_t rounds_without_work = 64;

/// Rounds in which the way of a table is only bent: it is of the best kind, but crooked.
inline constexpr std::int64_t rounds_of_site_way = 16;

/// Share of "bend" without a route, if it follows the way of a table.
inline constexpr Turn following_of_site_way = {0, 96};

/// Rounds with a route before the bound with headings is raised, if a gap is to be proven: boxes of
/// poses take long to make.
inline constexpr std::int64_t first_raise = 24;
/// Factor of the length prover's share once the best cost hardly falls.
inline constexpr std::int64_t settled_steps = 4;

/// Round from which the wall prover works, if there is no route. Most runs have a route by then.
/// Over a whole site its steps are slower.
inline constexpr std::int64_t first_wall_round = 3;
inline constexpr std::int64_t first_wall_round_far = 99;
/// Steps of the wall prover in a round.
inline constexpr std::int64_t wall_steps = 8;

/// Share of the zone prover with a route [steps a round].
inline constexpr std::int64_t zone_steps = 8;

}  // namespace shares

/// Factor of the shares in a round. Rounds grow with time, so that workers on several threads
/// seldom wait for each other.
constexpr std::int64_t growth(std::int64_t round) {
  return std::min<std::int64_t>(1 + round / 8, 16);
}
/// Sum of the growing factors of all rounds before `round`, in eighths; `round` counts rounds with
/// a route. Rounds are short at first, so that workers soon hear of each other's routes.
constexpr std::int64_t eighths_due(std::int64_t round) {
  constexpr std::int64_t growing = 126;
  const std::int64_t grown = std::min(round, growing);
  return grown * (grown + 3) / 2 + (round - grown) * (growing + 2);
}
/// Iterations of a worker in a round whose share grows; the first round with a route is 0. Trials
/// are slow here and the first ones gain most, so rounds start short.
constexpr std::int64_t growing_share(std::int64_t share, std::int64_t round) {
  return share * eighths_due(round + 1) / 8 - share * eighths_due(round) / 8;
}

}  // namespace vandplan::anytime
