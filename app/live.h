// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What happens when a vehicle plans anew while it drives? `drive --replan`, `evaluate --replan`.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "option_flags.h"
#include "vandplan/replanner.h"

namespace vandplan::app {

/// Arguments of a command that plans while driving.
struct LiveArguments {
  std::optional<double> period;        ///< replanning period [s]; none: no --replan
  std::optional<double> sensor_range;  ///< range of the sensor [m]; none: all is known
  std::string prediction = "known";
  double horizon = LiveDriveOptions{}.horizon;  ///< horizon of the prediction [s]
  bool with_site = false;                       ///< whether plans begin with a table of the site
  std::optional<std::string> actions;           ///< file of planned actions; none: not written
  double rate = 50.0;                           ///< actions per second [1/s]
  std::vector<TypedOption> options;
};

/// Other arguments of simulated drives.
struct LiveRuns {
  DriveOptions drive = {};
  int runs = 1;
  std::optional<std::string> output = {};     ///< file of the log; none: not written
  std::optional<std::string> picture = {};    ///< file of the picture; none: not drawn
  std::optional<std::string> recording = {};  ///< file of the recording; none: not recorded
  bool json = false;
};

/// Adds --replan, --sensor-range, --prediction and --horizon to a command. With `is_one`, for a
/// command that drives one scenario, it also adds --actions, --rate and --set.
void add_live_options(CLI::App& command, LiveArguments& arguments, bool is_one);

/// Drives one scenario; returns the exit status.
[[nodiscard]] int drive_again_and_again(const std::string& scenario, const LiveArguments& arguments,
                                        const LiveRuns& runs);

/// Drives many scenarios and prints a table; returns the exit status.
[[nodiscard]] int compare_live(const std::vector<std::string>& files,
                               const LiveArguments& arguments, const LiveRuns& runs);

/// The log of a drive as CSV.
[[nodiscard]] std::string csv_of(const std::vector<DriveMoment>& log);

}  // namespace vandplan::app
