// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which cost can no path fall below?

#include "planners/anytime/worker.h"
#include "planners/pricing.h"
#include "search/open_ground.h"

namespace vandplan::anytime {

/// Lower bound of the cost of all drives, from proven lower bounds of the length of their paths.
class CostBound {
 public:
  /// The pricing outlives the bound.
  CostBound(const Task& task, const planning::Pricing& pricing);

  /// Lower bound of the cost of all drives, by what is proven so far [m or s].
  [[nodiscard]] double least(const Proven& proven) const;
  /// Whether it is proven that no drive costs less than `cost`, except for rounding.
  [[nodiscard]] bool is_optimal(double cost, const Proven& proven) const;
  /// Lower bound of the length of all paths on open ground [m].
  [[nodiscard]] double shortest() const { return ground_.shortest; }

 private:
  [[nodiscard]] double by_lengths(const Proven& proven) const;

  const planning::Pricing& pricing_;
  search::OpenGround ground_;
  bool is_rig_;                 // whether the vehicle has a trailer
  double judged_of_rig_ = 0.0;  // lower bound for drives of a rig that the judge accepts
  double exact_of_rig_ = 0.0;   // lower bound for drives of a rig with exact ends
};

}  // namespace vandplan::anytime
