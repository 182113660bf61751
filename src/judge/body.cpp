// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/body.h"

#include <algorithm>
#include <cmath>

namespace vandplan::judge {

Onlooker onlooker_at(const Body& body, const Place& place) {
  const Stretch& stretch = body.track.stretches[place.stretch];
  if (body.trailing != nullptr) return {body, stretch, view_of({body.trailing->position(place)})};
  const auto [position, heading] = placement_after(stretch, place.t);
  const auto curvature = static_cast<double>(curvature_at(stretch, place.t));
  const auto rate = static_cast<double>(stretch.rate);
  return {body, stretch, view_of({position, curvature, 0, rate}, heading)};
}

double clearance_of(const Onlooker& onlooker, double half, double most, Effort& effort) {
  const auto& [body, stretch, here] = onlooker;
  if (body.trailing == nullptr) {
    View view = here;
    view.passage.half = half;
    return body.ground.clearance(view, body.outlines, most, effort);
  }
  const double moved = half * speed_of(body, stretch);
  const double clearance = body.ground.clearance(here, body.outlines, most + moved, effort);
  return std::clamp(clearance - moved, 0.0, most);
}

double clearance_of(const Body& body, const Place& place, double most, Effort& effort) {
  return clearance_of(onlooker_at(body, place), 0, most, effort);
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
  Thing thing = body.ground.first_within(distance, onlooker_at(body, place).view, body.outlines);
  if (body.trailing != nullptr) thing.part = "the trailer's " + thing.part.substr(4);
  return thing;
}

}  // namespace vandplan::judge
