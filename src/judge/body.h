// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How near are obstacles to the vehicle or its trailer on a track, in the eyes of the judge?

#include "judge/ground.h"
#include "judge/track.h"
#include "judge/trailing.h"

namespace vandplan::judge {

/// Rigid body that moves along a track: the vehicle or its trailer. References must outlive it.
struct Body {
  const Track& track;
  const Ground& ground;
  Outlines outlines;
  const Trailing* trailing = nullptr;  ///< motion of the trailer; null: the body is the vehicle
};

/// A body at a place of its track, with its view of the world.
struct Onlooker {
  const Body& body;
  const Stretch& stretch;
  View view;
};

[[nodiscard]] Onlooker onlooker_at(const Body& body, const Place& place);

/// Lower bound of the clearance of a body at all places up to `half` metres before and after its
/// own [m]. If `half` is 0, it is exact. Values are cut off at `most`.
[[nodiscard]] double clearance_of(const Onlooker& onlooker, double half, double most,
                                  Effort& effort);

/// Clearance of a body at one place [m], cut off at `most`.
[[nodiscard]] double clearance_of(const Body& body, const Place& place, double most,
                                  Effort& effort);

/// Upper bound of the motion of any point of the body on a stretch, per metre driven.
[[nodiscard]] double speed_of(const Body& body, const Stretch& stretch);

/// Length of a stretch that has to be checked [m]. An arc repeats itself after a full turn, unless
/// a trailer follows.
[[nodiscard]] Real length_to_look_at(const Body& body, const Stretch& stretch);

/// First obstacle, kerb or map that is at most `distance` [m] from the body at a place.
[[nodiscard]] Thing first_within(const Body& body, double distance, const Place& place);

}  // namespace vandplan::judge
