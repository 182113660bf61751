// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much do paths to the goals of a set cost at least?

#include "planners/pricing.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan::planning {

/// Lower bounds of costs, without looking at obstacles. Method: docs/algorithms/goal_sets.md.
class SetBounds {
 public:
  /// The task outlives the bounds. Costs are those of `Pricing`.
  SetBounds(const Task& task, const CostOptions& cost, double time_price);

  /// Bound of paths past the vias to the one goal of `to`.
  [[nodiscard]] double to(const Task& to) const;
  /// Bound of paths to a place: by the straight way, which costs little to find.
  [[nodiscard]] double straight_to(const LocalState& place) const;
  /// Bound of paths to the continuous regions of the set; infinite without one.
  [[nodiscard]] double to_regions() const;

 private:
  [[nodiscard]] double of_length(double length) const;

  const Task& task_;
  CostOptions cost_;
  double time_price_;
  Pricing pricing_;
};

}  // namespace vandplan::planning
