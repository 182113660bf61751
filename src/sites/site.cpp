// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/site.h"

#include <numbers>

#include "geometry/boxes.h"
#include "problem/goal_set.h"
#include "vandplan/input_error.h"

namespace vandplan::sites {
namespace {

constexpr double most_pairs = 1e8;  // pairs of cell and heading in a table

void check(const Problem& problem, std::span<const Pose> goals, const PlanOptions& options,
           const SiteTableOptions& table) {
  require(!goals.empty(), "goals", "at least one");
  require(table.headings >= 8 && table.headings <= 256, "headings", "8 to 256");
  require(table.cell >= 0.01 && table.cell <= 1.0, "cell", "0.01 to 1 turning radii");
  require(table.threads >= 1 && table.threads <= 256, "threads", "1 to 256");
  require(options.cost.measure == CostMeasure::prices, "cost", "prices: a table knows no times");
  require(problem.task().moving.empty(), "moving", "none: a table knows no moving obstacles");
}

/// The problem of the tractor alone.
Problem without_trailer(const Problem& problem) {
  if (!problem.vehicle().trailer) return problem;
  Vehicle tractor = problem.vehicle();
  tractor.trailer.reset();
  return make_problem(problem.world(), tractor, problem.start(), problem.goal());
}

/// [1] Box around what the tasks and free starts reach, in the world's frame.
Bounds box_around(const std::vector<Task>& tasks, const Problem& problem,
                  std::span<const Pose> starts) {
  Bounds box = sampling_region(tasks.front(), Region::scene);
  const auto add = [&box](const Task& task) {
    box = geometry::united(box, sampling_region(task, Region::scene));
  };
  for (const Task& task : tasks) add(task);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Problem there = between(problem, starts[i], starts[i], place_in("starts", i));
    if (there.task().checker->is_free(there.task().start)) add(there.task());
  }
  return box;
}

SiteGrid grid_of(const Bounds& box, const Task& task, const SiteTableOptions& options) {
  const double radius = task.vehicle.min_turning_radius;
  const double cell = options.cell * radius;
  const double columns = (box.x_max - box.x_min) / cell + 1;
  const double rows = (box.y_max - box.y_min) / cell + 1;
  require(columns * rows * options.headings <= most_pairs, "cell",
          "larger cells: the site has too many");
  const Point& origin = task.world->origin();
  return {.corner = {box.x_min + origin.x, box.y_min + origin.y},
          .cell = cell,
          .radius = radius,
          .columns = static_cast<std::int32_t>(columns),
          .rows = static_cast<std::int32_t>(rows),
          .headings = options.headings};
}

}  // namespace

void require(bool holds, const char* where, const char* expected) {
  if (!holds) throw InputError(where, std::string("expected ") + expected);
}

std::string place_in(const char* list, std::size_t number) {
  return std::string(list) + "[" + std::to_string(number) + "]";
}

Problem between(const Problem& problem, const Pose& start, const Pose& goal,
                const std::string& where) {
  try {
    return with_poses(problem, start, goal);
  } catch (const InputError& error) {
    throw InputError(where, error.problem());
  }
}

Task task_to(const Problem& problem, const Pose& goal, std::size_t number,
             const PlanOptions& options) {
  const Problem alone = without_trailer(problem);
  return task_of(between(alone, goal, goal, place_in("goals", number)), options.clearance);
}

SiteGoals goals_of_set(const Problem& problem, const PlanOptions& options) {
  SiteGoals goals;
  for (GoalRegion region : problem.goal_set()) {
    if (is_continuous(region)) {
      throw InputError("goals",
                       "the goal of the scenario holds infinitely many poses, expected a list of "
                       "poses");
    }
    for (int turns = 0; turns < (region.either_way ? 2 : 1); ++turns) {
      const Pose pose = problem::some_goal(problem.vehicle(), region).pose;
      const Task task = task_to(problem, pose, goals.poses.size(), options);
      if (task.checker->is_free(task.goal)) {
        goals.poses.push_back(pose);
      } else {
        ++goals.left_out;
      }
      region.heading.from += std::numbers::pi;
      region.heading.to += std::numbers::pi;
    }
  }
  if (goals.poses.empty()) {
    throw InputError("goals", "no pose of the scenario's goal is free, expected a list of poses");
  }
  return goals;
}

Site site_of(const Problem& problem, std::span<const Pose> goals, const PlanOptions& options,
             const SiteTableOptions& table) {
  check(problem, goals, options, table);
  Site site;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    site.tasks.push_back(task_to(problem, goals[i], i, options));
    const Task& task = site.tasks.back();
    if (table.allows_blocked_goals || task.checker->is_free(task.goal)) continue;
    throw InputError(place_in("goals", i),
                     "is not free (of obstacles, or by zones), expected a pose where the vehicle "
                     "can stand");
  }
  site.box = box_around(site.tasks, without_trailer(problem), table.starts);
  site.grid = grid_of(site.box, site.tasks.front(), table);
  return site;
}

}  // namespace vandplan::sites

namespace vandplan {

SiteGoals site_goals(const Problem& problem, const PlanOptions& options) {
  if (problem.goal_set().empty()) return {.poses = {problem.goal()}};
  return sites::goals_of_set(problem, options);
}

std::string_view fault_of_site_option(std::string_view option) noexcept {
  if (option == "site") return "expected no table here: a matrix takes one in place of goals";
  const CommonOption* const common = find_common_option(option);
  if (common == nullptr || common->part != OptionPart::budget) return "";
  return "counts for plans, and none are made: expected prices, gears or margin, or a matrix of "
         "plans, which has max_iterations";
}

}  // namespace vandplan
