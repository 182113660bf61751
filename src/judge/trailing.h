// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where is the trailer while its tractor drives, in the eyes of the judge?
//
// The judge integrates numerically, where planners have closed forms:
// docs/algorithms/path_check.md.

#include <optional>
#include <vector>

#include "judge/track.h"
#include "vandplan/vehicle.h"

namespace vandplan::judge {

/// Motion of a trailer that is pulled along a track.
class Trailing {
 public:
  /// `vehicle` has a trailer. `track` is kept by reference. `start_angle` is the hitch angle at the
  /// start [rad].
  Trailing(const Track& track, const Vehicle& vehicle, double start_angle);

  /// Hitch angle: heading of the tractor less heading of the trailer, whole turns included [rad].
  [[nodiscard]] Real angle(const Place& place) const;

  /// Change of the hitch angle per metre driven [rad/m].
  [[nodiscard]] Real rate(const Place& place) const {
    return rate(track_.stretches[place.stretch], place.t, angle(place));
  }

  /// Midpoint of the trailer's axle, with the heading of the trailer.
  [[nodiscard]] Position position(const Place& place) const;

  /// Hitch angle at the end of the track [rad].
  [[nodiscard]] Real end_angle() const { return end_angle_; }

  /// Largest absolute hitch angle at the integration steps [rad].
  [[nodiscard]] Real largest_angle() const;

  /// First integration step at which the absolute hitch angle exceeds `limit` [rad]; none if there
  /// is none.
  [[nodiscard]] std::optional<Place> first_beyond(Real limit) const;

  /// Upper bound of the motion of any point within `reach` of the trailer's axle [m], per metre
  /// that the tractor drives on a stretch.
  [[nodiscard]] double speed(const Stretch& stretch, double reach) const;

 private:
  /// Hitch angles at equal distances on a stretch.
  struct Angles {
    Real step = 0;
    std::vector<Real> at;
  };

  [[nodiscard]] Real rate(const Stretch& stretch, Real t, Real angle) const;
  [[nodiscard]] Real driven(const Stretch& stretch, Real t, Real step, Real angle) const;

  const Track& track_;
  Real hitch_, wheelbase_;
  std::vector<Angles> angles_;  ///< hitch angles of each stretch
  Real end_angle_ = 0;
};

}  // namespace vandplan::judge
