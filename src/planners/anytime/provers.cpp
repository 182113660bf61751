// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/provers.h"

#include <algorithm>
#include <limits>

#include "planners/anytime/shares.h"

namespace vandplan::anytime {

LengthProver::LengthProver(const Task& task, search::GearSign only)
    : task_(task), only_(only), best_cost_(std::numeric_limits<double>::infinity()) {}

Found LengthProver::work(std::int64_t iterations, const Told& told, const search::Budget& budget) {
  if (told.route != nullptr) best_cost_ = std::min(best_cost_, told.route->cost);
  if (!geodesic_ && iterations > 0) {
    geodesic_.emplace(task_, best_cost_, only_);
    flood_.emplace(task_, only_);
  }
  const auto step = [this]() -> std::optional<double> {
    geodesic_is_final_ = !geodesic_->step();  // [6]
    return std::nullopt;
  };
  return work_in_steps(
      iterations, told.enough, budget, [this] { return has_work(); }, step);
}

std::int64_t LengthProver::prove(std::int64_t steps, const search::Budget& budget) {
  std::int64_t done = 0;
  for (; done < steps && flood_ && !flood_is_final_; ++done) {
    if (done % steps_of_look == 0 && budget.is_interrupted()) break;
    flood_is_final_ = !flood_->step(best_cost_);
  }
  return done;
}

Proven LengthProver::proven() const {
  if (!geodesic_) return {};
  return {.shortest = geodesic_->bound(), .shortest_turn = flood_->bound()};
}

std::int64_t WallProver::prove(std::int64_t steps, const search::Budget& budget) {
  if (enclosures_.empty()) {
    for (const Body& body : bodies_) enclosures_.emplace_back(*body.task);
    zones_.emplace(*bodies_.front().task, only_);
  }
  std::int64_t all = 0;
  while (all < steps && !budget.is_interrupted() && zones_->step()) ++all;
  for (search::Enclosure& enclosure : enclosures_) {
    std::int64_t done = 0;
    while (done < steps && !budget.is_interrupted() && enclosure.step()) ++done;  // [8]
    all += done;
  }
  return all;
}

Proven WallProver::proven() const {
  if (zones_ && zones_->is_proven()) return {.walled_in = "nothing that keeps to the zones"};
  for (std::size_t i = 0; i < enclosures_.size(); ++i) {
    if (enclosures_[i].is_proven()) return {.walled_in = bodies_[i].name};
  }
  return {};
}

bool has_rules_of_ground(const Task& task) {
  const Surroundings& ground = task.world->local();
  return !ground.zones.empty() || !ground.masks.empty();
}

Share share_of_zone_prover() {
  return [](const Progress& now) {
    return now.has_path ? growing_share(shares::zone_steps, now.rounds_with_path) : 0;
  };
}

std::int64_t ZoneProver::prove(std::int64_t steps, const search::Budget& budget) {
  if (!added_) {
    const search::GearSign only = pricing_.rule().only_gear();
    added_.emplace(task_, only, pricing_.added_metre_cost());
    all_.emplace(task_, only,
                 bounds_length() ? search::MetreCost{.anywhere = 1.0} : pricing_.metre_cost());
  }
  std::int64_t done = 0;
  for (search::ZoneBound* bound : {&*added_, &*all_}) {
    while (done < steps && !budget.is_interrupted() && bound->step()) ++done;
  }
  return done;
}

Proven ZoneProver::proven() const {
  if (!added_) return {};
  if (bounds_length()) return {.shortest = all_->bound()};
  return {.added = added_->bound(), .in_zones = all_->bound()};
}

bool ZoneProver::bounds_length() const {
  const bool has_prices = task_.checker->has_prices() || task_.checker->has_speed_limits();
  return knows_length_ && !has_prices;
}

}  // namespace vandplan::anytime
