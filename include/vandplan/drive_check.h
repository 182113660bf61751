// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are these times really valid, and who is met on the way?
//
// The independent judge of drives; `check_path` is that of their paths. It shares no code with what
// it judges. Its method: docs/algorithms/moving.md.

#include <optional>
#include <string>

#include "vandplan/moving.h"
#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan {

/// What somebody says about a drive.
struct DriveClaims {
  double margin = 0.0;  ///< the footprint keeps at least this far from all that moves [m]
  /// With which the vehicle comes to the start, in the gear of the first segment [m/s].
  double start_speed = 0.0;
};

/// The judge's verdict on a drive.
struct DriveCheck {
  bool valid = false;
  std::string reason = {};           ///< the first thing found wrong, one line; empty when valid
  std::optional<double> t = {};      ///< when, if at a time [s]
  std::optional<PathPoint> at = {};  ///< where the vehicle is then; in the scenario's frame
  double duration = 0.0;             ///< [s]
  /// Least distance between the footprint and the grown outline of anything that moves, too large
  /// by 1 mm and a twentieth at most [m]: 0 if they touch, infinity if nothing moves. None if the
  /// times were found wrong before.
  std::optional<double> clearance = {};
};

/// Judges the times of a drive in the scenario's frame whose path `check_path` accepts, in this
/// order: every number is finite, speeds and distances follow from each other, it drives the whole
/// path from the claimed speed to standing, keeps `Vehicle::limits` (to 1e-6 of them), stands where
/// the gear changes or the curvature jumps until the wheels are turned, and neither on the way nor
/// ever after touches anything that moves, or comes nearer than is claimed.
[[nodiscard]] DriveCheck check_drive(const Problem& problem, const TimedPath& drive,
                                     const DriveClaims& claims = {});

/// Judges who is met on a drive and ever after, and nothing else: for what was driven rather than
/// planned. Its knots must follow from each other.
[[nodiscard]] DriveCheck check_company(const Problem& problem, const TimedPath& drive,
                                       const DriveClaims& claims = {});

}  // namespace vandplan
