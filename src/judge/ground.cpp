// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/ground.h"

#include <algorithm>
#include <string>

namespace vandplan::judge {

Outlines outlines_of(const Vehicle& vehicle) {
  const double track = vehicle.track_width.value_or(vehicle.width);
  const Outline rectangle{-vehicle.rear_overhang, vehicle.wheelbase + vehicle.front_overhang,
                          -vehicle.width / 2, vehicle.width / 2};
  return {.body = vehicle.outline.empty() ? rectangle : outline_with(vehicle.outline),
          .wheels = {0.0, vehicle.wheelbase, -track / 2, track / 2}};
}

Outlines outlines_of(const Trailer& trailer) {
  const double half_width = trailer.width / 2;
  const Outline rectangle{-trailer.rear_overhang, trailer.wheelbase + trailer.front_overhang,
                          -half_width, half_width};
  return {.body = trailer.outline.empty() ? rectangle : outline_with(trailer.outline),
          .wheels = {0.0, 0.0, -half_width, half_width}};
}

namespace {

/// Numbers of fences of areas, and of blocks of masks.
std::vector<Stand> stands_of(const Surroundings& surroundings) {
  std::vector<Stand> stands;
  for (std::size_t i = 0; i < surroundings.inside.size(); ++i) {
    stands.push_back(
        {surroundings.inside[i].size(),
         {"the edge of inside[" + std::to_string(i) + "]", "the footprint", {HitKind::inside, i}}});
  }
  for (std::size_t i = 0; i < surroundings.masks.size(); ++i) {
    stands.push_back({surroundings.masks[i].blocks,
                      {"masks[" + std::to_string(i) + "]", "the footprint", {HitKind::mask, i}}});
  }
  return stands;
}

}  // namespace

Ground::Ground(const Surroundings& surroundings)
    : stands_(stands_of(surroundings)),
      obstacles_(surroundings.obstacles),
      kerbs_(surroundings.kerbs),
      is_empty_(surroundings.obstacles.empty() && surroundings.kerbs.empty() && !surroundings.map) {
  if (surroundings.map) cells_.emplace(*surroundings.map);
}

std::string door_fault(const Problem& problem, double margin) {
  if (problem.world() == nullptr) return "the problem is empty, nobody made it";
  if (!(margin >= 0)) return "the stated margin is no distance >= 0";
  return "";
}

Ground::Ground(const Ground& before, const Surroundings& surroundings,
               std::span<const CellRange> cells)
    : stands_(before.stands_),
      obstacles_(surroundings.obstacles),
      kerbs_(surroundings.kerbs),
      cells_(before.cells_),
      is_empty_(surroundings.obstacles.empty() && surroundings.kerbs.empty() && !surroundings.map) {
  for (const CellRange& range : cells) cells_->update(range);
}

double Ground::clearance(const View& view, const Outlines& outlines, double most,
                         Effort& effort) const {
  ++effort.looks;
  const Passage& passage = view.passage;
  const double aside =
      std::max(deviation(passage, outlines.body), deviation(passage, outlines.wheels));
  double least = obstacles_.clearance(view, outlines.body, most + aside, effort);
  if (least > 0) least = kerbs_.clearance(view, outlines.wheels, least, effort);
  if (least > 0 && cells_) least = cells_->clearance(view, outlines.body, least, effort);
  return std::clamp(least - aside, 0.0, most);
}

Thing Ground::first_within(double distance, const View& view, const Outlines& outlines) const {
  if (const auto first = obstacles_.first_within(distance, view, outlines.body)) {
    std::size_t index = *first;
    for (const auto& [count, thing] : stands_) {
      if (index < count) return thing;
      index -= count;
    }
    return {
        "obstacles[" + std::to_string(index) + "]", "the footprint", {HitKind::obstacle, index}};
  }
  if (const auto first = kerbs_.first_within(distance, view, outlines.wheels)) {
    return {"kerbs[" + std::to_string(*first) + "]", "the wheels", {HitKind::kerb, *first}};
  }
  return {"the map", "the footprint", {HitKind::map}};
}

std::shared_ptr<const Ground> ground_of(const World& world) {
  return std::static_pointer_cast<const Ground>(
      world.kept(typeid(Ground), [&] { return std::make_shared<const Ground>(world.local()); }));
}

void renew_ground(const World& world, const Ground& before, std::span<const CellRange> cells) {
  (void)world.kept(typeid(Ground),
                   [&] { return std::make_shared<const Ground>(before, world.local(), cells); });
}

}  // namespace vandplan::judge
