// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/provers.h"

#include <algorithm>
#include <limits>

namespace vandplan::anytime {

LengthProver::LengthProver(const Task& task, search::GearSign only)
    : task_(task), only_(only), best_cost_(std::numeric_limits<double>::infinity()) {}

Found LengthProver::work(std::int64_t iterations, const Told& told, const search::Budget& budget) {
  if (told.best != nullptr) best_cost_ = std::min(best_cost_, told.best->cost);
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
    barrier_.emplace(*bodies_.front().task, only_);
  }
  std::int64_t all = 0;
  while (all < steps && !budget.is_interrupted() && barrier_->step()) ++all;
  for (search::Enclosure& enclosure : enclosures_) {
    std::int64_t done = 0;
    while (done < steps && !budget.is_interrupted() && enclosure.step()) ++done;  // [8]
    all += done;
  }
  return all;
}

Proven WallProver::proven() const {
  if (barrier_ && barrier_->is_proven()) return {.walled_in = "nothing that keeps to the zones"};
  for (std::size_t i = 0; i < enclosures_.size(); ++i) {
    if (enclosures_[i].is_proven()) return {.walled_in = bodies_[i].name};
  }
  return {};
}

}  // namespace vandplan::anytime
