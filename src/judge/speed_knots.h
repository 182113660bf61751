// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Do the knots of a drive agree with each other and with its path?

#include <optional>
#include <string>

#include "judge/track.h"
#include "vandplan/motion.h"

namespace vandplan::judge {

constexpr Real time_slack = 1e-6;      // tolerance of times [s]
constexpr Real distance_slack = 1e-6;  // tolerance of distances [m]
constexpr Real speed_slack = 1e-6;     // tolerance of speeds [m/s]

/// What is wrong with a drive, with time [s] and place if they are known.
struct DriveFault {
  std::string reason;
  std::optional<Real> t;
  std::optional<Place> place;
};

/// State of the motion after a knot: place [m], speed [m/s], acceleration [m/s^2].
struct Reached {
  Real s, v, a;
};

/// The motion `d` seconds after a knot.
[[nodiscard]] Reached after_knot(const SpeedKnot& knot, Real d);

/// First fault of the knots: their speeds and distances must agree, and cover the path exactly.
[[nodiscard]] std::optional<DriveFault> false_knots(const SpeedProfile& speeds, Real length,
                                                    Real start_speed);

/// First jump of the acceleration, which no limited jerk allows. Before and after the drive the
/// vehicle stands; if it comes with a speed, its acceleration then is unknown.
[[nodiscard]] std::optional<DriveFault> acceleration_jump(const SpeedProfile& speeds,
                                                          double start_speed);

}  // namespace vandplan::judge
