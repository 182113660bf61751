// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/closed_areas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polygon.h"

namespace vandplan::search {

// A zone for the whole body is farther from the centre than the disc reaches. One for the rear axle
// may hold the centre, which is `ahead` metres from it.
std::vector<ClosedArea> closed_areas(const Task& task, const Disc& disc, GearSign only) {
  const AllowedGears wrong = only > 0 ? AllowedGears::reverse : AllowedGears::forward;
  const Point ends[] = {centre_of(disc, task.start), centre_of(disc, task.goal)};
  std::vector<ClosedArea> areas;
  for (const Zone& zone : task.world->local().zones) {
    if (!zone.closed && (only == 0 || zone.gears != wrong)) continue;
    ClosedArea closed{zone.area, zone.body ? disc.radius : -std::abs(disc.ahead)};
    const bool holds_end = std::any_of(std::begin(ends), std::end(ends), [&](const Point& end) {
      return geometry::distance_from_border(zone.area, end) < closed.near;
    });
    if (!holds_end) areas.push_back(std::move(closed));
  }
  return areas;
}

}  // namespace vandplan::search
