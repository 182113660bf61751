// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/sites.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "embedded_scenarios.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan::studies {
namespace {

using evaluation::PairedComparison;

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double confidence = 0.95;
constexpr int most_draws = 10'000;  // random poses that are tried for a start

/// A search and its planners. The last one is guided by the table.
struct Entry {
  const char* name;
  std::vector<const char*> planners;
};

/// The default planner is no search that takes an estimate; it begins with the table's way.
constexpr const char* with_table = "anytime, with the table";

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      {"hybrid A*",
       {"hybrid-a-star:reeds-shepp", "hybrid-a-star:hlut-4", "hybrid-a-star:grid",
        "hybrid-a-star:any-angle", "hybrid-a-star:choi", "hybrid-a-star:max-reeds-shepp-any-angle",
        "hybrid-a-star:site"}},
      {"lattice A*",
       {"lattice-a-star:lattice-table", "lattice-a-star:max-lattice-table-any-angle",
        "lattice-a-star:choi", "lattice-a-star:site"}},
      {"hRRT",
       {"hrrt:euclid", "hrrt:reeds-shepp", "hrrt:max-reeds-shepp-any-angle", "hrrt:choi",
        "hrrt:site"}},
      {"BSC, as printed",
       {"rrt-bsc-euc", "rrt-bsc-hlut-2", "rrt-bsc-hlut-4", "rrt-bsc-rs", "rrt-bsc-site"}},
      {"BSC, goal tried",
       {"rrt-bsc-euc-goal", "rrt-bsc-hlut-2-goal", "rrt-bsc-hlut-4-goal", "rrt-bsc-rs-goal",
        "rrt-bsc-site-goal"}},
      {"OPT, as printed",
       {"rrt-opt-euc", "rrt-opt-hlut-2", "rrt-opt-hlut-4", "rrt-opt-rs", "rrt-opt-site"}},
      {"OPT, goal tried",
       {"rrt-opt-euc-goal", "rrt-opt-hlut-2-goal", "rrt-opt-hlut-4-goal", "rrt-opt-rs-goal",
        "rrt-opt-site-goal"}},
      {"the default planner", {"anytime", with_table}}};
  return all;
}

/// Searches that coarser tables are tried with: numbers in `entries`.
constexpr std::array<std::size_t, 3> coarse_searches = {0, 2, 4};

struct Resolution {
  int headings;
  double cell;
};
constexpr std::array resolutions = {Resolution{36, 0.12}, Resolution{36, 0.25}, Resolution{36, 0.5},
                                    Resolution{18, 0.12}, Resolution{18, 0.5},  Resolution{9, 1.0}};

/// Poses that a scenario's goal consists of; the middle of a region of many.
std::vector<Pose> goals_of(const Scenario& scenario) {
  if (scenario.goal_set.empty()) return {scenario.goal};
  std::vector<Pose> goals;
  goals.reserve(scenario.goal_set.size());
  for (const GoalRegion& region : scenario.goal_set) goals.push_back(some_pose(region));
  return goals;
}

PlanOptions by_length() { return complete(default_planner(), {.style = Style::shortest}); }

/// A site in the making: its world with a first problem, free goals, and a table for each
/// resolution.
class Ground {
 public:
  explicit Ground(const StudiedSite& site) : problem_(problem_of(site.scenario)) {
    for (const Pose& goal : goals_of(site.scenario)) {
      const Task task = with_poses(problem_, goal, goal).task();
      if (task.checker->is_free(task.goal)) goals_.push_back(goal);
    }
    for (const auto& [headings, cell] : resolutions) {
      try {
        tables_.push_back(std::make_shared<const SiteTable>(
            *make_site_table(problem_, goals_, by_length(), {.headings = headings, .cell = cell})));
      } catch (const InputError& error) {
        throw InputError(site.name, error.where() + ": " + error.problem());
      }
    }
  }

  /// Start and goal of a run: the first start is the scenario's, the others are random and free.
  [[nodiscard]] std::pair<Pose, Pose> ends(int number, Rng& rng) const {
    const Pose& goal = goals_[static_cast<std::size_t>(number) % goals_.size()];
    const Task task = problem_.task();
    const Local<Bounds> region = sampling_region(task, Region::scene);
    LocalPose start = task.start;
    for (int draw = 0; draw < most_draws && (draw == 0 || !task.checker->is_free(start)); ++draw) {
      if (number > 0 || draw > 0) start = uniform_pose(region, rng);
    }
    return {to_scenario(*task.world, start), goal};
  }

  [[nodiscard]] Problem between(const Pose& start, const Pose& goal) const {
    return with_poses(problem_, start, goal);
  }
  [[nodiscard]] const std::shared_ptr<const SiteTable>& table(std::size_t resolution) const {
    return tables_[resolution];
  }
  [[nodiscard]] double megabytes(std::size_t resolution) const {
    const auto bytes = static_cast<double>(site_table_to_bytes(*tables_[resolution]).size());
    return 1e-6 * bytes / static_cast<double>(goals_.size());
  }

 private:
  static Problem problem_of(Scenario scenario) {
    scenario.goal = goals_of(scenario).front();
    scenario.goal_set.clear();
    scenario.via.clear();
    scenario.curvatures = {};
    return make_problem(scenario);
  }

  Problem problem_;
  std::vector<Pose> goals_;
  std::vector<std::shared_ptr<const SiteTable>> tables_;
};

/// Runs a planner on a problem and adds what came out.
void run(const Problem& problem, const std::shared_ptr<const SiteTable>& table,
         const PlanOptions& limits, SiteRuns& runs) {
  const bool is_default = runs.planner == with_table;
  const Planner planner = is_default ? default_planner() : planner_named(runs.planner);
  PlanOptions options = limits;
  options.style = Style::shortest;
  if (honours(planner, "region")) set_option(options, planner, "region", "scene");
  if (is_default || asks_for_estimate(planner, options, "site")) options.site = table;
  const PlanResult result = plan(problem, planner, options);
  const bool is_solved = result.path && !result.anytime.empty();
  runs.costs.push_back(is_solved ? result.cost : never);
  runs.first.push_back(is_solved ? result.anytime.front().time : never);
  if (is_solved) ++runs.solved;
}

/// Least cost of each problem, by whichever planner.
std::vector<double> least_costs(const SitesStudy& study) {
  std::vector<double> least(study.problems.size(), never);
  const auto look_at = [&](const std::vector<SiteRuns>& all) {
    for (const SiteRuns& runs : all) {
      for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], runs.costs[i]);
    }
  };
  for (const SiteSearch& search : study.searches) look_at(search.runs);
  for (const SiteResolution& resolution : study.resolutions) look_at(resolution.runs);
  return least;
}

void summarise(SiteRuns& runs, const std::vector<double>& least) {
  std::vector<double> over;
  over.reserve(least.size());
  for (std::size_t i = 0; i < least.size(); ++i) {
    over.push_back(runs.costs[i] == least[i] ? 1.0 : runs.costs[i] / least[i]);
  }
  runs.over_best = evaluation::median_of(over, confidence).median;
  runs.median_first = evaluation::median_of(runs.first, confidence).median;
}

void compare(SiteSearch& search) {
  const SiteRuns& by_table = search.runs.back();
  const auto is_better = [](const SiteRuns& a, const SiteRuns& b) {
    return a.solved != b.solved ? a.solved > b.solved : a.over_best < b.over_best;
  };
  const auto rival = std::min_element(search.runs.begin(), search.runs.end() - 1, is_better);
  search.rival = static_cast<std::size_t>(rival - search.runs.begin());
  for (std::size_t i = 0; i < rival->costs.size(); ++i) {
    search.shorter += by_table.costs[i] < rival->costs[i] ? 1 : 0;
    search.longer += by_table.costs[i] > rival->costs[i] ? 1 : 0;
  }
  search.cost = evaluation::compare_pairs(by_table.costs, rival->costs, confidence);
  search.first = evaluation::compare_pairs(by_table.first, rival->first, confidence);
}

/// Problems that no planner solves say nothing, and are left out.
void drop_unsolved(SitesStudy& study) {
  const std::vector<double> least = least_costs(study);
  const auto drop_from = [&](auto& values) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < least.size(); ++i) {
      if (least[i] < never) values[kept++] = values[i];
    }
    values.resize(kept);
  };
  const auto drop_from_all = [&](std::vector<SiteRuns>& all) {
    for (SiteRuns& runs : all) {
      drop_from(runs.costs);
      drop_from(runs.first);
    }
  };
  for (SiteSearch& search : study.searches) drop_from_all(search.runs);
  for (SiteResolution& resolution : study.resolutions) drop_from_all(resolution.runs);
  drop_from(study.problems);
}

void run_all(SitesStudy& study, const Ground& ground, const Problem& problem, std::uint64_t seed) {
  PlanOptions limits;
  limits.budget.time_limit = study.options.time_limit;
  limits.budget.processor_time = true;
  limits.budget.seed = seed;
  for (SiteSearch& search : study.searches) {
    for (SiteRuns& runs : search.runs) run(problem, ground.table(0), limits, runs);
  }
  for (std::size_t i = 0; i < resolutions.size(); ++i) {
    for (SiteRuns& runs : study.resolutions[i].runs) {
      run(problem, ground.table(i), limits, runs);
    }
  }
}

SitesStudy begun(const SitesOptions& options) {
  SitesStudy study{.options = options};
  if (study.options.sites.empty()) study.options.sites = usual_sites();
  for (const auto& [name, planners] : entries()) {
    SiteSearch search{.name = name};
    for (const char* const planner : planners) search.runs.push_back({.planner = planner});
    study.searches.push_back(std::move(search));
  }
  for (const auto& [headings, cell] : resolutions) {
    SiteResolution resolution{.headings = headings, .cell = cell};
    for (const std::size_t number : coarse_searches) {
      resolution.runs.push_back({.planner = entries()[number].planners.back()});
    }
    study.resolutions.push_back(std::move(resolution));
  }
  return study;
}

std::string csv_of_runs(const SitesStudy& study) {
  std::string csv = "search,runs,planner,site,start,length,first\n";
  for (std::size_t s = 0; s < study.searches.size(); ++s) {
    const std::vector<SiteRuns>& all = study.searches[s].runs;
    for (std::size_t r = 0; r < all.size(); ++r) {
      for (std::size_t i = 0; i < study.problems.size(); ++i) {
        csv += fmt::format("{},{},\"{}\",{},{},{:.6g},{:.6g}\n", s, r, all[r].planner,
                           study.options.sites[study.problems[i].site].name, i, all[r].costs[i],
                           all[r].first[i]);
      }
    }
  }
  return csv;
}

std::string csv_of_tables(const SitesStudy& study) {
  std::string csv = "headings,cell,megabytes,planner,solved,over_best,first\n";
  for (const auto& [headings, cell, megabytes, all] : study.resolutions) {
    for (const SiteRuns& runs : all) {
      csv += fmt::format("{},{},{:.4f},\"{}\",{},{:.6g},{:.6g}\n", headings, cell, megabytes,
                         runs.planner, runs.solved, runs.over_best, runs.median_first);
    }
  }
  return csv;
}

/// Share of the problems that some runs have solved by a time. Other lines of the file weigh
/// nothing and stand far off: missing values would cut the curve.
std::string curve(std::size_t search, std::size_t runs, double share, const std::string& title,
                  const std::string& look) {
  const std::string counts = fmt::format("$1=={} && $2=={} && $7<1e9", search, runs);
  return fmt::format(
      "'sites_runs.csv' skip 1 using ({0} ? 1000*$7 : 1e9):({0} ? {1:.6f} : 0) smooth cumulative "
      "with lines {2} title '{3}'",
      counts, share, look, title);
}

}  // namespace

std::vector<StudiedSite> usual_sites() {
  std::vector<StudiedSite> sites;
  sites.reserve(std::size(embedded_sites));
  for (const auto& [name, text] : embedded_sites) {
    const std::string words(name);
    sites.push_back({words, scenario_from_yaml(std::string(text), words).scenario});
  }
  return sites;
}

SitesStudy study_sites(const SitesOptions& options) {
  SitesStudy study = begun(options);
  const std::vector<StudiedSite>& sites = study.options.sites;
  for (std::size_t site = 0; site < sites.size(); ++site) {
    const Ground ground(sites[site]);
    for (std::size_t i = 0; i < study.resolutions.size(); ++i) {
      study.resolutions[i].megabytes += ground.megabytes(i) / static_cast<double>(sites.size());
    }
    Rng rng(stream_seed(options.seed, site));
    for (int number = 0; number < options.starts; ++number) {
      const auto [start, goal] = ground.ends(number, rng);
      study.problems.push_back({site, start, goal});
      run_all(study, ground, ground.between(start, goal), rng());
    }
  }
  drop_unsolved(study);
  if (study.problems.empty()) throw InputError("sites", "no planner solves any of the problems");
  const std::vector<double> least = least_costs(study);
  std::vector<PairedComparison*> together;
  for (SiteSearch& search : study.searches) {
    for (SiteRuns& runs : search.runs) summarise(runs, least);
    compare(search);
    together.insert(together.end(), {&search.cost, &search.first});
  }
  for (SiteResolution& resolution : study.resolutions) {
    for (SiteRuns& runs : resolution.runs) summarise(runs, least);
  }
  evaluation::judge_together(together, confidence);
  return study;
}

StudyFiles files_of(const SitesStudy& study) {
  std::vector<TextFile> data = {{"sites_runs.csv", csv_of_runs(study)},
                                {"sites_tables.csv", csv_of_tables(study)}};
  std::string body = fmt::format(
      "set multiplot layout 2,4 title 'Problems with a path [%] by processor time [ms]: with the "
      "table "
      "of the site (solid), with the best other estimate (dashed)' font ',14'\n"
      "set logscale x\nset xrange [0.01:{}]\nset yrange [0:100]\nset key below samplen 1 font "
      "',9'\n",
      1e3 * study.options.time_limit);
  const double share = 100.0 / static_cast<double>(std::max(study.problems.size(), std::size_t{1}));
  for (std::size_t s = 0; s < study.searches.size(); ++s) {
    const SiteSearch& search = study.searches[s];
    body += fmt::format(
        "set title '{}'\nplot {}, {}, -1 notitle\n", search.name,
        curve(s, search.runs.size() - 1, share, "table of the site",
              fmt::format("linewidth 2.5 linecolor rgb '{}'", study_colour::blue)),
        curve(s, search.rival, share, search.runs[search.rival].planner,
              fmt::format("linewidth 2 dashtype (8,5) linecolor rgb '{}'", study_colour::orange)));
  }
  return study_files({"sites", 1600, 800}, std::move(data), body + "unset multiplot\n");
}

}  // namespace vandplan::studies
