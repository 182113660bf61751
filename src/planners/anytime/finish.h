// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does the best route or drive become one that a driver can follow?

#include <optional>
#include <vector>

#include "planners/anytime/cost_bound.h"
#include "planners/anytime/drive.h"
#include "planners/pricing.h"

namespace vandplan::anytime {

/// Option "min_stroke": least length of strokes before and after gear changes, where there is room
/// [m].
[[nodiscard]] OptionInfo min_stroke_option();

/// The segments of a path from `start`, without crumbs where other segments can make up for them.
/// The path ends where it ended, is free if it was, and costs at most 1e-4 (relative) more.
[[nodiscard]] std::vector<Segment> tidied(search::Connector& connector, const LocalPose& start,
                                          std::vector<Segment> segments);

/// Rules for a finished drive besides its cost.
struct FinishRules {
  double min_stroke = 0.0;  ///< least stroke that the options ask for [m]
  double stroke = 0.0;      ///< least stroke that is made where there is room [m]
  /// Whether the workers have finished their drives; the price of short strokes remains to be left
  /// out.
  bool is_finished = false;
  bool is_continuous = false;  ///< whether the wheels need time to turn
  /// Largest relative excess of the finished drive's cost over the best drive's cost; none: no
  /// limit.
  std::optional<double> slack = {};
};

/// Leaves out crumbs, and makes strokes before and after gear changes longer where there is room.
class Finisher {
 public:
  /// The task and the pricing outlive the finisher.
  Finisher(const Task& task, const planning::Pricing& pricing, const FinishRules& rules)
      : task_(task), pricing_(pricing), rules_(rules) {}

  /// A route as short as `best` with fewer gear changes, if one is found; otherwise `best`. There
  /// are many shortest paths for turning on the spot. `shortest`: length of the shortest path [m].
  [[nodiscard]] search::Route with_fewer_changes(const search::Route& best, double shortest,
                                                 std::uint64_t seed, search::Budget& budget) const;
  /// Segments of the best drive before tidying.
  [[nodiscard]] std::vector<Segment> raw(const Drive& best) const;
  /// The raw segments tidied; none where they stay as they are, such as those of a shortest path.
  /// `is_optimal`: whether it is proven that no drive costs less.
  [[nodiscard]] std::optional<Drive> drivable(const Drive& best, const std::vector<Segment>& raw,
                                              bool is_optimal) const;
  /// The drive of `drivable`; none if it exceeds the best drive's cost by more than `slack` allows.
  [[nodiscard]] std::optional<Drive> finished(const Drive& best, const std::vector<Segment>& raw,
                                              bool is_optimal) const;
  [[nodiscard]] double min_stroke() const { return rules_.min_stroke; }

 private:
  /// Whether more than the length counts.
  [[nodiscard]] bool has_prices() const { return !pricing_.rule().is_length(); }

  const Task& task_;
  const planning::Pricing& pricing_;
  FinishRules rules_;
};

}  // namespace vandplan::anytime
