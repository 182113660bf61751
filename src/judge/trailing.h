// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where is the trailer while its tractor drives, in the eyes of the judge?
//
// By numerical integration, where planners have closed forms: docs/algorithms/path_check.md.

#include <optional>
#include <vector>

#include "judge/track.h"
#include "vandplan/vehicle.h"

namespace vandplan::judge {

/// A trailer that is pulled along a track.
class Trailing {
 public:
  /// The vehicle has a trailer; it and the track outlive this.
  Trailing(const Track& track, const Vehicle& vehicle, double start_angle);

  /// Heading of the tractor - heading of the trailer, whole turns included [rad].
  [[nodiscard]] Real angle(const Place& place) const;

  /// The midpoint of the trailer's axle and where the trailer points.
  [[nodiscard]] Position position(const Place& place) const;

  /// At the end of the track [rad].
  [[nodiscard]] Real end_angle() const { return end_angle_; }

  /// The largest |angle| looked at [rad].
  [[nodiscard]] Real largest_angle() const;

  /// The first place looked at where the angle is larger than that [rad].
  [[nodiscard]] std::optional<Place> first_beyond(Real limit) const;

  /// No point within `reach` of the trailer's axle [m] moves further on a stretch than this for
  /// each metre that the tractor drives.
  [[nodiscard]] double speed(const Stretch& stretch, double reach) const;

 private:
  /// Angles at even distances on a stretch.
  struct Angles {
    Real step = 0;
    std::vector<Real> at;
  };

  [[nodiscard]] Real rate(const Stretch& stretch, Real t, Real angle) const;
  [[nodiscard]] Real driven(const Stretch& stretch, Real t, Real step, Real angle) const;

  const Track& track_;
  Real hitch_, wheelbase_;
  std::vector<Angles> angles_;  ///< of each stretch
  Real end_angle_ = 0;
};

}  // namespace vandplan::judge
