// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/behind_tractor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "planners/anytime/anytime.h"
#include "planners/rig/exact_drive.h"
#include "planners/rig/rig_search.h"
#include "vandplan/rig.h"

namespace vandplan::rig {
namespace {

using search::Budget;

constexpr int most_widenings = 6;           // times that searched parts are widened
constexpr std::int64_t most_of_part = 400;  // most expansions of one search
constexpr std::size_t most_parts = 32;      // most parts of the path that one search replaces
/// Share of its limit to which the hitch angle is set where the trailer would fold up.
constexpr double fold_kept = 0.5;

/// The task of the tractor without its trailer.
Task tractor_task(const Task& task, const TractorTerms& terms) {
  Task alone = task;
  alone.vehicle.trailer.reset();
  alone.vehicle.min_turning_radius = std::max(terms.radius, task.vehicle.min_turning_radius);
  alone.hitch_angles = {};
  if (task.steering != Steering::reeds_shepp) alone.steering = Steering::continuous;
  const double sharpest = 1 / alone.vehicle.min_turning_radius;
  alone.curvatures.start = std::clamp(task.curvatures.start, -sharpest, sharpest);
  alone.curvatures.goal = std::clamp(task.curvatures.goal, -sharpest, sharpest);
  alone.checker = task.world->checker(alone.vehicle, {.wanted = task.least_margin});
  return alone;
}

std::optional<std::vector<Segment>> way_of_tractor(const Task& task, const PlanOptions& options,
                                                   const TractorTerms& terms, Budget& budget) {
  const Task alone = tractor_task(task, terms);
  if (!alone.checker->is_free(alone.start) || !alone.checker->is_free(alone.goal)) return {};
  PlanOptions how = options;
  how.cost = driver_style;
  how.cost.reverse_weight = terms.reverse_weight;
  how.cost.clearance_distance = terms.distance;
  how.cost.initial_gear = options.cost.initial_gear;
  how.cost.gears = options.cost.gears;
  how.budget.seed = terms.seed;
  how.budget.target_gap.reset();
  how.budget.max_iterations = budget.left(terms.iterations, 0);
  if (how.budget.time_limit) *how.budget.time_limit -= budget.elapsed();
  if (how.budget.max_iterations == 0 || (how.budget.time_limit && *how.budget.time_limit <= 0.0)) {
    return {};
  }
  PlannerAnswer answer = anytime::plan_anytime(alone, how);
  budget.spend(answer.iterations);
  return std::move(answer.segments);
}

/// A path of the tractor, and what the trailer does behind it.
class Follower {
 public:
  Follower(const Task& task, const search::CostRule& rule, std::span<const Segment> way);

  /// A free drive of the rig. Where the rig cannot follow the path, a search replaces parts of it.
  [[nodiscard]] std::optional<std::vector<Segment>> drive(std::int64_t expansions, Budget& budget);

 private:
  /// Parts [first, second) of the path.
  using Parts = std::pair<std::size_t, std::size_t>;

  [[nodiscard]] std::optional<Parts> next_unsolved() const;
  [[nodiscard]] std::optional<std::vector<Segment>> search(const Parts& parts, std::int64_t& left,
                                                           Budget& budget) const;
  void widen(const Parts& parts, std::size_t by);

  const Task& task_;
  search::CostRule rule_;           // prices of the searches
  double unit_;                     // unit of the steps of a search [m]
  std::vector<Segment> way_;        // path of the tractor, cut into parts
  std::vector<RigState> states_;    // states of the rig before each part, and at the goal
  std::vector<double> curvatures_;  // curvatures before each part, and at the goal
  std::vector<bool> is_free_;       // whether the rig can drive each part freely
  std::map<Parts, std::vector<Segment>> solved_;  // drives that replace parts
};

Follower::Follower(const Task& task, const search::CostRule& rule, std::span<const Segment> way)
    : task_(task), rule_(rule), unit_(search_unit(task.vehicle)) {
  const double most = 2 * unit_;
  for (const Segment& segment : way) {
    const double size = std::abs(segment.length);
    const int parts = std::max(1, static_cast<int>(std::ceil(size / most)));
    for (int i = 0; i < parts; ++i) {
      way_.push_back(part_of(segment, size * i / parts, size * (i + 1) / parts));
    }
  }
  RigState state{task.start, task.hitch_angles.start};
  for (const Segment& part : way_) {
    states_.push_back(state);
    curvatures_.push_back(part.curvature);
    const bool is_forward = part.length > 0.0;
    RigState next = advance(task.vehicle, state, part);
    const double fold = largest_hitch_angle(task.vehicle, state.hitch_angle, part);
    const bool folds = fold > task.vehicle.max_hitch_angle;
    is_free_.push_back(is_forward && !folds && task.checker->rig_is_free(Local(state), part));
    if (!is_forward) next.hitch_angle = 0.0;
    if (folds && is_forward) {
      next.hitch_angle = std::copysign(fold_kept * task.vehicle.max_hitch_angle, next.hitch_angle);
    }
    state = next;
  }
  states_.push_back({task.goal, task.hitch_angles.goal});
  curvatures_.push_back(task.curvatures.goal);
  curvatures_.front() = task.curvatures.start;
  if (!is_free_.empty()) is_free_.back() = false;
  if (!is_free_.empty() && way_.front().curvature != task.curvatures.start &&
      task.steering == Steering::continuous) {
    is_free_.front() = false;
  }
}

std::optional<Follower::Parts> Follower::next_unsolved() const {
  for (std::size_t i = 0; i < is_free_.size(); ++i) {
    if (is_free_[i]) continue;
    std::size_t end = i;
    while (end < is_free_.size() && !is_free_[end]) ++end;
    if (!solved_.contains({i, end})) return Parts{i, end};
    i = end;
  }
  return std::nullopt;
}

void Follower::widen(const Parts& parts, std::size_t by) {
  const std::size_t first = parts.first - std::min(parts.first, by);
  const std::size_t last = std::min(is_free_.size(), parts.second + by);
  for (std::size_t i = first; i < last; ++i) is_free_[i] = false;
}

/// Searches for a drive from the state before some parts to the state behind them.
std::optional<std::vector<Segment>> Follower::search(const Parts& parts, std::int64_t& left,
                                                     Budget& budget) const {
  const auto [first, last] = parts;
  Task task = task_;
  task.start = Local(states_[first].pose);
  task.goal = Local(states_[last].pose);
  task.hitch_angles = {states_[first].hitch_angle, states_[last].hitch_angle};
  task.curvatures = {curvatures_[first], curvatures_[last]};
  if (task.steering != Steering::reeds_shepp) task.steering = Steering::continuous;
  if (!task.checker->rig_is_free(Local(states_[first])) ||
      !task.checker->rig_is_free(Local(states_[last]))) {
    return std::nullopt;
  }
  const Guides guides(task);
  RigSearch search(task, rule_, guides, {.step = 2.2 * unit_, .weight = 8, .levels = 2});
  std::int64_t most = most_of_part;
  for (; left > 0 && most > 0 && budget.next() && search.step(); --left, --most) {
    const std::optional<std::vector<Segment>> found = search.take_found();
    if (!found) continue;
    const commands::WheelEnds ends = commands::wheel_ends(task);
    return commands::Wheels(task.vehicle, task.steering).driven(*found, ends.before);
  }
  return std::nullopt;
}

std::optional<std::vector<Segment>> Follower::drive(std::int64_t expansions, Budget& budget) {
  int widenings = 0;
  std::size_t by = 2;
  while (const std::optional<Parts> parts = next_unsolved()) {
    if (expansions <= 0 || budget.exhausted()) return std::nullopt;
    if (parts->second - parts->first > most_parts) return std::nullopt;
    if (std::optional<std::vector<Segment>> found = search(*parts, expansions, budget)) {
      solved_[*parts] = std::move(*found);
      continue;
    }
    const bool is_whole = parts->second - parts->first == way_.size();
    if (is_whole || ++widenings > most_widenings) return std::nullopt;
    widen(*parts, by);
    by *= 2;
  }
  std::vector<Segment> whole;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    if (is_free_[i]) {
      whole.push_back(way_[i]);
      continue;
    }
    std::size_t end = i;
    while (end < is_free_.size() && !is_free_[end]) ++end;
    const std::vector<Segment>& part = solved_.at({i, end});
    whole.insert(whole.end(), part.begin(), part.end());
    i = end - 1;
  }
  return merged(whole);
}

}  // namespace

std::optional<std::vector<Segment>> drive_behind_tractor(const Task& task,
                                                         const PlanOptions& options,
                                                         const TractorTerms& terms,
                                                         Budget& budget) {
  const std::optional<std::vector<Segment>> way = way_of_tractor(task, options, terms, budget);
  if (!way || way->empty()) return std::nullopt;
  const search::CostRule rule =
      search::restricted(search::cost_rule(driver_style), options.cost.gears);
  const std::optional<std::vector<Segment>> drive =
      Follower(task, rule, *way).drive(terms.expansions, budget);
  if (!drive) return std::nullopt;
  return ExactDrive(task).along(*drive);
}

}  // namespace vandplan::rig
