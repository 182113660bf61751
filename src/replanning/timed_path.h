// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a drive cut in two, and how are two drives joined?

#include "vandplan/motion.h"
#include "vandplan/vehicle.h"

namespace vandplan::replanning {

/// Motion of a vehicle with its trailer.
struct RigMotion : Motion {
  double hitch_angle = 0.0;  ///< hitch angle [rad]; 0 without a trailer
};

/// Part of a drive, which may begin in motion.
struct CutDrive {
  TimedPath drive;
  RigMotion begin;  ///< state at the begin of the drive
};

/// Rest of a drive from time `t` on [s]; `t` is clamped to the drive, which begins with
/// `hitch_angle` [rad].
[[nodiscard]] CutDrive rest_of(const TimedPath& drive, const Vehicle& vehicle, double t,
                               double hitch_angle = 0.0);

/// Part of a drive before time `t` [s], which is clamped to the drive. It may end in motion.
[[nodiscard]] TimedPath before(const TimedPath& drive, const Vehicle& vehicle, double t);

/// Drive `first`, followed by drive `then`.
[[nodiscard]] TimedPath joined(const TimedPath& first, const TimedPath& then);

/// Hitch angle after the segments [rad]; `angle` is that before them.
[[nodiscard]] double hitch_angle_after(const Vehicle& vehicle, double angle,
                                       std::span<const Segment> segments);

/// Drive of no duration that stands at `pose`.
[[nodiscard]] TimedPath standing_at(const Pose& pose);

}  // namespace vandplan::replanning
