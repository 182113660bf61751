// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// What does a set of goals cost beside its single poses, and how soon has it a path?
// usage: goal_sets_bench headings|areas|docks FIRST LAST SECONDS [SINGLES SECONDS_OF_SINGLE]
//
// Problems are random worlds FIRST to LAST. Of each the goal with its heading, either way and with
// any heading; or an area of 8 m x 8 m around it; or 100 docks along a yard. With SINGLES so many
// poses of the set are planned for by themselves, for comparison. Processor time.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "support/figure.h"
#include "support/plans.h"
#include "support/random_world.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan {
namespace {

constexpr double pi = std::numbers::pi;

/// What a set is compared with: its plain goal first, then each pose that is planned for by itself.
struct Case {
  Problem fixed;
  std::vector<std::pair<std::string, Problem>> sets;
  std::vector<GoalRegion> singles;
};

struct Arguments {
  std::string kind;
  std::uint64_t first = 0, last = 0;
  double seconds = 0.0;
  int singles = 0;
  double seconds_of_single = 1.0;
};

Case with_headings(const Problem& fixed, int singles) {
  GoalRegion region = region_of_pose(fixed.goal());
  GoalRegion either = region, any = region;
  either.either_way = true;
  any.heading = any_heading;
  Case made{fixed,
            {{"either way", with_goal_set(fixed, {either})},
             {"any heading", with_goal_set(fixed, {any})}},
            {}};
  for (int i = 0; i < singles; ++i) {
    Pose pose = fixed.goal();
    pose.heading += 2 * pi * i / singles;
    made.singles.push_back(region_of_pose(pose));
  }
  return made;
}

Case with_area(const Problem& fixed, int singles, std::uint64_t seed) {
  constexpr double half = 4.0;
  const Pose& goal = fixed.goal();
  GoalRegion region{.x = {goal.x - half, goal.x + half},
                    .y = {goal.y - half, goal.y + half},
                    .heading = {goal.heading - 0.3, goal.heading + 0.3}};
  Case made{fixed, {{"area", with_goal_set(fixed, {region})}}, {}};
  Rng rng(seed);
  for (int i = 0; i < singles; ++i) {
    made.singles.push_back(region_of_pose({uniform(region.x.least, region.x.most, rng),
                                           uniform(region.y.least, region.y.most, rng),
                                           uniform(region.heading.from, region.heading.to, rng)}));
  }
  return made;
}

/// Docks of 3.8 m side by side, boxes before them here and there.
Case with_docks(std::uint64_t seed) {
  constexpr int docks = 100;
  Rng rng(seed);
  Scenario scenario{.bounds = {0, 440, 0, 60}, .start = {uniform(20, 400, rng), 15, 0}};
  const auto add_box = [&](double x, double y, double width, double height) {
    scenario.obstacles.push_back(
        {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
  };
  for (int i = 0; i < docks; ++i) {
    scenario.goal_set.push_back(region_of_pose({22 + 4.0 * i, 46, -pi / 2}));
    add_box(19.9 + 4.0 * i, 44, 0.2, 12);
    if (uniform01(rng) < 0.2) add_box(20 + 4.0 * i, uniform(24, 32, rng), uniform(2, 9, rng), 4);
  }
  add_box(10, 48, 430, 8);
  const Problem set = make_problem(scenario);
  Case made{set, {{"docks", set}}, scenario.goal_set};
  const auto nearest = std::min_element(
      made.singles.begin(), made.singles.end(), [&](const GoalRegion& a, const GoalRegion& b) {
        return std::abs(a.x.least - scenario.start.x) < std::abs(b.x.least - scenario.start.x);
      });
  made.fixed = with_goal_set(set, {*nearest});
  return made;
}

Case made(const Arguments& arguments, std::uint64_t number) {
  if (arguments.kind == "docks") return with_docks(number);
  const Problem fixed = random_world(number);
  if (arguments.kind == "areas") return with_area(fixed, arguments.singles, number);
  return with_headings(fixed, arguments.singles);
}

PlanResult planned(const Problem& problem, double seconds) {
  PlanOptions options;
  options.budget.time_limit = seconds;
  return plan(problem, options);
}

double first_of(const PlanResult& result) {
  return result.path ? 1e3 * result.anytime.front().time : never;
}

/// What is printed of one kind of set.
struct Column {
  std::string name;
  int solved = 0;
  std::vector<double> firsts, firsts_of_fixed, excesses;
};

void run(const Arguments& arguments) {
  std::vector<Column> columns;
  for (std::uint64_t number = arguments.first; number <= arguments.last; ++number) {
    const Case now = made(arguments, number);
    const PlanResult fixed = planned(now.fixed, arguments.seconds);
    double best = never;
    if (arguments.singles > 0) {
      for (const GoalRegion& single : now.singles) {
        const PlanResult result =
            planned(with_goal_set(now.fixed, {single}), arguments.seconds_of_single);
        if (result.path) best = std::min(best, result.cost);
      }
    }
    columns.resize(now.sets.size());
    for (std::size_t i = 0; i < now.sets.size(); ++i) {
      const auto& [name, problem] = now.sets[i];
      const PlanResult result = planned(problem, arguments.seconds);
      Column& column = columns[i];
      column.name = name;
      if (result.path) ++column.solved;
      if (fixed.path && result.path) {
        column.firsts.push_back(first_of(result));
        column.firsts_of_fixed.push_back(first_of(fixed));
      }
      const double excess = 100 * (result.cost / best - 1);
      if (result.path && best < never) column.excesses.push_back(excess);
      std::printf(
          "%5llu %-12s %-10s first %s ms (fixed %s), cost %s, singles %s, %s %%\n",
          static_cast<unsigned long long>(number), name.c_str(),
          std::string(name_of(result.status)).c_str(), figure("%7.2f", first_of(result)).c_str(),
          figure("%7.2f", first_of(fixed)).c_str(),
          figure("%8.2f", result.path ? result.cost : never).c_str(), figure("%8.2f", best).c_str(),
          figure("%6.2f", result.path && best < never ? excess : never).c_str());
      std::fflush(stdout);
    }
  }
  for (const Column& column : columns) {
    std::printf(
        "%s: %d solved; first path %s ms in the median (fixed %s); above the best single "
        "pose: median %s %%, 95 %% %s, worst %s\n",
        column.name.c_str(), column.solved, figure("%.2f", quantile(column.firsts, 0.5)).c_str(),
        figure("%.2f", quantile(column.firsts_of_fixed, 0.5)).c_str(),
        figure("%.2f", quantile(column.excesses, 0.5)).c_str(),
        figure("%.2f", quantile(column.excesses, 0.95)).c_str(),
        figure("%.2f", quantile(column.excesses, 1.0)).c_str());
  }
}

}  // namespace
}  // namespace vandplan

int main(int argc, char** argv) {
  const std::string kind = argc > 1 ? argv[1] : "";
  if (argc < 5 || (kind != "headings" && kind != "areas" && kind != "docks")) {
    std::fprintf(stderr,
                 "usage: goal_sets_bench headings|areas|docks FIRST LAST SECONDS [SINGLES "
                 "SECONDS_OF_SINGLE]\n");
    return 2;
  }
  try {
    vandplan::run({.kind = kind,
                   .first = std::strtoull(argv[2], nullptr, 10),
                   .last = std::strtoull(argv[3], nullptr, 10),
                   .seconds = std::atof(argv[4]),
                   .singles = argc > 5 ? std::atoi(argv[5]) : 0,
                   .seconds_of_single = argc > 6 ? std::atof(argv[6]) : 1.0});
  } catch (const vandplan::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
