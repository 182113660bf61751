// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a robot of ROS become a vehicle?

#include <optional>

#include "vandplan/geometry.h"
#include "vandplan/vehicle.h"

namespace vandplan::ros {

/// What ROS says of a robot's body, in the frame `base_link` with x ahead.
struct Robot {
  Polygon footprint = {};             ///< corners of the body [m]; ignored with a radius
  std::optional<double> radius = {};  ///< radius of a round body around base_link [m]; > 0
};

/// What a footprint does not say of a vehicle.
struct Chassis {
  double min_turning_radius = 0.4;  ///< of the midpoint of the rear axle [m]; > 0
  /// Rear axle to front axle [m]; > 0. None: the front axle is at the front of the body.
  std::optional<double> wheelbase = {};
  double rear_axle = 0.0;  ///< x of the rear axle in the frame base_link [m]
  DrivingLimits limits = {};
};

/// The vehicle of a robot. Its body is the footprint if that is convex, otherwise the hull of the
/// footprint. A round body becomes the least regular polygon of 16 sides that holds it. Throws
/// InputError naming "footprint" for a body that is none or does not hold the rear axle,
/// "wheelbase" if the front of the body is behind the rear axle, or as `check_vehicle`.
[[nodiscard]] Vehicle vehicle_of(const Robot& robot, const Chassis& chassis);

}  // namespace vandplan::ros
