// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a tractor steer so that its trailer stays where it should be, in reverse too?
//
// Derivation: docs/algorithms/drive.md.

#include <array>
#include <vector>

#include "drive/stroke.h"
#include "vandplan/vehicle.h"

namespace vandplan::driving {

/// How far a rig is from where it should be: to the left [m], turned to the left [rad], hitch angle
/// too large [rad], curvature too large [1/m].
using RigError = std::array<double, 4>;

/// The trailer of a stroke: where it should be, and the steering that is linear-quadratic optimal
/// around that.
class Towing {
 public:
  /// The vehicle has a trailer, and outlives this; it begins the stroke with that hitch angle.
  Towing(const Stroke& stroke, const Vehicle& vehicle, double hitch_angle);

  /// As it should be after `s` metres [rad]; before and after the stroke as at its ends.
  [[nodiscard]] double hitch_angle_at(double s) const noexcept;

  /// The change of the curvature per driven metre that takes an error away, after `s` metres
  /// [1/m^2].
  [[nodiscard]] double correction(double s, const RigError& error) const noexcept;

 private:
  struct Step {
    Segment arc = {};  // to the next one
    double hitch_angle = 0.0;
    RigError gains = {};
  };
  [[nodiscard]] const Step& before(double s) const noexcept;

  const Vehicle& vehicle_;
  int direction_;
  double size_ = 0.0;  // of a step [m]
  std::vector<Step> steps_;
};

}  // namespace vandplan::driving
