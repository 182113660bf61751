// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do tables of sites come to and from the command line?

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "option_flags.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan::app {

/// Adds the command `site` to the command `table`.
void add_table_site(CLI::App& table, int& status);

/// Complete options of a table for a scenario: those of its file, overridden by typed ones. Throws
/// InputError for a typed option that means nothing to a table.
[[nodiscard]] PlanOptions site_options(const ScenarioProblems& read,
                                       const std::vector<TypedOption>& typed);

/// Poses in a file; their warnings are printed.
[[nodiscard]] Poses poses_in(const std::string& file);
/// The error, but if it names a pose of a list, such as "goals[2]", it names the pose's line.
[[nodiscard]] InputError named_by_line(const InputError& error, const std::string& list,
                                       const std::string& file, const Poses& poses);

/// Adds --set for prices, gears and margin to a command. `options` outlives the command.
void add_site_settings(CLI::App& command, std::vector<TypedOption>& options);
/// Adds --jobs to a command.
void add_jobs(CLI::App& command, int& jobs, const char* about);
/// Number of threads for so many jobs; 0: one per processor.
[[nodiscard]] int threads_of(int jobs);

/// Prints what the table of a file holds. Throws InputError naming the file if it is not such a
/// table.
void print_site_table(const std::string& file, bool json);

/// The planner, but what it throws about the table of the site names the table's file.
[[nodiscard]] Planner naming_site(Planner planner, const std::string& file);

}  // namespace vandplan::app
