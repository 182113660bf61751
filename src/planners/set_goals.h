// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which goals of a set are searched for, and what do paths to them cost at least?

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "planners/goal_poses.h"
#include "planners/path_search.h"
#include "planners/pricing.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/search.h"

namespace vandplan::planning {

/// A goal of a set where the vehicle can stand, and where it can come straight if it has to.
struct SetGoal {
  GoalPoint point;
  Task task;           ///< the task of driving to this goal alone
  double bound = 0.0;  ///< lower bound of the cost of paths to the goal
};

/// The goals of a task's set. Once the budget is interrupted hardly any further goal is looked at.
/// Method: docs/algorithms/goal_sets.md.
class SetGoals {
 public:
  /// Task, options and budget outlive the goals. Costs are those of `Pricing` with this
  /// `time_price`.
  SetGoals(const Task& task, const PlanOptions& options, double time_price,
           const search::Budget& budget);

  /// Goals evenly spread over the set wait for their turn.
  void spread_out();
  /// Whether few goals were found, though a region has several intervals, and nobody looked closer.
  [[nodiscard]] bool is_narrow() const { return is_narrow_; }
  /// Looks for goals in ever smaller parts of the set. False if there are none.
  bool look_closer();
  /// No goal that waits has a lower bound below this one; infinite if none waits.
  [[nodiscard]] double least_waiting() const;
  /// The goal with the least bound of those that wait; none if none waits, or if it was not looked
  /// at before the budget was interrupted.
  [[nodiscard]] std::optional<SetGoal> next();

  /// The goal at a point; none if the vehicle cannot stand there, or zones do not let it come to
  /// the goal, or nothing lets it come there straight.
  [[nodiscard]] std::optional<SetGoal> at(const GoalPoint& point);

  /// Whether the goal is all of its region.
  [[nodiscard]] bool is_single(const SetGoal& goal) const;
  /// Whether all regions were looked at.
  [[nodiscard]] bool saw_all() const { return saw_all_; }
  /// Lower bound of the cost of paths to continuous regions, without looking at obstacles; infinite
  /// without such a region. It is computed once, and lower if the budget is interrupted meanwhile.
  [[nodiscard]] double bound_of_regions();

  /// The answer if there is no goal to search for.
  [[nodiscard]] PlannerAnswer without_goals() const;

 private:
  /// A goal that waits. Where the vehicle can stand is not known before its turn, if its region is
  /// a single pose: of many docks, few are looked at before there is a path.
  struct Waiting {
    double bound = 0.0;  // lower bound of the goal, or of the straight way to its point
    std::size_t order = 0;
    GoalPoint point;
    std::unique_ptr<SetGoal> goal = {};
  };
  void wait(Waiting waiting);
  bool wait_at(const GoalPoint& point, std::size_t order);
  [[nodiscard]] bool is_interrupted();
  [[nodiscard]] bool may_look();
  [[nodiscard]] double bound_to(const Task& to) const;
  [[nodiscard]] double bound_straight_to(const LocalState& place) const;
  [[nodiscard]] double bound_of_length(double length) const;

  const Task& task_;
  Task alone_;  // the task without its set
  const PlanOptions& options_;
  double time_price_;
  const search::Budget& budget_;
  Pricing pricing_;
  std::vector<Waiting> waiting_;  // heap: the least bound first, then the first in order
  std::size_t looked_at_ = 0;     // goals looked at
  std::size_t free_ = 0;          // goals where the vehicle can stand
  bool is_narrow_ = false;        // whether looking closer may find more goals
  bool saw_all_ = true;
  std::optional<PlanStatus> cut_short_;  // how the budget ended before all were looked at
  bool is_none_free_ = false;            // whether it is proven that no pose of the set is free
  bool is_kept_by_zones_ = false;        // whether zones do not let the vehicle come to a free pose
  bool is_unsteady_ = false;             // whether a last stretch is too long to back a trailer
  std::optional<double> bound_of_regions_;
};

}  // namespace vandplan::planning
