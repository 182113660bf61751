// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which worker judges routes by the cost of the whole drive, where time has a price?

#include <cstdint>
#include <vector>

#include "planners/anytime/cheapest_drive.h"
#include "planners/anytime/worker.h"
#include "planners/pricing.h"

namespace vandplan::anytime {

/// Makes drives along the routes of all workers cheaper, judged by the cost of the whole drive.
class CheapestDriveWorker final : public Worker {
 public:
  /// With `bends` drives are bent, too; the clearance of bent drives has no price. The task and the
  /// pricing outlive the worker.
  CheapestDriveWorker(const Task& task, const planning::Pricing& pricing, bool bends,
                      std::uint64_t seed);

  [[nodiscard]] bool has_work() const override { return true; }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const Budget& budget) override;
  /// Keeps a route for the next round, where it comes after the best route.
  void offer(const Route& route) override { offers_.push_back(route); }
  [[nodiscard]] Counts counts() const override { return {cheapest_.solves(), cheapest_.checks()}; }

 private:
  CheapestDrive cheapest_;
  std::vector<Route> offers_;  // routes for the next round
};

}  // namespace vandplan::anytime
