// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/ground.h"

#include <algorithm>

namespace vandplan::judge {

Outlines outlines_of(const Vehicle& vehicle) {
  const double track = vehicle.track_width.value_or(vehicle.width);
  return {.body = {-vehicle.rear_overhang, vehicle.wheelbase + vehicle.front_overhang,
                   -vehicle.width / 2, vehicle.width / 2},
          .wheels = {0.0, vehicle.wheelbase, -track / 2, track / 2}};
}

Ground::Ground(const Surroundings& surroundings)
    : obstacles_(surroundings.obstacles),
      kerbs_(surroundings.kerbs),
      is_empty_(surroundings.obstacles.empty() && surroundings.kerbs.empty() && !surroundings.map) {
  if (surroundings.map) cells_.emplace(*surroundings.map);
}

double Ground::clearance(const Passage& passage, const Outlines& outlines, double most,
                         Effort& effort) const {
  ++effort.looks;
  const View view = view_of(passage);
  const double aside = deviation(passage, outlines.body);
  double least = obstacles_.clearance(view, outlines.body, most + aside, effort);
  if (least > 0) least = kerbs_.clearance(view, outlines.wheels, least, effort);
  if (least > 0 && cells_) least = cells_->clearance(view, outlines.body, least, effort);
  return std::clamp(least - aside, 0.0, most);
}

std::string Ground::hit_at(const Position& position, const Outlines& outlines) const {
  const View view = view_of({position});
  if (const auto first = obstacles_.first_touched(view, outlines.body)) {
    return "the footprint hits obstacles[" + std::to_string(*first) + "]";
  }
  if (const auto first = kerbs_.first_touched(view, outlines.wheels)) {
    return "the wheels hit kerbs[" + std::to_string(*first) + "]";
  }
  return "the footprint hits the map";
}

}  // namespace vandplan::judge
