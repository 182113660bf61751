// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which path of a result file is to be driven?

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "endings.h"
#include "vandplan/files.h"
#include "vandplan/problem.h"
#include "vandplan/result_file.h"

namespace vandplan::app {

/// Arguments of a command that say which path of which files it uses.
struct PathArguments {
  std::string scenario;
  std::string result;
  std::optional<std::size_t> goal;  ///< number of the goal in a row, from 0; none: the default
  std::optional<std::size_t> pair;  ///< number of the pair, from 1; none: not given
};

/// One path of a result file, with the problem that it solves.
struct Choice {
  Scenario scenario;  // scenario with start and goal of the problem
  Problem problem;
  ResultRecord record;
  std::string label;  // name for people, such as "yard goals[2]"
};

/// Adds --goal and --pair to a command. Call it after the command's other options are added.
void add_choice(CLI::App& command, PathArguments& arguments);

/// Reads scenario and result, and takes the path that the arguments name. Without --goal it takes
/// the furthest goal of a row that has a path. Throws InputError.
[[nodiscard]] Choice chosen_path(const PathArguments& arguments);

/// Reason why the path cannot be driven: there is none, or the judge finds it invalid. Empty if it
/// can.
[[nodiscard]] std::string reason_not_to_drive(const Choice& choice);

/// Throws InputError if a drive cannot be written to `output`: the ending is that of another kind
/// of file, the file cannot be written, or it is "-" while --json prints as well.
void expect_drive_output(const std::string& output, const FileKind& kind, bool json);

/// Prints the reason why the path is not driven; returns the exit status.
int refuse(const Choice& choice, const std::string& reason, bool json);

}  // namespace vandplan::app
