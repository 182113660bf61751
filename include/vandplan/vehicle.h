// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lengths describe the vehicle, and where is its footprint?

#include <array>
#include <optional>

#include "vandplan/geometry.h"

namespace vandplan {

/// A rigid vehicle steered at the front; the field names are keys of a scenario file. [m]
struct Vehicle {
  double wheelbase = 4.5;           ///< rear axle to front axle; > 0
  double front_overhang = 1.4;      ///< front axle to front bumper; >= 0
  double rear_overhang = 1.6;       ///< rear axle to rear bumper; >= 0
  double width = 2.55;              ///< > 0
  double min_turning_radius = 7.0;  ///< of the rear-axle midpoint at full steering; > 0
  /// Over the wheels of an axle; none: the width; > 0, at most the width.
  std::optional<double> track_width = {};
  bool operator==(const Vehicle&) const = default;
};

/// A rectangle in the vehicle frame (origin at the rear-axle midpoint, x forward): x from `-rear`
/// to `front`, y from `-half_width` to `half_width`. Closed. [m]
struct Footprint {
  double rear = 0.0;
  double front = 0.0;
  double half_width = 0.0;
  bool operator==(const Footprint&) const = default;
};

/// The outline of the whole body.
[[nodiscard]] Footprint footprint(const Vehicle& vehicle) noexcept;

/// The outline of the wheels: between the axles, as wide as the track. What a kerb must not enter.
[[nodiscard]] Footprint wheel_footprint(const Vehicle& vehicle) noexcept;

/// Least distance from the rear axle's midpoint to the outline [m]: it stays that far from whatever
/// the footprint does not touch.
[[nodiscard]] double inner_radius(const Footprint& footprint) noexcept;

/// The four corners at a pose, counter-clockwise from the rear right one.
[[nodiscard]] std::array<Point, 4> corners(const Footprint& footprint, const Pose& pose) noexcept;

}  // namespace vandplan
