// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are quantities, outcomes and names said to people?

#include <optional>
#include <string>
#include <string_view>

#include "base/escape.h"
#include "vandplan/drive_check.h"
#include "vandplan/path_check.h"
#include "vandplan/planner.h"

namespace vandplan::app {

using base::printable;

/// "35.120 m", "45.2 mm", "0 m": the unit that fits, three digits at least.
[[nodiscard]] std::string metres_text(double metres);

/// "1.204 s", "31.4 ms", "8.20 us": the unit that fits, three digits at least.
[[nodiscard]] std::string seconds_text(double seconds);

/// "clearance 1.100 m", "no obstacles". What is less than 10 mm says how exactly it is known.
[[nodiscard]] std::string clearance_text(double clearance);

/// "length 12.500 m, gear changes 1, in reverse 2.500 m, clearance 0.310 m" of a path that the
/// judge has seen.
[[nodiscard]] std::string path_text(const PathCheck& check);

/// ", driven in 23.100 s, 0.420 m from moving obstacles" of times that the judge has seen; empty
/// where there are none.
[[nodiscard]] std::string drive_text(const std::optional<DriveCheck>& check);

/// "cost 63.450 m by a driver's prices", "driven in 23.100 s" where the cost is the time.
[[nodiscard]] std::string cost_text(double cost, const CostOptions& rule, const Vehicle& vehicle);

/// "no path: goal_in_collision (the footprint hits obstacles[3])" of a result without a path.
[[nodiscard]] std::string no_path_text(const PlanResult& result);

}  // namespace vandplan::app
