// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Worlds with zones and masks.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include "nasty/naive_zones.h"
#include "nasty/nasty_world.h"
#include "support/draws.h"
#include "support/grids.h"
#include "vandplan/random.h"

namespace vandplan::nasty {
namespace {

constexpr double pi = std::numbers::pi;

Point between_ends(const Scenario& scenario, double size, Rng& rng) {
  const Pose& start = scenario.start;
  const Pose& goal = scenario.goal;
  const double part = uniform(-0.2, 1.2, rng);
  return {start.x + part * (goal.x - start.x) + uniform(-1, 1, rng) * size,
          start.y + part * (goal.y - start.y) + uniform(-1, 1, rng) * size};
}

/// A star with deep dents, a needle, or one that is larger than all else.
Polygon nasty_zone_area(const Scenario& scenario, double size, Rng& rng) {
  const Point at = between_ends(scenario, size, rng);
  const int corners = 3 + static_cast<int>(any_size(1, 20, rng));
  const double radius = any_size(1e-3, 10, rng) * size;
  const double dent = any_size(0.01, 1, rng);
  const double flat = chance(0.3, rng) ? any_size(1e-4, 1, rng) : 1;
  Polygon area;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * pi * i / corners;
    const double r = radius * uniform(dent, 1, rng);
    area.push_back({at.x + r * std::cos(turn), at.y + flat * r * std::sin(turn)});
  }
  if (chance(0.3, rng)) std::reverse(area.begin(), area.end());
  return area;
}

Zone nasty_zone(const Scenario& scenario, double size, Rng& rng) {
  Zone zone{.area = nasty_zone_area(scenario, size, rng), .body = chance(0.4, rng)};
  const double kind = uniform01(rng);
  if (kind < 0.25) zone.closed = true;
  if (kind > 0.2 && kind < 0.5) {
    zone.gears = chance(0.5, rng) ? AllowedGears::forward : AllowedGears::reverse;
  }
  if (kind > 0.45 && kind < 0.75) {
    const double from = uniform(-7, 7, rng);
    zone.direction = HeadingRange{from, from + any_size(1e-3, 6.28, rng)};
  }
  if (kind > 0.7) zone.cost = any_size(1, 1000, rng);
  if (kind > 0.9) zone.max_speed = any_size(0.01, 10, rng);
  return zone;
}

Mask nasty_mask(const Scenario& scenario, double size, Rng& rng) {
  const auto cells = [&] { return static_cast<std::int32_t>(any_size(1, 30, rng)); };
  const std::int32_t columns = cells(), rows = cells();
  OccupancyGrid map = random_grid(columns, rows, any_size(0.02, 0.5, rng), rng);
  map.resolution = std::max(0.02, any_size(0.02, 2, rng) * size);
  const Point at = between_ends(scenario, size, rng);
  map.origin = {at.x, at.y, chance(0.4, rng) ? 0 : uniform(-pi, pi, rng)};
  const double kind = uniform01(rng);
  if (kind < 0.3) return {"", map};
  const auto count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  std::vector<std::uint8_t> percents(count);
  for (std::uint8_t& percent : percents) {
    percent = chance(0.3, rng) ? Mask::unknown : static_cast<std::uint8_t>(uniform(0, 100, rng));
  }
  Mask mask =
      kind < 0.8 ? cost_mask(map, any_size(0.1, 20, rng)) : speed_mask(map, any_size(0.1, 10, rng));
  mask.percents = std::make_shared<const std::vector<std::uint8_t>>(std::move(percents));
  return mask;
}

}  // namespace

Scenario nasty_world_of_zones(std::uint64_t seed) {
  Rng rng(stream_seed(seed, 5));
  const double kind = uniform01(rng);
  Scenario scenario = kind < 0.2   ? nasty_world_of_a_rig(seed)
                      : kind < 0.4 ? nasty_world_of_goals(seed)
                                   : nasty_world(seed);
  const double size = size_of(scenario.vehicle);
  const int zones = static_cast<int>(any_size(1, 7, rng));
  for (int i = 0; i < zones; ++i) {
    const Zone zone = nasty_zone(scenario, size, rng);
    Scenario alone{.vehicle = scenario.vehicle,
                   .start = scenario.start,
                   .goal = scenario.goal,
                   .hitch_angles = scenario.hitch_angles,
                   .zones = {zone}};
    const bool is_hit = !naive_look_at_zones(alone, {alone.start, {}}).flaw.empty() ||
                        !naive_look_at_zones({.vehicle = alone.vehicle,
                                              .start = alone.goal,
                                              .hitch_angles = {alone.hitch_angles.goal, 0},
                                              .zones = {zone}},
                                             {alone.goal, {}})
                             .flaw.empty();
    if (!is_hit || chance(0.05, rng)) scenario.zones.push_back(zone);
  }
  for (int i = chance(0.4, rng) ? 1 + (rng() % 2 == 0 ? 1 : 0) : 0; i > 0; --i) {
    scenario.masks.push_back(nasty_mask(scenario, size, rng));
  }
  return scenario;
}

}  // namespace vandplan::nasty
