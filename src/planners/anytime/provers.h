// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which workers prove a lower bound, or that there is no path?

#include <deque>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "planners/anytime/portfolio.h"
#include "planners/anytime/worker.h"
#include "planners/pricing.h"
#include "search/enclosure.h"
#include "search/geodesic.h"
#include "search/pose_flood.h"
#include "search/zone_bound.h"

namespace vandplan::anytime {

/// Proves a lower bound of the length of all paths. Iterations bound the way around obstacles of a
/// disc, which may turn at once. Steps bound the way of the vehicle, with its headings.
class LengthProver final : public Worker {
 public:
  /// `only`: gear of all paths; 0: both gears. The task outlives the worker.
  LengthProver(const Task& task, search::GearSign only);

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
  double best_cost_;  // least cost of all routes that the worker knows
};

/// Proves that nothing as wide as one of the bodies gets from the start to the goal, or that rules
/// of zones forbid it.
class WallProver final : public Worker {
 public:
  /// One body of the vehicle.
  struct Body {
    const Task* task = nullptr;  ///< task of the body alone; outlives the worker
    std::string_view name = {};  ///< what is as wide, for the reason of an answer
  };
  /// The first body is the vehicle itself. `only`: gear of all paths; 0: both gears.
  WallProver(std::vector<Body> bodies, search::GearSign only)
      : bodies_(std::move(bodies)), only_(only) {}

  std::int64_t prove(std::int64_t steps, const search::Budget& budget) override;
  [[nodiscard]] Proven proven() const override;

 private:
  std::vector<Body> bodies_;
  search::GearSign only_;
  std::deque<search::Enclosure> enclosures_;  // one for each body; none before the first step
  std::optional<search::ZoneBound> zones_;    // none before the first step
};

/// Whether zones or masks say anything.
[[nodiscard]] bool has_rules_of_ground(const Task& task);

/// Proves what zones and masks add to the cost of all paths, or to their length, if there are only
/// rules.
class ZoneProver final : public Worker {
 public:
  /// Task and pricing outlive the worker. `knows_length`: whether lengths are bounded at all.
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

/// Steps of the zone prover in a round.
[[nodiscard]] Share share_of_zone_prover();

}  // namespace vandplan::anytime
