// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a drive cut in two, and how are two drives joined?

#include "vandplan/moving.h"
#include "vandplan/vehicle.h"

namespace vandplan::replanning {

/// Part of a drive, which may begin in motion.
struct CutDrive {
  TimedPath drive;
  Motion begin;  ///< state at the begin of the drive
};

/// Rest of a drive from time `t` on [s]; `t` is clamped to the drive.
[[nodiscard]] CutDrive rest_of(const TimedPath& drive, const Vehicle& vehicle, double t);

/// Part of a drive before time `t` [s], which is clamped to the drive. It may end in motion.
[[nodiscard]] TimedPath before(const TimedPath& drive, const Vehicle& vehicle, double t);

/// Drive `first`, followed by drive `then`.
[[nodiscard]] TimedPath joined(const TimedPath& first, const TimedPath& then);

/// Segments of the part of a path from `begin` to `end` [m].
[[nodiscard]] std::vector<Segment> cut(std::span<const Segment> segments, double begin, double end);

/// Drive of no duration that stands at `pose`.
[[nodiscard]] TimedPath standing_at(const Pose& pose);

}  // namespace vandplan::replanning
