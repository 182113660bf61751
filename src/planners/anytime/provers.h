// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Who proves how short no path can be, and that there is none?

#include <optional>

#include "planners/anytime/worker.h"
#include "search/enclosure.h"
#include "search/geodesic.h"
#include "search/pose_flood.h"

namespace vandplan::anytime {

/// Proves how short no path can be: its iterations for a point that may turn at once, its steps for
/// a vehicle, which has to turn.
class LengthProver final : public Worker {
 public:
  /// The paths are in the gear `only`; 0: in both gears. The task outlives the worker.
  LengthProver(const Task& task, search::GearSign only);

  [[nodiscard]] bool has_work() const override { return !geodesic_ || !geodesic_is_final_; }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const search::Budget& budget) override;
  std::int64_t prove(std::int64_t steps, const search::Budget& budget) override;
  [[nodiscard]] Proven proven() const override;
  [[nodiscard]] Counts counts() const override { return {}; }

 private:
  const Task& task_;
  search::GearSign only_;
  std::optional<search::Geodesic> geodesic_;  // both none before the first iteration
  std::optional<search::PoseFlood> flood_;
  bool geodesic_is_final_ = false, flood_is_final_ = false;
  double best_cost_;  // of all routes that it knows of
};

/// Proves that nothing as wide as the vehicle gets from the start to the goal. It has no
/// iterations: what a budget of iterations brings does not depend on it.
class WallProver final : public Worker {
 public:
  /// The task outlives the worker.
  explicit WallProver(const Task& task) : task_(task) {}

  [[nodiscard]] bool has_work() const override { return false; }
  [[nodiscard]] Found work(std::int64_t, const Told&, const search::Budget&) override { return {}; }
  std::int64_t prove(std::int64_t steps, const search::Budget& budget) override;
  [[nodiscard]] Proven proven() const override {
    return {.is_walled_in = enclosure_ && enclosure_->is_proven()};
  }
  [[nodiscard]] Counts counts() const override { return {}; }

 private:
  const Task& task_;
  std::optional<search::Enclosure> enclosure_;  // none before the first step
};

}  // namespace vandplan::anytime
