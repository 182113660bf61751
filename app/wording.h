// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are quantities, outcomes and names said to people?

#include <optional>
#include <string>
#include <string_view>

#include "base/escape.h"
#include "vandplan/judge.h"
#include "vandplan/planner.h"

namespace vandplan::app {

using base::printable;

/// A line of a file in messages: "docks.csv:3". "-" is standard input.
[[nodiscard]] std::string line_of_file(const std::string& file, int line);

/// A length as text in the unit that fits, with at least three digits: "35.120 m", "45.2 mm", "0
/// m".
[[nodiscard]] std::string metres_text(double metres);

/// A time as text in the unit that fits, with at least three digits: "1.204 s", "31.4 ms", "8.20
/// us".
[[nodiscard]] std::string seconds_text(double seconds);

/// A clearance as text: "clearance 1.100 m", "no obstacles". Below 10 mm the text adds how accurate
/// it is.
[[nodiscard]] std::string clearance_text(double clearance);

/// Figures of a path that the judge has checked: "length 12.500 m, gear changes 1, in reverse 2.500
/// m, clearance 0.310 m".
[[nodiscard]] std::string path_text(const PathCheck& check);

/// Figures of a drive that the judge has checked: ", driven in 23.100 s, 0.420 m from moving
/// obstacles". Empty without a drive.
[[nodiscard]] std::string drive_text(const std::optional<DriveCheck>& check);

/// Cost of a path of the problem as text: "cost 63.450 m by a driver's prices"; "driven in 23.100
/// s" if the cost is the time.
[[nodiscard]] std::string cost_text(double cost, const CostOptions& rule, const Problem& problem);

/// Outcome of a result without a path: "no path: goal_in_collision (the footprint hits
/// obstacles[3])".
[[nodiscard]] std::string no_path_text(const PlanResult& result);

}  // namespace vandplan::app
