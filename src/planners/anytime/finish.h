// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does the best route or drive become what somebody can drive?

#include <optional>
#include <vector>

#include "planners/anytime/cost_bound.h"
#include "planners/anytime/drive.h"
#include "planners/pricing.h"

namespace vandplan::anytime {

/// What a run ends with.
struct Best {
  const search::Route* route = nullptr;  ///< cheapest route
  const Drive* drive = nullptr;          ///< drive that is cheaper than the route; null if none is
  bool is_optimal = false;               ///< no drive costs less: proven
};

/// What is asked of a drive besides its cost.
struct FinishRules {
  double min_stroke = 0.0;     ///< strokes before and after gear changes that are asked for [m]
  double stroke = 0.0;         ///< strokes that are made if there is room [m]
  bool is_continuous = false;  ///< whether the wheels need time to turn
  bool has_prices = false;     ///< whether more than the length counts
  /// A finished drive may cost so much more than the one that was found, relative; any, if none.
  std::optional<double> slack = {};
};

/// Leaves out crumbs, and makes strokes before and after gear changes as long as is asked for where
/// there is room.
class Finisher {
 public:
  /// The task and the pricing outlive the finisher.
  Finisher(const Task& task, const planning::Pricing& pricing, const FinishRules& rules)
      : task_(task), pricing_(pricing), rules_(rules) {}

  /// One of the shortest paths with fewer gear changes, if `best` is one of the shortest. Turning
  /// on the spot has many paths of the same length. `shortest`: no path is shorter [m].
  [[nodiscard]] search::Route with_fewer_changes(const search::Route& best, double shortest,
                                                 std::uint64_t seed, search::Budget& budget) const;
  /// What is driven as it was found.
  [[nodiscard]] std::vector<Segment> raw(const Best& best) const;
  /// The raw segments tidied; none where they stay as they are: the shortest path is what it is.
  [[nodiscard]] std::optional<Drive> drivable(const Best& best,
                                              const std::vector<Segment>& raw) const;
  /// `drivable`, unless it costs much more than the drive that was found.
  [[nodiscard]] std::optional<Drive> finished(const Best& best,
                                              const std::vector<Segment>& raw) const;
  [[nodiscard]] double min_stroke() const { return rules_.min_stroke; }

 private:
  const Task& task_;
  const planning::Pricing& pricing_;
  FinishRules rules_;
};

}  // namespace vandplan::anytime
