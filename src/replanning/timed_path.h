// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a drive cut in two, and put together from two?

#include "vandplan/moving.h"
#include "vandplan/vehicle.h"

namespace vandplan::replanning {

/// A drive that has no end and no begin of its own.
struct CutDrive {
  TimedPath drive;
  Motion begin;  ///< how it begins
};

/// What is left of a drive at time `t` [s], clamped to it.
[[nodiscard]] CutDrive rest_of(const TimedPath& drive, const Vehicle& vehicle, double t);

/// What of a drive comes before time `t` [s], clamped to it: it need not end in a standstill.
[[nodiscard]] TimedPath before(const TimedPath& drive, const Vehicle& vehicle, double t);

/// One drive after the other.
[[nodiscard]] TimedPath joined(const TimedPath& first, const TimedPath& then);

/// The segments from `begin` to `end` metres of a path.
[[nodiscard]] std::vector<Segment> cut(std::span<const Segment> segments, double begin, double end);

/// Standing where a path begins.
[[nodiscard]] TimedPath standing_at(const Pose& pose);

}  // namespace vandplan::replanning
