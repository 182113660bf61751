// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does the best route get cheaper still?

#include <optional>

#include "planners/anytime/shorten.h"
#include "planners/anytime/worker.h"

namespace vandplan::anytime {

/// Shortens the best route, whoever found it.
class Refiner final : public Worker {
 public:
  /// The task and the rule outlive the worker.
  Refiner(const Task& task, const CostRule& rule, std::uint64_t seed)
      : connector_(task, rule), seed_(seed) {}

  [[nodiscard]] bool has_work() const override { return true; }
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const Budget& budget) override;
  [[nodiscard]] Counts counts() const override { return counts_of(connector_); }

 private:
  Connector connector_;
  std::uint64_t seed_;
  std::uint64_t routes_ = 0;          // routes refined so far; numbers their seeds
  double best_cost_ = 0.0;            // least cost of all routes that the worker knows
  std::optional<Shortener> refined_;  // shortens the best route; none while there is no route
};

}  // namespace vandplan::anytime
