// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/provers.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>

#include "planners/anytime/shares.h"
#include "search/enclosure.h"
#include "search/geodesic.h"
#include "search/pose_flood.h"
#include "search/zone_bound.h"

namespace vandplan::anytime {
namespace {

class LengthProver final : public Worker {
 public:
  LengthProver(const Task& task, search::GearSign only) : task_(task), only_(only) {}

  [[nodiscard]] bool has_work() const override { return !geodesic_ || !geodesic_is_final_; }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const search::Budget& budget) override;
  std::int64_t prove(std::int64_t steps, const search::Budget& budget) override;
  [[nodiscard]] Proven proven() const override;

 private:
  const Task& task_;
  search::GearSign only_;
  /// Bounds of a disc and of the vehicle; both none before the first iteration.
  std::optional<search::Geodesic> geodesic_;
  std::optional<search::PoseFlood> flood_;
  bool geodesic_is_final_ = false, flood_is_final_ = false;
  /// Least cost of all routes that the worker knows.
  double best_cost_ = std::numeric_limits<double>::infinity();
};

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

class WallProver final : public Worker {
 public:
  WallProver(const Task& task, const Task* towed, search::GearSign only)
      : task_(task), towed_(towed), only_(only) {}

  std::int64_t prove(std::int64_t steps, const search::Budget& budget) override;
  [[nodiscard]] Proven proven() const override;

 private:
  const Task& task_;
  const Task* towed_;
  search::GearSign only_;
  /// Bodies: the vehicle, and its trailer if there is one. None before the first step.
  std::deque<search::Enclosure> enclosures_;
  std::optional<search::ZoneBound> zones_;  // none before the first step
};

std::int64_t WallProver::prove(std::int64_t steps, const search::Budget& budget) {
  if (enclosures_.empty()) {
    enclosures_.emplace_back(task_);
    if (towed_ != nullptr) enclosures_.emplace_back(*towed_);
    zones_.emplace(task_, only_);
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
  if (!zones_) return {};
  if (zones_->is_proven()) return {.walled_in = "nothing that keeps to the zones"};
  if (enclosures_.front().is_proven()) return {.walled_in = "nothing as wide as the vehicle"};
  if (enclosures_.back().is_proven()) return {.walled_in = "nothing as wide as the trailer"};
  return {};
}

class ZoneProver final : public Worker {
 public:
  ZoneProver(const Task& task, const planning::Pricing& pricing, bool knows_length)
      : task_(task), pricing_(pricing), knows_length_(knows_length) {}

  std::int64_t prove(std::int64_t steps, const search::Budget& budget) override;
  [[nodiscard]] Proven proven() const override;

 private:
  [[nodiscard]] bool bounds_length() const;

  const Task& task_;
  const planning::Pricing& pricing_;
  bool knows_length_;
  std::optional<search::ZoneBound> added_, all_;  // none before the first step
};

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

}  // namespace

std::unique_ptr<Worker> length_prover(const Task& task, search::GearSign only) {
  return std::make_unique<LengthProver>(task, only);
}

std::unique_ptr<Worker> wall_prover(const Task& task, const Task* towed, search::GearSign only) {
  return std::make_unique<WallProver>(task, towed, only);
}

bool has_rules_of_ground(const Task& task) {
  const Surroundings& ground = task.world->local();
  return !ground.zones.empty() || !ground.masks.empty();
}

std::unique_ptr<Worker> zone_prover(const Task& task, const planning::Pricing& pricing,
                                    bool knows_length) {
  return std::make_unique<ZoneProver>(task, pricing, knows_length);
}

Share share_of_zone_prover() {
  return [](const Progress& now) {
    return now.has_path ? growing_share(shares::zone_steps, now.rounds_with_path) : 0;
  };
}

}  // namespace vandplan::anytime
