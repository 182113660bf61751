// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What happens when a vehicle plans anew while it drives? `drive --replan`, `evaluate --replan`.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "option_flags.h"
#include "vandplan/live_drive.h"

namespace vandplan::app {

/// How to plan anew, as the command line says.
struct LiveArguments {
  std::optional<double> period;  ///< there is one: it is asked for [s]
  std::optional<double> sensor_range;
  std::string prediction = "known";
  double horizon = LiveDriveOptions{}.horizon;
  std::optional<std::string> actions;
  double rate = 50.0;  ///< of actions [1/s]
  std::vector<TypedOption> options;
};

/// What else a command says of drives.
struct LiveRuns {
  DriveOptions drive = {};
  int runs = 1;
  std::optional<std::string> output = {};  ///< of the log
  std::optional<std::string> picture = {};
  bool json = false;
};

/// Adds --replan, --sensor-range, --prediction, --horizon; with `is_one` also --actions, --rate and
/// --set.
void add_live_options(CLI::App& command, LiveArguments& arguments, bool is_one);

/// Drives one scenario; returns the exit status.
[[nodiscard]] int drive_again_and_again(const std::string& scenario, const LiveArguments& arguments,
                                        const LiveRuns& runs);

/// Drives many scenarios and prints a table; returns the exit status.
[[nodiscard]] int compare_live(const std::vector<std::string>& files,
                               const LiveArguments& arguments, const LiveRuns& runs);

/// A log as CSV.
[[nodiscard]] std::string csv_of(const std::vector<DriveMoment>& log);

}  // namespace vandplan::app
