// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which commands are there? Each is one function in one file, app/<command>.cpp.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace vandplan::app {

/// What the shell learns.
namespace exit_status {
inline constexpr int done = 0;
inline constexpr int failed = 1;     ///< no path, or a check failed
inline constexpr int bad_input = 2;  ///< or wrong usage
}  // namespace exit_status

/// Adds a command. When it is the one that is called, it runs and sets `status`; it throws
/// InputError for bad input.
using AddCommand = void (*)(CLI::App& vandplan, int& status);

void add_check(CLI::App& vandplan, int& status);
void add_convert(CLI::App& vandplan, int& status);
void add_draw(CLI::App& vandplan, int& status);
void add_drive(CLI::App& vandplan, int& status);
void add_evaluate(CLI::App& vandplan, int& status);
void add_plan(CLI::App& vandplan, int& status);
void add_planners(CLI::App& vandplan, int& status);
void add_smooth(CLI::App& vandplan, int& status);
void add_speed(CLI::App& vandplan, int& status);
void add_study(CLI::App& vandplan, int& status);
void add_table(CLI::App& vandplan, int& status);

/// Adds the argument SCENARIO, which has to be given.
void add_scenario(CLI::App& command, std::string& scenario);

/// Adds the arguments SCENARIO and RESULT, which have to be given.
void add_scenario_and_result(CLI::App& command, std::string& scenario, std::string& result);

/// What `--json` prints instead of a summary.
void print(const nlohmann::ordered_json& object);

/// One of many objects that `--json` prints, on a line of its own.
void print_line(const nlohmann::ordered_json& object);

/// Says on the standard error what deserves a look though nothing is wrong, a line each.
void warn(const std::vector<std::string>& warnings);

}  // namespace vandplan::app
