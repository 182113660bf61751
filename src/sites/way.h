// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which way does a site table know from a pose?

#include <optional>

#include "sites/data.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/site_table.h"

namespace vandplan::sites {

/// The state of a pose of the scenario's frame, in the gear forward. It may lie outside of the
/// table.
[[nodiscard]] SiteState state_at(const SiteGrid& grid, const SiteLayer& layer,
                                 const Pose& pose) noexcept;

/// Number of the goal of a table that is the task's; none if the table lacks it.
[[nodiscard]] std::optional<std::size_t> goal_in(const SiteTable& table, const Task& task);

/// Throws InputError naming "site" if a table does not hold for a task under complete options, or
/// lacks its goal. Sets of goals are not looked for.
void expect_serves(const SiteTable& table, const Task& task, const PlanOptions& options);

/// The way from the start of a task to its goal, in the world's frame, of arcs and lines whatever
/// the task's steering. None also if the table lacks the goal. The table holds for the task under
/// these prices.
[[nodiscard]] std::optional<SiteWay> way_in_world(const SiteTable& table, const Task& task,
                                                  const CostOptions& cost);

}  // namespace vandplan::sites
