// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I check a path that somebody else has planned?

#include <vandplan/judge.h>

#include <cstdio>

int main() {
  vandplan::Scenario yard;
  yard.bounds = {-10, 50, -20, 20};
  yard.goal = {30, 0, 0};
  yard.obstacles = {{{0, 2}, {30, 2}, {30, 3}, {0, 3}}};
  const vandplan::Problem problem = vandplan::make_problem(yard);

  vandplan::Path path{{0, 0, 0}, {{0, 30}}};  // straight ahead
  const vandplan::PathCheck good = vandplan::check_path(problem, path, {.length = 30});
  std::printf("%s; %.3f m from the wall\n", good.valid ? "valid" : good.reason.c_str(),
              good.clearance.value_or(0));

  path.segments = {{0.01, 30}};  // a little to the left: into the wall
  const vandplan::PathCheck bad = vandplan::check_path(problem, path);
  if (!bad.at) return 1;
  std::printf("%s after %.2f m, at x %.2f, y %.2f\n", bad.reason.c_str(), bad.at->s, bad.at->pose.x,
              bad.at->pose.y);
  return good.valid && !bad.valid ? 0 : 1;
}
