// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How does my truck plan anew when something stands in its way?

#include <vandplan/judge.h>
#include <vandplan/replanner.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

int main() {
  vandplan::Scenario yard;
  yard.bounds = {-10, 70, -20, 20};
  yard.start = {0, 0, 0};
  yard.goal = {60, 0, 0};
  const vandplan::Polygon crates = {{35, -2}, {38, -2}, {38, 2}, {35, 2}};

  vandplan::ReplanOptions options;
  options.plan.budget.max_iterations = 2000;  // limit of the first plan
  vandplan::Replanner replanner(yard, options);
  vandplan::ReplanAnswer before;
  vandplan::Motion now;
  double aside = 0.0;  // largest distance of the truck from the lane [m]
  int unsafe_ticks = 0;
  int ticks = 0;
  for (; ticks < 1000; ++ticks) {
    const double t = 0.1 * ticks;  // time of the tick [s]
    if (ticks == 80) {             // after 8 s the truck sees crates
      before = replanner.answer();
      replanner.patch({.added = {{.name = 1, .outline = crates}}});
    }
    // Here the truck follows the last answer exactly. tick(t, state) takes a measured state.
    const vandplan::ReplanAnswer answer = replanner.tick(t);
    unsafe_ticks += answer.is_safe ? 0 : 1;
    if (!answer.drive) return 1;
    now = vandplan::motion_at(answer.drive->path, yard.vehicle, answer.drive->speeds,
                              t - answer.begin);
    aside = std::max(aside, std::abs(now.pose.y));
    if (answer.outcome != vandplan::TickOutcome::kept) {
      std::printf("t %4.1f  x %5.2f  v %4.2f m/s: %s, to arrive at %.1f s\n", t, now.pose.x, now.v,
                  std::string(vandplan::name_of(answer.outcome)).c_str(),
                  answer.begin + answer.drive->speeds.duration);
    }
    if (answer.has_arrived) break;
  }
  const double left = std::hypot(now.pose.x - yard.goal.x, now.pose.y - yard.goal.y);
  std::printf("after %d ticks %.3f m from the goal, on the way %.2f m aside; unsafe ticks: %d\n",
              ticks, left, aside, unsafe_ticks);

  // The judge says what the truck would have hit on its first plan.
  yard.obstacles = {crates};
  const auto check = vandplan::check_path(vandplan::make_problem(yard), before.drive->path);
  std::printf("the first plan: %s\n", check.reason.c_str());
  return !check.valid && unsafe_ticks == 0 && left < 1e-3 ? 0 : 1;
}
