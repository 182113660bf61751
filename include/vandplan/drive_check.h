// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are these times really valid, and who is met on the way?
//
// The independent judge of drives; `check_path` judges their paths. It shares no code with what it
// judges. Method: docs/algorithms/moving.md.

#include <optional>
#include <string>

#include "vandplan/moving.h"
#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan {

/// Claims about a drive, which the judge checks.
struct DriveClaims {
  double margin = 0.0;  ///< least distance of the footprint from moving obstacles [m]
  /// Speed with which the vehicle comes to the start, in the gear of the first segment [m/s].
  double start_speed = 0.0;
};

/// Verdict of the judge on a drive.
struct DriveCheck {
  bool valid = false;                ///< whether no fault was found
  std::string reason = {};           ///< first fault that was found, one line; empty when valid
  std::optional<double> t = {};      ///< time of the fault, if it has one [s]
  std::optional<PathPoint> at = {};  ///< place of the vehicle at that time, in the scenario's frame
  double duration = 0.0;             ///< duration of the drive [s]
  /// Least distance between the footprint and the grown outline of any moving obstacle [m]. It may
  /// be too large by 1 mm and a twentieth of the distance. It is 0 if they touch, infinite if
  /// nothing moves. None if the times were found wrong before.
  std::optional<double> clearance = {};
};

/// Judges the times of a drive in the scenario's frame, whose path `check_path` accepts. A fault is
/// no exception: the first one is in `reason`. The judge checks in this order:
///
/// - Every number is finite, and speeds and distances follow from each other.
/// - The drive covers the whole path, from the claimed speed to standing.
/// - It keeps `Vehicle::limits` (to 1e-6 of them). With `max_jerk` the acceleration jumps nowhere.
/// - It stands where the gear changes. Where the curvature jumps, it stands until the wheels are
///   turned.
/// - Neither on the way nor ever after does it touch a moving obstacle, or come nearer than
///   claimed.
[[nodiscard]] DriveCheck check_drive(const Problem& problem, const TimedPath& drive,
                                     const DriveClaims& claims = {});

/// Judges only which moving obstacles are met on a drive and ever after. It is for what was driven
/// rather than planned. A fault is no exception: the first one is in `reason`. The knots must
/// follow from each other.
[[nodiscard]] DriveCheck check_company(const Problem& problem, const TimedPath& drive,
                                       const DriveClaims& claims = {});

}  // namespace vandplan
