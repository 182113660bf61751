// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cost can no path fall below?

#include "planners/anytime/open_ground.h"
#include "planners/anytime/worker.h"
#include "planners/pricing.h"

namespace vandplan::anytime {

/// The lower bound of the costs of all drives, by what is proven of the lengths of their paths.
class CostBound {
 public:
  /// The pricing outlives the bound.
  CostBound(const Task& task, const planning::Pricing& pricing)
      : pricing_(pricing), ground_(open_ground(task, pricing.rule())) {}

  /// No drive costs less, by what is proven so far.
  [[nodiscard]] double least(const Proven& proven) const;
  /// Whether no drive costs less than `cost`, but for rounding.
  [[nodiscard]] bool is_optimal(double cost, const Proven& proven) const;
  /// No path is shorter, whatever stands in the way [m].
  [[nodiscard]] double shortest() const { return ground_.shortest; }

 private:
  const planning::Pricing& pricing_;
  OpenGround ground_;
};

}  // namespace vandplan::anytime
