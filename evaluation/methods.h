// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What tells planners apart in a comparison? Their properties: a name means nothing.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluation/run_record.h"
#include "vandplan/planner.h"

namespace vandplan::evaluation {

/// The number of the thesis' table that ranks nodes, 1 to 4; none where something else does.
[[nodiscard]] std::optional<int> table_number(const PlannerProperties& properties) noexcept;

/// The planner that ranks by Euclid and is alike otherwise: same family, strategy and handling of
/// the goal; null for a planner that ranks by Euclid itself, or by nothing, and where the twin is
/// not among `planners`.
[[nodiscard]] const Planner* euclid_twin(const Planner& planner, std::span<const Planner> planners);

[[nodiscard]] bool is_in_group(const Planner& planner, std::string_view group);

/// Whether a planner can be told where to draw samples.
[[nodiscard]] bool takes_region(const Planner& planner);

/// The planners of runs: those that are `known`, else those of the library by that name, else ones
/// without properties, which another program made. Those of the library come first, in its order.
[[nodiscard]] std::vector<Planner> planners_of(const std::vector<RunRecord>& runs,
                                               std::span<const Planner> known);

/// "bounds" or "scene".
[[nodiscard]] const char* name_of(Region region) noexcept;

/// A strategy or estimate as people write it: "BSC", "HLUT-2".
[[nodiscard]] std::string upper(std::string name);

}  // namespace vandplan::evaluation
