// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/estimate_options.h"
#include "lab/hybrid_a_star.h"

namespace vandplan::hybrid {
namespace {

std::vector<OptionInfo> options() {
  std::vector<OptionInfo> all = planning::estimate_options("reeds-shepp", "any-angle");
  const std::vector<OptionInfo> own = {
      {.name = "weight",
       .summary = "weight of the estimate; bounds the cost to about this times the optimum",
       .default_value = 1.15,
       .least = 1,
       .most = 1000},
      {.name = "cell",
       .summary = "cell size [m]",
       .default_value = 0.5,
       .least = 0.01,
       .most = 100},
      {.name = "headings",
       .summary = "heading cells per turn",
       .default_value = std::int64_t{72},
       .least = 4,
       .most = 4096},
      {.name = "step",
       .summary = "length of arcs and lines [m]; 0: out of a cell, whole heading cells",
       .default_value = 0.0,
       .least = 0,
       .most = 1000},
      {.name = "variable_step",
       .summary = "shorter steps and smaller cells in narrow places",
       .default_value = false},
      {.name = "voronoi_weight",
       .summary = "weight of the Voronoi potential in the search, not in the cost",
       .default_value = 0.0,
       .least = 0,
       .most = 1000},
      {.name = "shot_spacing",
       .summary = "one exact connection to the goal in 1 + estimate / this expansions [m]",
       .default_value = 10.0,
       .least = 0.01,
       .most = 1e9},
      {.name = "improve",
       .summary = "search until no pose can lead to a cheaper path",
       .default_value = false},
      {.name = "shorten", .summary = "shorten the path by exact shortcuts", .default_value = true},
      {.name = "max_nodes",
       .summary = "largest search tree [nodes]",
       .default_value = std::int64_t{2'000'000},
       .least = 1,
       .most = 100'000'000},
      {.name = "keep_tree", .summary = "return the search tree", .default_value = false}};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace

Planner planner() {
  return {.name = "hybrid-a-star",
          .summary = "Hybrid A*: one continuous pose per cell of position and heading",
          .properties = {.family = "hybrid-a-star",
                         .capabilities = {Capability::prices, Capability::gears},
                         .groups = {"family"}},
          .options = options(),
          .function = plan};
}

}  // namespace vandplan::hybrid
