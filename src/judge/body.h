// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What drives along the track, the vehicle or the trailer that it pulls, and how near are things?

#include "judge/ground.h"
#include "judge/track.h"
#include "judge/trailing.h"

namespace vandplan::judge {

/// A rigid part of what drives; the parts live as long as they are used.
struct Body {
  const Track& track;
  const Ground& ground;
  Outlines outlines;
  const Trailing* trailing = nullptr;  ///< of the trailer; null: this is the vehicle itself
};

/// A body in a place, ready to look around.
struct Onlooker {
  const Body& body;
  const Stretch& stretch;
  View view;
};

[[nodiscard]] Onlooker onlooker_at(const Body& body, const Place& place);

/// Between the body and the nearest thing that it must not touch [m], never more than `most`; if
/// `half` is not 0 no more than that anywhere up to `half` metres before and after the place.
[[nodiscard]] double clearance_of(const Onlooker& onlooker, double half, double most,
                                  Effort& effort);

/// The same at a place alone.
[[nodiscard]] double clearance_of(const Body& body, const Place& place, double most,
                                  Effort& effort);

/// No point of the body moves further on a stretch than this for each metre driven.
[[nodiscard]] double speed_of(const Body& body, const Stretch& stretch);

/// How much of a stretch has to be looked at: after one full turn an arc repeats itself, unless
/// something trails behind.
[[nodiscard]] Real length_to_look_at(const Body& body, const Stretch& stretch);

/// Something at a place that is at most so far from the body [m].
[[nodiscard]] Thing first_within(const Body& body, double distance, const Place& place);

}  // namespace vandplan::judge
