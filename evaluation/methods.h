// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which properties tell planners apart in a comparison? Names mean nothing.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluation/run_record.h"
#include "vandplan/planner.h"

namespace vandplan::evaluation {

/// Number of the thesis' table that ranks nodes, 1 to 4; none if something else ranks them.
[[nodiscard]] std::optional<int> table_number(const PlannerProperties& properties) noexcept;

/// The Euclid twin of a planner: it ranks nodes by Euclid and has the same family, strategy and
/// handling of the goal. Null for a planner that ranks by Euclid itself or by nothing, and where
/// the twin is not among `planners`.
[[nodiscard]] const Planner* euclid_twin(const Planner& planner, std::span<const Planner> planners);

[[nodiscard]] bool is_in_group(const Planner& planner, std::string_view group);

/// Whether a planner has an option for the region of its samples.
[[nodiscard]] bool takes_region(const Planner& planner);

/// Planners of runs, by name: from `known`, otherwise from the library, otherwise without
/// properties (runs of another program). Planners of the library come first, in its order.
[[nodiscard]] std::vector<Planner> planners_of(const std::vector<RunRecord>& runs,
                                               std::span<const Planner> known);

/// Name of a region: "bounds" or "scene".
[[nodiscard]] const char* name_of(Region region) noexcept;

/// Name of a strategy or estimate in capitals: "BSC", "HLUT-2".
[[nodiscard]] std::string upper(std::string name);

}  // namespace vandplan::evaluation
