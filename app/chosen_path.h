// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which path of a result file is to be driven?

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "endings.h"
#include "vandplan/problem.h"
#include "vandplan/result_file.h"
#include "vandplan/scenario_file.h"

namespace vandplan::app {

/// Where a path is, as the command line says.
struct PathArguments {
  std::string scenario;
  std::string result;
  std::optional<std::size_t> goal;
  std::optional<std::size_t> pair;
};

/// One path of a result file, with the problem that it solves.
struct Choice {
  Scenario scenario;  // with the poses of the problem
  Problem problem;
  ResultRecord record;
  std::string label;  // "yard goals[2]"
};

/// Adds SCENARIO, RESULT, --goal and --pair to a command; call `add_choice` after its other
/// options.
void add_files(CLI::App& command, PathArguments& arguments);
void add_choice(CLI::App& command, PathArguments& arguments);

/// Reads both files. Of a row of goals it takes the furthest one with a path unless another one is
/// asked for. Throws InputError.
[[nodiscard]] Choice chosen_path(const PathArguments& arguments);

/// Why there is nothing to drive: no path, or one that the judge finds invalid; empty if there is.
[[nodiscard]] std::string reason_not_to_drive(const Choice& choice);

/// Throws InputError if the drive over time cannot be written there: an ending of another kind of
/// file, no such folder, or "-" while --json prints as well.
void expect_drive_output(const std::string& output, const FileKind& kind, bool json);

/// Says why there is nothing to drive; returns the exit status.
int refuse(const Choice& choice, const std::string& reason, bool json);

}  // namespace vandplan::app
