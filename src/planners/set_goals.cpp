// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/set_goals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "planners/anytime/cost_bound.h"
#include "planners/commands/closer.h"
#include "planners/free_parts.h"
#include "planners/last_stretch.h"
#include "planners/leg_bounds.h"
#include "planners/towed.h"
#include "planners/zone_exits.h"
#include "problem/goal_set.h"

namespace vandplan::planning {
namespace {

/// Most goals of a region that are searched for: with one interval, and with several.
constexpr std::size_t max_goals_of_line = 16;
constexpr std::size_t max_goals_of_region = 64;
constexpr std::size_t max_goals_of_set = 2048;      // most goals of all regions, but two of each
constexpr std::size_t halvings_of_set = 20'000;     // halvings of parts of all regions for a bound
constexpr std::size_t single_regions_at_once = 64;  // single poses between two looks at the budget
constexpr std::size_t poses_at_once = 16;           // poses that are looked at between them
constexpr std::int64_t work_past_vias = 20'000;     // pairs of parts of vias that a bound looks at

/// Whether a rig that comes to a line as `before` says keeps its hitch angle along the line, in
/// spite of rounding errors.
bool is_steady(const Task& before, const Segment& line) {
  if (!before.vehicle.trailer || is_there(before)) return true;
  const double angle = before.hitch_angles.goal;
  return commands::error_growth(before.vehicle, angle, line) < commands::most_error_growth;
}

/// Whether goal `a`, which waits like `b`, comes after it.
constexpr auto comes_later = [](const auto& a, const auto& b) {
  return a.bound > b.bound || (a.bound == b.bound && a.order > b.order);
};

}  // namespace

SetGoals::SetGoals(const Task& task, const PlanOptions& options, double time_price,
                   const search::Budget& budget)
    : task_(task),
      alone_(task),
      options_(options),
      time_price_(time_price),
      budget_(budget),
      pricing_(task, options.cost, time_price) {
  alone_.goal_set.clear();
}

// Lower bound of the cost of paths past the vias to the one goal of `to`.
double SetGoals::bound_to(const Task& to) const {
  const Pricing pricing(to, options_.cost, time_price_);
  const double straight_there = to.vehicle.trailer ? cost_lower_bound(to, pricing)
                                                   : anytime::CostBound(to, pricing).least({});
  return to.via.empty() ? straight_there
                        : std::max(straight_there, LegBounds(to, pricing, 0).least());
}

// Lower bound of the cost of paths that are at least `length` metres long.
double SetGoals::bound_of_length(double length) const {
  const search::OpenGround ground{length, length, length, 0.0};
  return pricing_.counts_time() ? pricing_.cost_lower_bound(length, length)
                                : search::cost_lower_bound(ground, pricing_.rule(), 0.0);
}

// Lower bound of the cost of paths to a place: by the straight way, which costs little to find.
double SetGoals::bound_straight_to(const LocalState& place) const {
  const double way = std::hypot(place.pose.x - task_.start.x, place.pose.y - task_.start.y);
  return bound_of_length(std::max(0.0, way - 4 * steering::judged.position));
}

// [1] Spreads goals over each region.
void SetGoals::spread_out() {
  const std::size_t regions = task_.goal_set.size();
  const std::size_t share = std::max<std::size_t>(max_goals_of_set / regions, 2);
  std::size_t order = 0;
  for (std::size_t region = 0; region < regions; ++region) {
    const bool is_single = !is_continuous(task_.goal_set[region]);
    const bool is_slow = !is_single || region % single_regions_at_once == 0;
    if (is_slow && is_interrupted()) {
      saw_all_ = false;
      return;
    }
    const bool is_line = number_of_intervals(task_, region) == 1;
    const std::size_t most = std::min(is_line ? max_goals_of_line : max_goals_of_region, share);
    spread(task_, region, most, [&](const GoalPoint& point) {
      if (is_single) {
        wait({bound_straight_to(state_of(task_, point)), order++, point});
        return true;
      }
      return may_look() && wait_at(point, order++);
    });
    is_narrow_ |= number_of_intervals(task_, region) > 1;
  }
  is_narrow_ &= waiting_.size() < max_goals_of_region;
}

/// Lets the goal at a point wait; false if there is none.
bool SetGoals::wait_at(const GoalPoint& point, std::size_t order) {
  std::optional<SetGoal> goal = at(point);
  if (!goal) return false;
  const double bound = goal->bound;
  wait({bound, order, point, std::make_unique<SetGoal>(*std::move(goal))});
  return true;
}

bool SetGoals::look_closer() {
  is_narrow_ = false;
  if (is_interrupted() || std::ranges::none_of(task_.goal_set, is_continuous)) return false;
  const auto fits = [&](const GoalPoint& point) { return at(point).has_value(); };
  Task set = task_;
  if (options_.clearance.margin_ramp > 0.0) set.least_margin = 0.0;  // each goal has a ramp
  const auto [points, is_proof] = free_points(set, pricing_.rule().only_gear(), budget_, fits);
  is_none_free_ = is_proof;
  for (const GoalPoint& point : points) (void)wait_at(point, waiting_.size());
  return !is_interrupted() && !points.empty();
}

bool SetGoals::is_interrupted() {
  if (!cut_short_ && budget_.is_interrupted()) cut_short_ = budget_.exhausted();
  return cut_short_.has_value();
}

bool SetGoals::may_look() {
  if (looked_at_ % poses_at_once == 0) (void)is_interrupted();
  return !cut_short_;
}

void SetGoals::wait(Waiting waiting) {
  waiting_.push_back(std::move(waiting));
  std::push_heap(waiting_.begin(), waiting_.end(), comes_later);
}

double SetGoals::least_waiting() const {
  return waiting_.empty() ? std::numeric_limits<double>::infinity() : waiting_.front().bound;
}

std::optional<SetGoal> SetGoals::next() {
  while (!waiting_.empty() && (waiting_.front().goal != nullptr || may_look())) {
    std::pop_heap(waiting_.begin(), waiting_.end(), comes_later);
    Waiting first = std::move(waiting_.back());
    waiting_.pop_back();
    if (first.goal != nullptr) return std::move(*first.goal);
    std::optional<SetGoal> goal = at(first.point);
    if (!goal) continue;
    first.bound = goal->bound;
    first.goal = std::make_unique<SetGoal>(*std::move(goal));
    wait(std::move(first));
  }
  return std::nullopt;
}

std::optional<SetGoal> SetGoals::at(const GoalPoint& point) {
  ++looked_at_;
  const LocalState state = state_of(task_, point);
  SetGoal goal{.point = point,
               .task = problem::task_to(alone_, state, task_.goal_set[point.region].curvature,
                                        options_.clearance)};
  if (!goal.task.checker->is_free(state)) return std::nullopt;
  if (!is_there(goal.task) && !may_come(goal.task, pricing_.rule(), state)) {
    is_kept_by_zones_ = true;
    return std::nullopt;
  }
  ++free_;
  goal.bound = bound_to(goal.task);
  goal.task.last_stretch = last_stretch(task_, point);
  if (goal.task.last_stretch == 0.0) return goal;
  const Task before = before_line(goal.task);
  const Segment line = line_of(goal.task);
  const bool folds = std::abs(before.hitch_angles.goal) > task_.vehicle.max_hitch_angle;
  if (!folds && !is_steady(before, line)) {
    saw_all_ = false;
    is_unsteady_ = true;
    return std::nullopt;
  }
  const bool may_drive = !folds && search::may_drive(pricing_.rule(), {&line, 1});
  if (!may_drive || !before.checker->is_free(goal_state(before), line)) return std::nullopt;
  if (pricing_.counts_time()) return goal;
  const double of_line = pricing_.rule().weight(search::gear_of(line)) * std::abs(line.length);
  goal.bound = std::max(goal.bound, bound_to(before) + of_line);
  return goal;
}

bool SetGoals::is_single(const SetGoal& goal) const {
  return !is_continuous(task_.goal_set[goal.point.region]);
}

double SetGoals::bound_of_regions() {
  if (bound_of_regions_) return *bound_of_regions_;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t region = 0; region < task_.goal_set.size(); ++region) {
    if (!is_continuous(task_.goal_set[region])) continue;
    const double length =
        length_lower_bound_to(task_, region, halvings_of_set / task_.goal_set.size(), budget_);
    least = std::min(least, bound_of_length(length));
  }
  if (!task_.via.empty() && least < std::numeric_limits<double>::infinity()) {
    least = std::max(least, LegBounds(task_, pricing_, work_past_vias).least(budget_));
  }
  bound_of_regions_ = least;
  return least;
}

PlannerAnswer SetGoals::without_goals() const {
  if (cut_short_) return {.status = *cut_short_};
  const std::string poses = " poses of the goal that were looked at ";
  const bool has_intervals = std::ranges::any_of(task_.goal_set, is_continuous);
  if (free_ == 0) {
    const bool is_proven = !has_intervals || is_none_free_;
    const std::string looked_at = "none of the " + std::to_string(looked_at_) + poses;
    return {.status = is_proven ? PlanStatus::goal_in_collision : PlanStatus::node_limit,
            .reason = (is_none_free_ ? "no pose of the goal " : looked_at) + "is free" +
                      (is_kept_by_zones_ ? ", and zones let the vehicle come there" : "") +
                      (is_proven ? "" : "; others may be")};
  }
  const PlanStatus unproven =
      has_intervals ? PlanStatus::node_limit : PlanStatus::goal_in_collision;
  return {.status = saw_all_ && !has_intervals ? PlanStatus::no_path : unproven,
          .reason = "before none of the " + std::to_string(looked_at_) + poses +
                    "there is a free straight last stretch" +
                    (is_unsteady_ ? ": it is too long to back a trailer" : "")};
}

}  // namespace vandplan::planning
