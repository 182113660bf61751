// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I look at a plan or a drive over time, in Foxglove or Lichtblick?
//
// A recording is an MCAP file with Foxglove's schemas. Its topics: docs/recording.md.

#include <optional>
#include <span>
#include <string>

#include "vandplan/drive.h"
#include "vandplan/planner.h"
#include "vandplan/problem.h"

namespace vandplan {

/// A drive that a recording shows, such as `DriveResult` or `LiveDriveResult` hold it.
struct RecordedDrive {
  std::span<const DriveMoment> log;  ///< moments of the drive; t increases
  bool has_arrived = true;           ///< whether the vehicle stands at its goal in the end
  std::optional<Contact> contact = {};
};

/// Content of a recording. Everything is in the scenario's frame.
struct Recording {
  const Scenario* scenario = nullptr;  ///< the scenario; required
  const PlanResult* plan = nullptr;    ///< result of a planning run; or null
  /// A drive, whose start is the time 0 of the recording. None: the recording begins with the run
  /// of `plan`, and the fastest drive along its path follows.
  std::optional<RecordedDrive> drive = {};
};

/// Writes a recording, whole or not at all. "-" is standard output. Equal content gives equal
/// bytes. Of the wall clock only the times of `PlanResult::anytime` are in it, as a number in
/// "/improvement". Throws InputError naming:
///
/// - the file if it cannot be written,
/// - the key of a scenario that `check_scenario` refuses,
/// - "plan" or "drive" if a number is not finite, "drive" if there is no moment or t decreases.
void record(const std::string& file, const Recording& recording);

}  // namespace vandplan
