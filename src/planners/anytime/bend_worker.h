// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which worker bends the routes of all workers?

#include <optional>

#include "planners/anytime/bend.h"
#include "planners/anytime/worker.h"

namespace vandplan::anytime {

/// Makes drives along routes cheaper by changing their commands, mostly so that wheels turn less.
class BendWorker final : public Worker {
 public:
  /// The vehicle has no trailer. The task and the rule outlive the worker.
  BendWorker(const Task& task, const CostRule& rule, std::uint64_t seed);

  /// Begins with a known path. The path need not be free, and its ends need not be exact.
  /// Gives back the drive along it; none if none was found.
  [[nodiscard]] std::optional<Drive> begin_with(const Path& known);

  [[nodiscard]] bool has_work() const override { return !bender_ || bender_->has_work(); }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const Budget& budget) override;
  void offer(const Route& route) override { bender().offer(route); }
  [[nodiscard]] Counts counts() const override;

 private:
  [[nodiscard]] Bender& bender();

  const Task& task_;
  const CostRule& rule_;
  std::uint64_t seed_;
  std::optional<Bender> bender_;  // none before the first iteration or offer
  double best_cost_;              // least cost of all routes and drives that the worker knows
  double told_cost_;              // cost of the best route that the bender was told
};

}  // namespace vandplan::anytime
