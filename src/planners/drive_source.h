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
#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan::in_time {

/// A search for paths among standing obstacles and some ghosts of moving ones, or along a detour.
struct Source {
  std::vector<Ghost> ghosts = {};
  Task task = {};                     ///< task without moving obstacles
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
  bool is_searched = false;   ///< whether the search for paths has ended

  [[nodiscard]] bool is_finished() const { return is_searched && !is_hasty && !is_cut_off; }
  /// Whether it is time to look for better times along the path, and not for a better path.
  [[nodiscard]] bool wants_times() const {
    return is_hasty || (is_cut_off && (is_searched || spent >= retry_at));
  }
};

}  // namespace vandplan::in_time
