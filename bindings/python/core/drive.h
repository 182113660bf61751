// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a drive in Python?

#include <pybind11/pybind11.h>

#include <optional>

#include "bindings/python/core/result.h"
#include "vandplan/moving.h"
#include "vandplan/speed.h"

namespace vandplan::python {

/// A drive: speeds with the path and the vehicle that they belong to. Python calls it SpeedProfile.
struct PathDrive {
  Path path;
  Vehicle vehicle;
  SpeedProfile profile;
  double start_speed = 0.0;  ///< with which the drive begins [m/s]

  [[nodiscard]] TimedPath timed() const { return {path, profile}; }
};

/// The drive that a result was planned with; none if its times are free.
[[nodiscard]] std::optional<PathDrive> planned_drive(const RunResult& result);

/// The numbers of speeds, and speeds of such numbers.
[[nodiscard]] pybind11::tuple profile_state(const SpeedProfile& profile);
[[nodiscard]] SpeedProfile profile_from(const pybind11::handle& state);

}  // namespace vandplan::python
