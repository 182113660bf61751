// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which steering angle and acceleration keep a vehicle on a stroke?
//
// Sources and derivations: docs/algorithms/drive.md.

#include <string_view>

#include "drive/plant.h"
#include "drive/stroke.h"
#include "drive/towing.h"
#include "vandplan/drive.h"

namespace vandplan::driving {

/// Input of a controller: stroke, vehicle, and its state beside the stroke.
struct Sight {
  const Stroke& stroke;
  const Vehicle& vehicle;
  const MovingState& state;
  Offset offset;  ///< offset of the state's pose from the stroke
  /// Distance before the stroke at which the vehicle began to drive it [m]; >= 0.
  double behind = 0.0;
  const Towing* towing = nullptr;  ///< trailer along the stroke; null without a trailer
};

/// Steering law: the wanted steering angle at the end of the control period [rad].
struct Controller {
  ControllerInfo info;
  double (*steering_angle)(const Sight& sight) noexcept;
};

/// Controller with the given name. Throws InputError naming "controller" if there is none.
[[nodiscard]] const Controller& controller_named(std::string_view name);

/// Distance within which errors shall fade [m].
[[nodiscard]] inline double fading_distance(const Vehicle& vehicle) noexcept {
  return vehicle.wheelbase / 2;
}

/// Acceleration that reaches the planned speed of the place at the end of the control period
/// [m/s^2]. The vehicle comes to stand exactly at the end of the stroke. It drives slower while the
/// wheels are far from the wanted steering angle [rad].
[[nodiscard]] double acceleration(const Sight& sight, double wanted_steering) noexcept;

}  // namespace vandplan::driving
