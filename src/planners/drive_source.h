// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where does the planner among moving obstacles get its paths from?

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "planners/ghosts.h"
#include "planners/path_search.h"
#include "planners/refuges.h"
#include "vandplan/motion.h"
#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan::in_time {

/// A path with its times, and their costs.
struct TimedWay {
  std::vector<Segment> segments;
  SpeedProfile speeds;
  double path_cost = 0.0;  // cost of the path if nothing moves [m or s]
  double cost = 0.0;       // cost with the time of the drive [m or s]
};

inline constexpr double weight_of_best = 4.0;  ///< weight of the source of the best drive
/// A drive that costs so many times the fastest along its path waits long.
inline constexpr double long_wait = 1.3;
/// Weight of a source whose fastest drive is dearer than the best one.
inline constexpr double weight_of_dearer = 0.25;
inline constexpr std::int64_t max_detour_iterations = 600;  ///< most iterations of a detour
/// Work without a path that may win, before ghosts begin later [iterations].
inline constexpr std::int64_t patience = 500;

/// A search for paths among standing obstacles and some ghosts of moving ones, or along a detour.
struct Source {
  Ghosts ghosts = {};
  Task task = {};                     ///< task with the ghosts as standing obstacles
  std::optional<Detour> detour = {};  ///< detour that all paths lead along, if there is one
  /// Search for paths; made when it is first needed.
  std::unique_ptr<planning::PathSearch> search = {};
  std::vector<Segment> path = {};  ///< last path that was given times
  /// Cost of the fastest drive along `path` where nothing moves [m], or [s] if time is the cost.
  double fastest_cost = std::numeric_limits<double>::infinity();
  bool is_hasty = false;      ///< whether only a hasty search has given `path` its times
  bool is_cut_off = false;    ///< whether a search with more states may find better times
  int doublings = 0;          ///< how often the states for the times of `path` were doubled
  std::int64_t retry_at = 0;  ///< work after which times are looked for again [iterations]
  std::int64_t spent = 0;     ///< work so far [iterations]
  bool is_followed = false;   ///< whether ghosts that begin later were tried, too
  bool is_searched = false;   ///< whether the search for paths has ended

  [[nodiscard]] bool is_finished() const { return is_searched && !is_hasty && !is_cut_off; }
  /// Whether it is time to look for better times along the path, and not for a better path.
  [[nodiscard]] bool wants_times() const {
    return is_hasty || (is_cut_off && (is_searched || spent >= retry_at));
  }
  /// Whether a detour needs no more work: its path has got its times, or no path is found.
  [[nodiscard]] bool is_detour_spent() const {
    if (is_finished() || spent >= max_detour_iterations) return true;
    return !path.empty() && !wants_times();
  }
  /// Whether this is an unfinished search around ghosts.
  [[nodiscard]] bool is_open() const { return !ghosts.empty() && !is_finished(); }
  /// Whether the ghosts leave no way.
  [[nodiscard]] bool is_blocked() const { return is_searched && path.empty(); }
  /// Whether much work has found no path on which a drive may be better than the best one.
  [[nodiscard]] bool is_in_vain(double best_cost) const {
    return spent >= patience && fastest_cost >= best_cost;
  }
  /// Share of the work, relative to other sources. `best_cost`: cost of the best drive; infinity:
  /// there is none. `is_best`: whether that drive is along the path of the source.
  [[nodiscard]] double weight(double best_cost, bool is_best) const {
    if (best_cost == std::numeric_limits<double>::infinity()) return 1.0;
    if (is_best) return best_cost > long_wait * fastest_cost ? 1.0 : weight_of_best;
    return fastest_cost >= best_cost ? weight_of_dearer : 1.0;
  }
};

}  // namespace vandplan::in_time
