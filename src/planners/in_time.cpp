// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/in_time.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/trigonometry.h"
#include "moving/encounters.h"
#include "moving/yielding.h"
#include "planners/anytime/anytime.h"
#include "planners/pricing.h"
#include "vandplan/input_error.h"
#include "vandplan/reeds_shepp.h"
#include "vandplan/search.h"

namespace vandplan::in_time {
namespace {

using search::Budget;

constexpr double share = 0.1;        // of the budget for each round but the last,
constexpr double least_round = 400;  // and iterations, below which there may be no path yet

/// A path with its times, and what both cost.
struct Way {
  std::vector<Segment> segments;
  SpeedProfile speeds;
  double path_cost = 0.0;  // if nothing moves [m], or [s] where the cost is the time
  double cost = 0.0;       // with the time that the drive takes
};

/// The outline of an obstacle at a time, in the frame of the task; empty if it has left.
Polygon outline_at(const MovingObstacle& obstacle, double t) {
  const std::optional<Pose> pose = pose_at(obstacle, t);
  Polygon there;
  if (!pose) return there;
  const auto [sin, cos] = base::sin_cos(pose->heading);
  for (const auto& [x, y] : obstacle.outline) {
    there.push_back({pose->x + cos * x - sin * y, pose->y + sin * x + cos * y});
  }
  return there;
}

/// What stands for an obstacle that one goes around.
enum class Ghost {
  where_met,  ///< where it is at the meeting
  at_rest,    ///< where everything is in the end
  whole_way,  ///< wherever it comes
};

std::vector<Polygon> ghosts_of(const Task& task, const Meeting& meeting, Ghost kind) {
  std::vector<Polygon> ghosts;
  const auto add = [&](const MovingObstacle& obstacle, double t) {
    if (Polygon outline = outline_at(obstacle, t); !outline.empty()) {
      ghosts.push_back(std::move(outline));
    }
  };
  const MovingObstacle& met = task.moving[meeting.obstacle];
  if (kind == Ghost::where_met) add(met, meeting.t);
  if (kind == Ghost::at_rest) {
    for (const MovingObstacle& obstacle : task.moving) {
      if (obstacle.after == Afterwards::stays) add(obstacle, obstacle.trajectory.back().t);
    }
  }
  if (kind == Ghost::whole_way) {
    constexpr double places = 24;
    const double last = std::max(met.trajectory.back().t, 0.0);
    for (double i = 0; i <= places; ++i) add(met, last * i / places);
  }
  return ghosts;
}

/// The task with more obstacles, and nothing that moves; none if start or goal are not free then.
std::optional<Task> task_with(const Task& task, const PlanOptions& options,
                              const std::vector<Polygon>& ghosts) {
  try {
    auto world = std::make_shared<const World>(*task.world, ghosts);
    const Problem problem = make_problem(std::move(world), task.vehicle, task.start, task.goal,
                                         task.curvatures, task.hitch_angles);
    Task around = task_of(problem, options.clearance, task.steering);
    const CollisionChecker& checker = *around.checker;
    const auto [first, last] = task.hitch_angles;
    if (checker.rig_is_free({task.start, first}) && checker.rig_is_free({task.goal, last})) {
      return around;
    }
  } catch (const InputError&) {
    // A turned outline may touch itself by a rounding error: it is no obstacle then.
  }
  return std::nullopt;
}

/// One run: the best way so far, and the budget.
class Run {
 public:
  Run(const Task& task, const PlanOptions& options)
      : task_(task), options_(options), pricing_(task, options.cost), budget_(options.budget) {}

  [[nodiscard]] PlannerAnswer answer() {
    // 0. What needs no search: somebody is where the vehicle begins or stays, or it is there.
    if (PlannerAnswer none{.status = PlanStatus::no_path, .reason = proof_of_none()};
        !none.reason.empty()) {
      return none;
    }
    if (is_goal_the_start()) {
      (void)consider({});
      return finished({});
    }
    // 1. The best path where nothing moves, as fast as what moves lets it.
    Task alone = task_;
    alone.moving.clear();
    PlannerAnswer first = try_paths(alone, task_.moving.empty() ? 1.0 : share);
    if (!first.segments && first.status != PlanStatus::no_path && !budget_.exhausted()) {
      first = try_paths(alone, 1.0);
    }
    if (!first.segments) return first;
    // 2. Around what the fastest drive along it meets.
    for (const Ghost kind : {Ghost::where_met, Ghost::at_rest, Ghost::whole_way}) {
      if (!meeting_ || budget_.exhausted()) break;
      const std::optional<Task> around =
          task_with(task_, options_, ghosts_of(task_, *meeting_, kind));
      if (around) (void)try_paths(*around, share);
    }
    // 3. What is left goes to where the best way was found.
    if (best_ && !budget_.exhausted()) (void)try_paths(Task(*best_task_), 1.0);
    return finished(std::move(first));
  }

 private:
  /// Who is where the vehicle has to begin, or stays where it has to stay; empty if nobody is.
  [[nodiscard]] std::string proof_of_none() const {
    const auto [first_angle, last_angle] = task_.hitch_angles;
    const RigState start{task_.start, first_angle}, goal{task_.goal, last_angle};
    const Path none{task_.start, {}};
    const moving::Encounters encounters({none, task_.vehicle}, task_.moving,
                                        options_.clearance.margin);
    for (std::size_t i = 0; i < encounters.size(); ++i) {
      const std::optional<double> leaves = encounters.leaves(i);
      const std::string name = "moving[" + std::to_string(i) + "]";
      const bool is_there = leaves.value_or(0.0) >= 0.0;
      if (is_there && encounters.gap(i, start, 0.0, 0.0) <= 0.0) {
        return name + " is where the start is, or nearer to it than the margin";
      }
      const double rest = std::max(encounters.rests(i), 0.0);
      if (!leaves && encounters.gap(i, goal, rest, 0.0) <= 0.0) {
        return name + " stays where the goal is, or nearer to it than the margin";
      }
    }
    return "";
  }

  [[nodiscard]] bool is_goal_the_start() const {
    const auto [first, last] = task_.curvatures;
    if (task_.steering == Steering::continuous && first != last) return false;
    if (task_.hitch_angles.start != task_.hitch_angles.goal) return false;
    return reeds_shepp_length(task_.start, task_.goal, task_.vehicle.min_turning_radius) == 0.0;
  }

  /// What a round may spend: so much of all, no more than what is left.
  [[nodiscard]] BudgetOptions part_of_budget(double part) const {
    BudgetOptions budget = options_.budget;
    if (budget.time_limit) {
      const double left = std::max(*budget.time_limit - budget_.elapsed(), 0.0);
      budget.time_limit = std::min(*budget.time_limit * part, left);
    }
    if (budget.max_iterations) {
      const double wanted =
          std::max(std::ceil(static_cast<double>(*budget.max_iterations) * part), least_round);
      budget.max_iterations = budget_.left(static_cast<std::int64_t>(wanted), 0);
    }
    return budget;
  }

  PlannerAnswer try_paths(const Task& task, double part) {
    PlanOptions options = options_;
    options.budget = part_of_budget(part);
    PlannerAnswer answer = anytime::plan_drive(task, options, time_price);
    budget_.spend(answer.iterations);
    if (answer.segments && consider(*answer.segments)) best_task_ = task;
    return answer;
  }

  /// Gives the path its times; whether it is better than the best so far, and becomes it.
  bool consider(const std::vector<Segment>& segments) {
    const Path path{task_.start, segments};
    const moving::Traffic traffic{.moving = task_.moving,
                                  .margin = options_.clearance.margin,
                                  .start_curvature = task_.curvatures.start,
                                  .start_hitch_angle = task_.hitch_angles.start,
                                  .most_states = most_states() - states_,
                                  .is_interrupted = [this] { return budget_.is_interrupted(); }};
    moving::Yielding yielding = moving::yielding_speeds(path, task_.vehicle, traffic);
    states_ += yielding.states;
    const SpeedOptions wheels{.start_curvature = task_.curvatures.start};
    const moving::Course course{path, task_.vehicle, task_.hitch_angles.start};
    const auto met = moving::first_meeting(course, speed_profile(path, task_.vehicle, wheels),
                                           task_.moving, traffic.margin);
    if (!meeting_) meeting_ = met;
    if (!yielding.speeds) return false;
    Way way{segments, *std::move(yielding.speeds)};
    way.path_cost = pricing_.cost(segments, search::Looks::answer);
    way.cost =
        pricing_.is_time() ? way.speeds.duration : way.path_cost + time_price * way.speeds.duration;
    if (best_ && best_->cost <= way.cost) return false;
    // The trace holds the costs of the paths alone, as far as they fall.
    std::erase_if(trace_, [&](const CostSample& sample) { return sample.cost <= way.path_cost; });
    trace_.push_back({budget_.elapsed(), budget_.iterations(), way.path_cost});
    best_ = std::move(way);
    return true;
  }

  /// That all searches for times may look at together.
  [[nodiscard]] std::int64_t most_states() const {
    constexpr std::int64_t without_limit = 1'000'000;
    constexpr std::int64_t states_per_iteration = 200;
    if (!options_.budget.max_iterations) return without_limit;
    return std::min(without_limit, states_per_iteration * *options_.budget.max_iterations);
  }

  PlannerAnswer finished(PlannerAnswer&& first) {
    PlannerAnswer answer{.status = PlanStatus::solved,
                         .iterations = budget_.iterations(),
                         .anytime = std::move(trace_),
                         .counters = std::move(first.counters),
                         .phases = std::move(first.phases),
                         .tree = std::move(first.tree)};
    answer.counters.push_back({"states_in_time", states_});
    if (best_) {
      answer.segments = std::move(best_->segments);
      answer.speeds = std::move(best_->speeds);
      return answer;
    }
    answer.status = budget_.exhausted().value_or(
        options_.budget.max_iterations ? PlanStatus::iteration_limit : PlanStatus::time_limit);
    answer.reason = "there are paths, but none on which a drive was found that meets nothing";
    return answer;
  }

  const Task& task_;
  const PlanOptions& options_;
  planning::Pricing pricing_;  // of a path, if nothing moves
  Budget budget_;
  std::optional<Way> best_;
  std::optional<Task> best_task_;   // without anything that moves, on which it was found
  std::optional<Meeting> meeting_;  // of the fastest drive along the first path
  std::vector<CostSample> trace_;
  std::int64_t states_ = 0;
};

}  // namespace

PlannerAnswer plan(const Task& task, const PlanOptions& options) {
  return Run(task, options).answer();
}

}  // namespace vandplan::in_time
