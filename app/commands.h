// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which commands are there? Each is one function in one file, app/<command>.cpp.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace vandplan::app {

/// Exit statuses of the program.
namespace exit_status {
inline constexpr int done = 0;
inline constexpr int failed = 1;     ///< no path, or a check failed
inline constexpr int bad_input = 2;  ///< bad input or wrong usage
}  // namespace exit_status

/// Function that adds a command. A command that is called runs and sets `status`. It throws
/// InputError for bad input.
using AddCommand = void (*)(CLI::App& vandplan, int& status);

void add_check(CLI::App& vandplan, int& status);
void add_convert(CLI::App& vandplan, int& status);
void add_draw(CLI::App& vandplan, int& status);
void add_drive(CLI::App& vandplan, int& status);
void add_evaluate(CLI::App& vandplan, int& status);
void add_matrix(CLI::App& vandplan, int& status);
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

/// Prints the JSON object that `--json` asks for.
void print(const nlohmann::ordered_json& object);

/// Prints a JSON object on a line of its own, for commands that print many of them.
void print_line(const nlohmann::ordered_json& object);

/// Prints warnings on standard error, one per line.
void warn(const std::vector<std::string>& warnings);

}  // namespace vandplan::app
