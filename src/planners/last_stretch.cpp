// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/last_stretch.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "planners/pricing.h"
#include "planners/search_via.h"
#include "problem/goal_set.h"
#include "search/route.h"
#include "vandplan/steering.h"
#include "vandplan/vehicle.h"

namespace vandplan::planning {
namespace {

class WithLine final : public PathSearch {
 public:
  WithLine(const Task& task, const PlanOptions& options, double time_price, const Path* known,
           std::span<const double> passed, const SearchTo& search_to)
      : line_(line_of(task)), before_(before_line(task)), pricing_(task, options.cost, time_price) {
    if (is_there(before_)) return;
    std::optional<Path> way;
    if (known != nullptr) {
      const double end = length(*known) - std::abs(line_.length);
      way = Path{known->start, search::part_of(known->segments, 0.0, end)};
    }
    search_ = search_via(before_, options, time_price, way ? &*way : nullptr, passed, search_to);
  }

  bool advance(std::int64_t most) override { return search_ && search_->advance(most); }

  [[nodiscard]] std::optional<std::vector<Segment>> path() override {
    if (!search_) return std::vector{line_};
    std::optional<std::vector<Segment>> way = search_->path();
    if (way) way = with_line(*std::move(way));
    return way;
  }

  [[nodiscard]] std::int64_t iterations() const override {
    return search_ ? search_->iterations() : 0;
  }

  [[nodiscard]] PlannerAnswer answer() override {
    if (!search_) {
      return {.status = PlanStatus::solved,
              .segments = std::vector{line_},
              .anytime = {{0.0, 0, cost(std::vector{line_})}}};
    }
    PlannerAnswer answer = search_->answer();
    if (answer.segments) answer.segments = with_line(*std::move(answer.segments));
    double more = least_cost_of_line();
    if (answer.segments && !answer.anytime.empty()) {
      more = cost(*answer.segments) - answer.anytime.back().cost;
    }
    for (CostSample& sample : answer.anytime) sample.cost += more;
    // The fastest way before the line ends standing, but the vehicle may roll on.
    if (pricing_.counts_time()) answer.lower_bound.reset();
    if (answer.lower_bound) *answer.lower_bound += least_cost_of_line();
    return answer;
  }

 private:
  [[nodiscard]] std::vector<Segment> with_line(std::vector<Segment> way) const {
    way.push_back(line_);
    return way;
  }

  [[nodiscard]] double cost(const std::vector<Segment>& path) const {
    return pricing_.path_cost(path, search::ClearanceSampling::search);
  }

  [[nodiscard]] double least_cost_of_line() const {
    return pricing_.prices().weight(search::gear_of(line_)) * std::abs(line_.length);
  }

  Segment line_;
  Task before_;
  Pricing pricing_;
  std::unique_ptr<PathSearch> search_;  // null if the line begins at the start
};

}  // namespace

bool is_there(const Task& task) {
  if (!task.via.empty() || task.last_stretch != 0.0) return false;
  const bool turns_wheels =
      task.steering == Steering::continuous && task.curvatures.start != task.curvatures.goal;
  if (turns_wheels || task.hitch_angles.start != task.hitch_angles.goal) return false;
  return reeds_shepp_length(task.start, task.goal, task.vehicle.min_turning_radius) == 0.0;
}

Task to_set_behind_vias(Task task) {
  if (task.via.empty() || !task.goal_set.empty()) return task;
  GoalRegion region = region_of_pose(task.goal);
  region.curvature = task.curvatures.goal;
  region.hitch_angle = {task.hitch_angles.goal, task.hitch_angles.goal};
  task.goal_set = {region};
  return task;
}

// A drive back along the line leads from the goal to where the line begins, trailers included.
Task before_line(const Task& task) {
  if (task.last_stretch == 0.0) return task;
  Task before = task;
  const State begin = advance(task.vehicle, goal_state(task), Segment{0.0, -task.last_stretch});
  before.goal = Local(begin.pose);
  before.hitch_angles.goal = begin.hitch_angle;
  before.curvatures.goal = 0.0;
  before.beyond.goal = search::gear_of(line_of(task));
  before.last_stretch = 0.0;
  problem::tell_ends_apart(before);
  return before;
}

std::unique_ptr<PathSearch> search_with_line(const Task& task, const PlanOptions& options,
                                             double time_price, const Path* known,
                                             std::span<const double> passed,
                                             const SearchTo& search_to) {
  if (task.last_stretch == 0.0) {
    return search_via(task, options, time_price, known, passed, search_to);
  }
  return std::make_unique<WithLine>(task, options, time_price, known, passed, search_to);
}

}  // namespace vandplan::planning
