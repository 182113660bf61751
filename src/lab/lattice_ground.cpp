// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Which estimate guides a search over a lattice, and which options does the search have?

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "lab/estimate_options.h"
#include "lab/lattice_search.h"

namespace vandplan::lattice {
namespace {

constexpr std::string_view table_name = "lattice-table";

/// Whether an estimate is consistent: along an edge it falls by at most the edge's length.
bool is_metric(std::string_view name) { return name == "euclid" || name == "reeds-shepp"; }

Guide guide_named(const std::string& name, const Task& task, const PlanOptions& options,
                  const LatticeGraph& graph) {
  if (name == table_name) {
    return {.length = [&graph](const Vertex& vertex) { return graph.least_way(vertex); }};
  }
  GoalEstimate estimate = planning::estimate_named(name, options, task);
  return {.length = [&graph, length = std::move(estimate.length)](
                        const Vertex& vertex) { return length(graph.pose_of(vertex)); },
          .is_admissible = estimate.is_admissible,
          .is_consistent = is_metric(name)};
}

Guide guide_of(const Task& task, const PlanOptions& options, const LatticeGraph& graph) {
  Guide first = guide_named(options.planner.word(planning::estimate_key), task, options, graph);
  const std::string& name = options.planner.word(planning::max_with_key);
  if (name == planning::no_estimate) return first;
  Guide second = guide_named(name, task, options, graph);
  return {.length = [a = std::move(first.length), b = std::move(second.length)](
                        const Vertex& vertex) { return std::max(a(vertex), b(vertex)); },
          .is_admissible = first.is_admissible && second.is_admissible,
          .is_consistent = first.is_consistent && second.is_consistent};
}

}  // namespace

Ground ground_of(const Task& task, const PlanOptions& options, const Budget& budget) {
  const auto is_interrupted = [&] { return budget.is_interrupted(); };
  const AllowedGears gears = options.cost.gears;
  LatticeParts parts = options.primitives
                           ? given_lattice(task, options.primitives, is_interrupted, gears)
                           : standard_lattice(task, is_interrupted, gears);
  if (parts.table == nullptr) return {};
  Ground ground{std::make_unique<const LatticeGraph>(task, std::move(parts)), {}};
  ground.guide = guide_of(task, options, *ground.graph);
  return ground;
}

std::vector<OptionInfo> shared_options() {
  std::vector<OptionInfo> all = planning::estimate_options(table_name);
  for (OptionInfo& option : all) option.words.emplace_back(table_name);
  all.push_back(
      {.name = "shots", .summary = "try exact connections to the goal", .default_value = true});
  all.push_back({.name = "max_nodes",
                 .summary = "largest number of vertices, up to 900 bytes each",
                 .default_value = std::int64_t{500'000},
                 .least = 1,
                 .most = 50'000'000});
  all.push_back({.name = "keep_tree", .summary = "return the search tree", .default_value = false});
  return all;
}

}  // namespace vandplan::lattice
