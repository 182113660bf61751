// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Prints what every planner answers to the thesis' scenarios, to those with a trailer and to those
// with moving obstacles: a line for each run with its status, cost, counts and a hash of the path.
// compare_answers compares them with answers.txt.
// usage: golden_answers SCENARIOS

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "vandplan/files.h"
#include "vandplan/planner.h"

namespace {

using namespace vandplan;

/// The numbers that make a segment; those of arcs and lines are two.
std::vector<double> numbers_of(const Segment& segment) {
  std::vector<double> numbers = {segment.curvature, segment.length};
  if (segment.curvature_rate != 0.0) numbers.push_back(segment.curvature_rate);
  return numbers;
}

/// FNV-1a over the bits of all numbers of the segments.
unsigned long long hash_of(const Path& path) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const Segment& segment : path.segments) {
    for (const double value : numbers_of(segment)) {
      const auto bits = std::bit_cast<std::uint64_t>(value);
      for (int byte = 0; byte < 8; ++byte) {
        hash = (hash ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
      }
    }
  }
  return hash;
}

void answer(const std::string& scenario, const Problem& problem, const Planner& planner,
            PlanOptions options, const char* what) {
  for (const std::string region : {"bounds", "scene"}) {
    if (honours(planner, "region")) {
      options.planner.set("region", region);
    } else if (region != "bounds") {
      continue;  // it would only answer the same
    }
    const PlanResult result = plan(problem, planner, options);
    std::printf(
        "%s %s %s%s: %s, cost %.17g, %lld iterations, %lld nodes, path %016llx\n", scenario.c_str(),
        region.c_str(), planner.name.c_str(), what, std::string(name_of(result.status)).c_str(),
        result.cost, static_cast<long long>(result.iterations),
        static_cast<long long>(counter(result, "nodes")), hash_of(result.path.value_or(Path{})));
  }
}

// Iterations until most runs have an answer. Searches of the literature expand many small steps
// before they find a path, and so do those for a vehicle with a trailer.
std::int64_t iterations_of(const Planner& planner, const Problem& problem) {
  const std::vector<std::string>& groups = planner.properties.groups;
  if (problem.vehicle().trailer) return 12000;
  if (std::find(groups.begin(), groups.end(), "family") != groups.end()) return 6000;
  return planner.can(Capability::prices) ? 2000 : 600;
}

// A map that a scenario names lies beside it.
bool is_scenario(const std::filesystem::path& file) {
  return file.extension() == ".yaml" && !file.stem().string().ends_with("-cells");
}

void answer_all(const std::string& file) {
  const auto [scenario, problems] = read_problems(file);
  const std::size_t goal = scenario.is_row() ? problems.size() / 2 : 0;
  const Task& task = problems[goal].task();
  const bool is_plain = !task.vehicle.trailer && task.moving.empty();
  std::string name = scenario.scenario.name;
  if (scenario.is_row()) name += " goal " + std::to_string(goal);
  for (const Planner& planner : planners()) {
    const bool takes_all = planner.can(Capability::trailers) && planner.can(Capability::moving);
    if (!is_plain && !takes_all) continue;
    const bool honours_prices = planner.can(Capability::prices);
    PlanOptions options{.cost = shortest_style, .steering = Steering::reeds_shepp};
    options.budget.max_iterations = iterations_of(planner, problems[goal]);
    answer(name, problems[goal], planner, options, "");
    if (!honours_prices) continue;
    options.cost.reverse_weight = 2;
    options.cost.gear_change_cost = 5;
    answer(name, problems[goal], planner, options, " reverse_weight=2 gear_change_cost=5");
    options.cost = driver_style;
    options.steering.reset();
    answer(name, problems[goal], planner, options, " style=driver");
    if (!planner.can(Capability::steering)) continue;
    if (!is_plain) {
      options.cost = {.measure = CostMeasure::time};
      answer(name, problems[goal], planner, options, " cost=time");
    }
    options.cost = shortest_style;
    options.steering = Steering::continuous_between_stops;
    answer(name, problems[goal], planner, options, " steering=continuous-between-stops");
    options.steering = Steering::continuous;
    answer(name, problems[goal], planner, options, " steering=continuous");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[1])) {
    if (is_scenario(entry.path())) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  for (const std::string& file : files) answer_all(file);
}
