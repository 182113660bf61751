// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cells does the table of a site have, and what is asked of its goals?

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "sites/data.h"
#include "vandplan/problem.h"
#include "vandplan/site_table.h"

namespace vandplan::sites {

/// Throws InputError naming `where`, unless something holds.
void require(bool holds, const char* where, const char* expected);

/// Place of a pose in a list, for errors: "goals[2]".
[[nodiscard]] std::string place_in(const char* list, std::size_t number);

/// The problem from another start to another goal. Throws InputError naming `where`.
[[nodiscard]] Problem between(const Problem& problem, const Pose& start, const Pose& goal,
                              const std::string& where);

/// The task to goal number `number` of a table. It begins there, so that margins have ramps around
/// the goal alone.
[[nodiscard]] Task task_to(const Problem& problem, const Pose& goal, std::size_t number,
                           const PlanOptions& options);

/// Goals of a table that are the poses of a problem's set of goals. Throws as `site_goals`.
[[nodiscard]] SiteGoals goals_of_set(const Problem& problem, const PlanOptions& options);

/// Whether an outcome says that there is no path at all.
[[nodiscard]] bool is_proven_empty(SiteOutcome outcome) noexcept;

/// The site of a table: a task to each goal, and the cells.
struct Site {
  std::vector<Task> tasks = {};
  Bounds box = {};  ///< box of the cells, in the world's frame [m]
  SiteGrid grid = {};
};

/// The site of a table that is wanted. Throws InputError as `make_site_table`.
[[nodiscard]] Site site_of(const Problem& problem, std::span<const Pose> goals,
                           const PlanOptions& options, const SiteTableOptions& table);

}  // namespace vandplan::sites
