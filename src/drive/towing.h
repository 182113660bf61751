// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a tractor steer so that its trailer follows its path, in reverse too?
//
// Derivation: docs/lab/drive.md.

#include <array>
#include <vector>

#include "drive/stroke.h"
#include "vandplan/vehicle.h"

namespace vandplan::driving {

/// Errors of a rig: lateral to the left [m], heading to the left [rad], hitch angle [rad],
/// curvature [1/m]. Each is the real value less the planned one.
using RigError = std::array<double, 4>;

/// Planned hitch angles along a stroke, and linear-quadratic optimal feedback around them.
class Towing {
 public:
  /// `vehicle` has a trailer and is kept by reference. The stroke begins with `hitch_angle` [rad].
  Towing(const Stroke& stroke, const Vehicle& vehicle, double hitch_angle);

  /// Planned hitch angle after `s` metres [rad]; beyond the stroke that of its end.
  [[nodiscard]] double hitch_angle_at(double s) const noexcept;

  /// Feedback after `s` metres: the change of curvature per driven metre that reduces `error`
  /// [1/m^2].
  [[nodiscard]] double correction(double s, const RigError& error) const noexcept;

 private:
  struct Step {
    Segment arc = {};  // arc to the next step
    double hitch_angle = 0.0;
    RigError gains = {};
  };
  [[nodiscard]] const Step& before(double s) const noexcept;

  const Vehicle& vehicle_;
  int direction_;
  double size_ = 0.0;  // length of a step [m]
  std::vector<Step> steps_;
};

}  // namespace vandplan::driving
