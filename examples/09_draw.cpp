// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I draw a problem, its path and the tree that found it?
// usage: 09_draw [FILE.svg]

#include <vandplan/draw.h>
#include <vandplan/planner.h>

#include <fstream>
#include <string>

int main(int argc, char** argv) {
  const std::string file = argc > 1 ? argv[1] : "yard.svg";
  vandplan::Scenario yard;
  yard.bounds = {-50, 50, -50, 50};
  yard.goal = {0, 12, 0};
  yard.obstacles = {{{-20, 5}, {15, 5}, {15, 7}, {-20, 7}}};

  vandplan::PlanOptions options;
  options.budget.max_iterations = 1000;
  options.planner.set("keep_tree", true);
  const auto result = vandplan::plan(vandplan::make_problem(yard),
                                     vandplan::planner_named("rrt-opt-bound-goal"), options);
  if (!result.path || !result.tree) return 1;

  const vandplan::Drawing drawing{.scenario = &yard,
                                  .path = &*result.path,
                                  .tree = &*result.tree,
                                  .caption = "around the wall"};
  std::ofstream(file) << vandplan::draw(drawing, vandplan::picture_format(file), 600);
  return std::ifstream(file).peek() == '<' ? 0 : 1;
}
