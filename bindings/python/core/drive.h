// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Python see a drive?

#include <pybind11/pybind11.h>

#include <optional>

#include "bindings/python/core/result.h"
#include "vandplan/motion.h"
#include "vandplan/replanner.h"

namespace vandplan::python {

/// Drive: speeds with their path and vehicle; `SpeedProfile` in Python.
struct PathDrive {
  Path path;
  Vehicle vehicle;
  SpeedProfile profile;
  double start_speed = 0.0;  ///< Speed at the begin of the drive [m/s].

  [[nodiscard]] TimedPath timed() const { return {path, profile}; }
};

/// Result of a live drive, with the driven path as Python sees it; `LiveDriveResult` in Python.
struct LiveRun : LiveDriveResult {
  PathDrive drive = {};
};

/// Drive that a result was planned with; empty if the planner left the times open.
[[nodiscard]] std::optional<PathDrive> planned_drive(const RunResult& result);

/// Numbers of a speed profile for pickle, and the profile of such numbers.
[[nodiscard]] pybind11::tuple profile_state(const SpeedProfile& profile);
[[nodiscard]] SpeedProfile profile_from(const pybind11::handle& state);

}  // namespace vandplan::python
