// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far are the wheels to be turned, and how hard to accelerate, to stay on a stroke?
//
// Sources and derivations: docs/algorithms/drive.md.

#include <string_view>

#include "drive/plant.h"
#include "drive/stroke.h"
#include "drive/towing.h"
#include "vandplan/drive.h"

namespace vandplan::driving {

/// What a controller sees.
struct Sight {
  const Stroke& stroke;
  const Vehicle& vehicle;
  const State& state;
  Offset offset;        ///< of the state's pose from the stroke
  double behind = 0.0;  ///< so far before the stroke the vehicle began to drive it [m]; >= 0
  const Towing* towing = nullptr;  ///< of the trailer, if there is one
};

/// A way to steer: the angle that the wheels are to have at the end of the control period [rad].
struct Controller {
  ControllerInfo info;
  double (*steering_angle)(const Sight& sight) noexcept;
};

/// The one with that name. Throws InputError naming "controller".
[[nodiscard]] const Controller& controller_named(std::string_view name);

/// The distance within which errors are to fade [m].
[[nodiscard]] inline double fading_distance(const Vehicle& vehicle) noexcept {
  return vehicle.wheelbase / 2;
}

/// The acceleration that brings the vehicle to the planned speed of the place where it will be at
/// the end of the control period, and to stand exactly at the end of the stroke; less where the
/// wheels are far from where they are wanted [m/s^2].
[[nodiscard]] double acceleration(const Sight& sight, double wanted_steering) noexcept;

}  // namespace vandplan::driving
