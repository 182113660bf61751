// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/hybrid_a_star.h"
#include "planners/shared_options.h"

namespace vandplan::hybrid {
namespace {

std::vector<OptionInfo> options() {
  std::vector<OptionInfo> all = planning::estimate_options("reeds-shepp", "any-angle");
  const std::vector<OptionInfo> own = {
      {.name = "weight",
       .summary = "of the estimate; the path costs about as many times the least at most",
       .standard = 1.15,
       .least = 1,
       .most = 1000},
      {.name = "cell",
       .summary = "side of a cell of positions [m]",
       .standard = 0.5,
       .least = 0.01,
       .most = 100},
      {.name = "headings",
       .summary = "cells of a full turn",
       .standard = std::int64_t{72},
       .least = 4,
       .most = 4096},
      {.name = "step",
       .summary = "length of arcs and lines [m]; 0: out of a cell, by whole cells of heading",
       .standard = 0.0,
       .least = 0,
       .most = 1000},
      {.name = "variable_step",
       .summary = "half and quarter steps and cells where there is little room",
       .standard = false},
      {.name = "voronoi_weight",
       .summary =
           "keeps to the middle between things: a metre beside it counts up to 1 + this times "
           "as much in the search, not in the cost",
       .standard = 0.0,
       .least = 0,
       .most = 1000},
      {.name = "shot_spacing",
       .summary = "the exact way to the goal is tried once in 1 + estimate / this expansions [m]",
       .standard = 10.0,
       .least = 0.01,
       .most = 1e9},
      {.name = "improve",
       .summary = "go on until no pose is left that could lead to a cheaper path",
       .standard = false},
      {.name = "shorten",
       .summary = "shorten the path by exact shortcuts until they bring next to nothing",
       .standard = true},
      {.name = "max_nodes",
       .summary = "of the search tree",
       .standard = std::int64_t{2'000'000},
       .least = 1,
       .most = 100'000'000},
      {.name = "keep_tree", .summary = "return the search tree as well", .standard = false}};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace

Planner planner() {
  return {.name = "hybrid-a-star",
          .summary = "cells of position and heading with a continuous pose each, exact end",
          .properties = {.family = "hybrid-a-star",
                         .honours_prices = true,
                         .honours_gears = true,
                         .groups = {"family"}},
          .options = options(),
          .function = plan};
}

}  // namespace vandplan::hybrid
