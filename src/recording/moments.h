// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which moments and events does a drive have?

#include <span>
#include <string>
#include <vector>

#include "recording/messages.h"
#include "vandplan/recording.h"

namespace vandplan::recording {

/// An event of a drive.
struct Event {
  double t = 0.0;  ///< time since the start of the drive [s]
  Level level = Level::info;
  std::string text;
};

/// Start, stops, gear changes, contact and end of a drive, in the order of their times.
[[nodiscard]] std::vector<Event> events_of(const RecordedDrive& drive);

/// Moments of the drive along the path of `plan`, with its speeds. If it has none, the drive is the
/// fastest one. Must have a path.
[[nodiscard]] std::vector<DriveMoment> planned_moments(const Scenario& scenario,
                                                       const PlanResult& plan);

/// The log in a frame with the origin `origin`. Throws InputError naming "drive" if it is empty, a
/// number is not finite, or t decreases.
[[nodiscard]] std::vector<DriveMoment> moved_to(std::span<const DriveMoment> log,
                                                const Point& origin);
/// The result in a frame with the origin `origin`. Throws InputError naming "plan" if a number is
/// not finite.
[[nodiscard]] PlanResult moved_to(const PlanResult& plan, const Point& origin);

}  // namespace vandplan::recording
