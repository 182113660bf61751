// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/search_matrix.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <tuple>

namespace vandplan::evaluation {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

using GoalKey = std::tuple<std::size_t, std::size_t>;  // scenario and goal
using Runs = std::vector<const RunRecord*>;

GoalKey goal_of(const RunRecord& run) { return {run.scenario, run.goal}; }

std::map<GoalKey, double> least_costs(const std::vector<RunRecord>& runs) {
  std::map<GoalKey, double> least;
  for (const RunRecord& run : runs) {
    double& cost = least.try_emplace(goal_of(run), never).first->second;
    cost = std::min(cost, final_cost(run));
  }
  return least;
}

Runs timed_runs(const std::vector<RunRecord>& runs, const std::string& planner, Region region) {
  Runs found;
  for (const RunRecord& run : runs) {
    if (run.planner == planner && run.region == region && !is_profiled(run)) found.push_back(&run);
  }
  return found;
}

// Iterations until the first path; infinite without a path.
double first_work(const RunRecord& run) {
  return run.result.anytime.empty() ? never
                                    : static_cast<double>(run.result.anytime.front().iteration);
}

template <typename Value>
MedianEstimate median_over(const Runs& runs, Value value) {
  std::vector<double> values;
  values.reserve(runs.size());
  for (const RunRecord* run : runs) values.push_back(value(*run));
  return median_of(std::move(values), confidence);
}

int solved_among(const Runs& runs) {
  return static_cast<int>(std::ranges::count_if(
      runs, [](const RunRecord* run) { return run->result.path.has_value(); }));
}

MatrixCell cell_of(const Planner& planner, const Runs& runs,
                   const std::map<GoalKey, double>& least) {
  const auto cost_after = [&](double time) {
    return median_over(runs, [&](const RunRecord& run) {
      const double cost = cost_at(run, time);
      const double best = least.at(goal_of(run));
      return cost == best ? 1.0 : cost / best;
    });
  };
  MatrixCell cell{.planner = planner.name,
                  .search = planner.properties.search,
                  .estimate = planner.properties.estimate,
                  .runs = static_cast<int>(runs.size()),
                  .solved = solved_among(runs)};
  cell.solved_interval = share_interval(cell.solved, cell.runs, confidence);
  cell.first_time = median_over(runs, first_solution_time);
  cell.first_work = median_over(runs, first_work);
  cell.cost_at_10ms = cost_after(0.01);
  cell.cost_at_100ms = cost_after(0.1);
  cell.cost_at_1s = cost_after(1.0);
  return cell;
}

// A search and its estimate.
struct Guided {
  std::string_view search;
  std::string_view estimate;
};

// A claim of the literature: `planner` is better than `rival`.
struct Claim {
  std::string_view text;
  Guided planner;
  Guided rival;
};

constexpr std::array literature_claims = {
    Claim{"the larger of table and grid guides better than the table alone (Dolgov et al. 2010)",
          {"hybrid-a-star", "max-hlut-4-grid"},
          {"hybrid-a-star", "hlut-4"}},
    Claim{"the larger of table and grid guides better than the grid alone (Dolgov et al. 2010)",
          {"hybrid-a-star", "max-hlut-4-grid"},
          {"hybrid-a-star", "grid"}},
    Claim{"telling visible from invisible space is five times as fast as the larger of table and "
          "grid (Choi, as the thesis tells it)",
          {"hybrid-a-star", "choi"},
          {"hybrid-a-star", "max-hlut-4-grid"}},
    Claim{"heuristic biasing finds cheaper paths than RRT (Urmson and Simmons 2003)",
          {"hrrt", "reeds-shepp"},
          {"rrt-bsc", "reeds-shepp"}},
    Claim{"the table of a lattice guides better than Euclid (Cirillo 2017, Bergman 2019)",
          {"lattice-a-star", "lattice-table"},
          {"lattice-a-star", "euclid"}},
    Claim{"committing to a path in bounded time costs little (Cirillo 2017)",
          {"ltba-star", "lattice-table"},
          {"lattice-a-star", "lattice-table"}},
};

const Planner* find(const std::vector<Planner>& planners, const Guided& wanted) {
  const auto found = std::ranges::find_if(planners, [&](const Planner& planner) {
    return planner.properties.search == wanted.search &&
           planner.properties.estimate == wanted.estimate;
  });
  return found == planners.end() ? nullptr : &*found;
}

// Compares runs in pairs with the same goal and seed.
void compare(const Runs& runs, const Runs& rivals, LiteratureFinding& finding) {
  std::map<std::tuple<GoalKey, std::uint64_t>, const RunRecord*> partners;
  for (const RunRecord* run : rivals) partners[{goal_of(*run), run->seed}] = run;
  Runs first, second;
  for (const RunRecord* run : runs) {
    const auto partner = partners.find({goal_of(*run), run->seed});
    if (partner == partners.end()) continue;
    first.push_back(run);
    second.push_back(partner->second);
  }
  const auto compared = [&](auto value) {
    std::vector<double> a, b;
    for (const RunRecord* run : first) a.push_back(value(*run));
    for (const RunRecord* run : second) b.push_back(value(*run));
    return compare_pairs(a, b, confidence);
  };
  finding.first_time = compared(first_solution_time);
  finding.first_work = compared(first_work);
  finding.cost = compared(final_cost);
  finding.solved = solved_among(first);
  finding.rival_solved = solved_among(second);
}

}  // namespace

std::vector<MatrixCell> search_matrix(const std::vector<Planner>& planners,
                                      const std::vector<RunRecord>& runs, Region region) {
  const std::map<GoalKey, double> least = least_costs(runs);
  std::vector<MatrixCell> cells;
  std::set<std::string> searches;
  for (const Planner& planner : planners) {
    if (planner.properties.search.empty()) continue;
    const Runs own = timed_runs(runs, planner.name, region);
    if (own.empty()) continue;
    searches.insert(planner.properties.search);
    cells.push_back(cell_of(planner, own, least));
  }
  if (searches.size() == cells.size()) cells.clear();
  return cells;
}

std::vector<LiteratureFinding> literature_findings(const std::vector<Planner>& planners,
                                                   const std::vector<RunRecord>& runs) {
  std::vector<LiteratureFinding> findings;
  for (const Region region : {Region::bounds, Region::scene}) {
    for (const Claim& claim : literature_claims) {
      const Planner* const planner = find(planners, claim.planner);
      const Planner* const rival = find(planners, claim.rival);
      if (planner == nullptr || rival == nullptr) continue;
      LiteratureFinding finding{.region = region,
                                .claim = std::string(claim.text),
                                .planner = planner->name,
                                .rival = rival->name};
      compare(timed_runs(runs, planner->name, region), timed_runs(runs, rival->name, region),
              finding);
      if (finding.cost.pairs > 0) findings.push_back(std::move(finding));
    }
  }
  return findings;
}

}  // namespace vandplan::evaluation
