// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/body.h"

#include <algorithm>
#include <cmath>

namespace vandplan::judge {

Position position_of(const Body& body, const Place& place) {
  if (body.trailing != nullptr) return body.trailing->position(place);
  return after(body.track.stretches[place.stretch], place.t);
}

double clearance_of(const Body& body, const Place& place, double half, double most,
                    Effort& effort) {
  const Stretch& stretch = body.track.stretches[place.stretch];
  const Position position = position_of(body, place);
  if (body.trailing == nullptr) {
    const auto curvature = static_cast<double>(curvature_at(stretch, place.t));
    const auto rate = static_cast<double>(stretch.rate);
    return body.ground.clearance({position, curvature, half, rate}, body.outlines, most, effort);
  }
  const double moved = half * speed_of(body, stretch);
  const double here = body.ground.clearance({position}, body.outlines, most + moved, effort);
  return std::clamp(here - moved, 0.0, most);
}

double speed_of(const Body& body, const Stretch& stretch) {
  const double reach = std::max(reach_of(body.outlines.body), reach_of(body.outlines.wheels));
  if (body.trailing != nullptr) return body.trailing->speed(stretch, reach);
  return 1 + static_cast<double>(steepest(stretch)) * reach;
}

Real length_to_look_at(const Body& body, const Stretch& stretch) {
  if (stretch.rate != 0 || body.trailing != nullptr) return stretch.length;
  const Real curvature = std::abs(stretch.curvature);
  return curvature * stretch.length > full_turn ? full_turn / curvature : stretch.length;
}

Thing first_within(const Body& body, double distance, const Place& place) {
  Thing thing = body.ground.first_within(distance, position_of(body, place), body.outlines);
  if (body.trailing != nullptr) thing.part = "the trailer's " + thing.part.substr(4);
  return thing;
}

}  // namespace vandplan::judge
