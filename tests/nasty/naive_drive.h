// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does a drive meet what moves, in the eyes of the naive judge?

#include <string>

#include "vandplan/motion.h"
#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan::nasty {

/// Only an obstacle that comes nearer than the margin by more than this is met [m].
inline constexpr double allowed_nearness = 1.2e-3;

/// What is wrong with the times of a drive among the moving obstacles of a scenario; empty if
/// nothing is. It looks at 20 000 moments, also after the drive, and overlooks what happens between
/// them. It shares no code with the judge, and measures distances by sides.
[[nodiscard]] std::string naive_flaw_of_drive(const Scenario& scenario, const TimedPath& drive,
                                              double margin);

/// The obstacle that comes nearer than `margin` [m] at time 0 to the vehicle at the start of the
/// path; empty if there is none.
[[nodiscard]] std::string naive_meeting_at_start(const Scenario& scenario, double margin);

}  // namespace vandplan::nasty
