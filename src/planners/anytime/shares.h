// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much of the work does each worker get?
//
// Why so much: docs/lab/anytime.md.

#include <algorithm>
#include <cstdint>

namespace vandplan::anytime {

/// A share of the work, from some round on.
struct Turn {
  std::int64_t first_round;  ///< first round with work
  std::int64_t share;        ///< iterations of a round
};

/// The iterations of one worker in a round, in each kind of run.
struct Row {
  Turn until_route;        ///< while there is no route: what is cheap comes first
  std::int64_t by_length;  ///< with a route, where its length counts
  std::int64_t by_time;    ///< with a route, where the time has a price
  std::int64_t by_prices;  ///< with a route, where its prices count, and it is bent
  /// From so many rounds with a route on, where a gap is to be proven or a path was known: rounds
  /// are short, and what mostly proves the gap comes first.
  Turn with_gap;
  Turn far_until_route = {};       ///< over a whole site: a first way
  std::int64_t far_by_length = 0;  ///< over a whole site, with a route
  std::int64_t far_by_prices = 0;
};

namespace shares {

inline constexpr Row search_from_goal{{1, 64}, 64, 160, 24, {1, 48}, {1, 64}, 256, 256};
inline constexpr Row search_from_start{{2, 64}, 64, 160, 24, {6, 48}, {64, 64}, 16, 16};
inline constexpr Row refine{{}, 256, 0, 0, {0, 48}, {}, 256, 256};
inline constexpr Row length_prover{{}, 2, 2, 1, {0, 1}, {}, 4, 1};
inline constexpr Row bend{{}, 24, 0, 96, {0, 24}};
inline constexpr Row survey{{}, 0, 0, 16, {}};

/// Share of the survey until its first way is found, if that is of the relaxed task, and in its
/// first look: what that brings cannot come too soon.
inline constexpr std::int64_t first_glance = 200;
inline constexpr std::int64_t first_look = 100;

/// Samples of the trees in each round until there is a route. Trees that found nothing by the later
/// round are in a tight place: only the lattices get through.
inline constexpr std::int64_t early_trees = 16;
inline constexpr Turn late_trees{16, 1};

/// Over a whole site a detour changes a small part of a route, and refining another one: each has
/// rounds of its own, or one would lose what the other gained.
inline constexpr std::int64_t far_cycle = 4;       // rounds
inline constexpr std::int64_t far_detours = 4096;  // iterations of one round

/// Trials of a round by the measure of the whole drive.
inline constexpr std::int64_t fastest = 192;

}  // namespace shares

/// How often a share counts in a round: rounds grow with time, so that workers on several threads
/// seldom wait for each other.
constexpr std::int64_t growth(std::int64_t round) {
  return std::min<std::int64_t>(1 + round / 8, 16);
}
/// How often a growing share is due, in eighths, before a round, of those that have a route.
/// Rounds are short at first, as what one worker found is to be known to the others soon.
constexpr std::int64_t eighths_due(std::int64_t round) {
  constexpr std::int64_t growing = 126;
  const std::int64_t grown = std::min(round, growing);
  return grown * (grown + 3) / 2 + (round - grown) * (growing + 2);
}
/// A share of such a round, the first one with a route being 0: a trial takes longer, and the first
/// ones bring most.
constexpr std::int64_t growing_share(std::int64_t share, std::int64_t round) {
  return share * eighths_due(round + 1) / 8 - share * eighths_due(round) / 8;
}

}  // namespace vandplan::anytime
