// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/site_ground.h"

#include "vandplan/input_error.h"

namespace vandplan::studies {
namespace {

constexpr int most_draws = 10'000;  // random poses that are tried for a start

/// Poses that a scenario's goal consists of; the middle of a region of many.
std::vector<Pose> goals_of(const Scenario& scenario) {
  if (scenario.goal_set.empty()) return {scenario.goal};
  std::vector<Pose> goals;
  goals.reserve(scenario.goal_set.size());
  for (const GoalRegion& region : scenario.goal_set) goals.push_back(some_pose(region));
  return goals;
}

Problem first_problem(Scenario scenario) {
  scenario.goal = goals_of(scenario).front();
  scenario.goal_set.clear();
  scenario.via.clear();
  scenario.curvatures = {};
  return make_problem(scenario);
}

}  // namespace

void ask(PlanOptions& options, const Planner& planner, const std::string& asked) {
  options.style = Style::shortest;
  const std::size_t equals = asked.find('=');
  if (equals != std::string::npos) {
    set_option(options, planner, asked.substr(0, equals), asked.substr(equals + 1));
  }
  if (honours(planner, "steering")) options.steering = Steering::reeds_shepp;
}

SiteGround::SiteGround(const std::string& name, const Scenario& scenario,
                       const std::vector<std::string>& asked)
    : problem_(first_problem(scenario)) {
  for (const Pose& goal : goals_of(scenario)) {
    const Task task = with_poses(problem_, goal, goal).task();
    if (task.checker->is_free(task.goal)) goals_.push_back(goal);
  }
  const auto made = [&](const std::string& option, const Resolution& resolution) {
    PlanOptions options;
    ask(options, default_planner(), option);
    options = complete(default_planner(), options, problem_.vehicle());
    return make_site_table(problem_, goals_, options,
                           {.headings = resolution.headings, .cell = resolution.cell})
        .value();
  };
  try {
    for (const Resolution& resolution : resolutions) tables_.push_back(made("", resolution));
    for (const std::string& option : asked) {
      asked_tables_.emplace(option, made(option, resolutions.front()));
    }
  } catch (const InputError& error) {
    throw InputError(name, error.where() + ": " + error.problem());
  }
}

std::pair<Pose, Pose> SiteGround::ends(int number, Rng& rng) const {
  const Pose& goal = goals_[static_cast<std::size_t>(number) % goals_.size()];
  const Task task = problem_.task();
  const Local<Bounds> region = sampling_region(task, Region::scene);
  LocalPose start = task.start;
  for (int draw = 0; draw < most_draws && (draw == 0 || !task.checker->is_free(start)); ++draw) {
    if (number > 0 || draw > 0) start = uniform_pose(region, rng);
  }
  return {to_scenario(*task.world, start), goal};
}

double SiteGround::megabytes(std::size_t resolution) const {
  const auto bytes = static_cast<double>(site_table_to_bytes(tables_[resolution]).size());
  return 1e-6 * bytes / static_cast<double>(goals_.size());
}

}  // namespace vandplan::studies
