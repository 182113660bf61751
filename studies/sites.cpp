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
#include "studies/site_ground.h"
#include "vandplan/files.h"
#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/random.h"

namespace vandplan::studies {
namespace {

using evaluation::PairedComparison;

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double confidence = 0.95;
constexpr std::size_t samples_of_site = 50'000;  // costs that a network learns

/// Options of the questions that are asked again under other rules of driving.
constexpr const char* forward = "gears=forward";
constexpr const char* driver = "style=driver";

/// A search and its planners. The last one is guided by the table.
struct Entry {
  const char* name;
  std::vector<const char*> planners;
  const char* asked = "";  ///< option that is asked for
};

/// The default planner is no search that takes an estimate; it begins with the table's way.
constexpr const char* with_table = "anytime, with the table";

/// A network that takes the place of the table: one that learned the site, and one that is told its
/// map and learned the other sites.
struct Learner {
  Told told;
  const char* planner;    ///< what stands behind the planner's name
  const char* estimate;   ///< name of its costs
  const char* untrained;  ///< name of the lengths that it is told
};
constexpr std::array learners = {
    Learner{Told::place, ", network", "network of the site", "exact length"},
    Learner{Told::map, ", network of others", "network of the other sites",
            "exact length or any-angle way"}};
constexpr std::size_t networks = learners.size();

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      {"hybrid A*",
       {"hybrid-a-star:reeds-shepp", "hybrid-a-star:hlut-4", "hybrid-a-star:grid",
        "hybrid-a-star:any-angle", "hybrid-a-star:choi", "hybrid-a-star:max-reeds-shepp-any-angle",
        "hybrid-a-star:site"}},
      {"lattice A*",
       {"lattice-a-star:lattice-table", "lattice-a-star:grid",
        "lattice-a-star:max-lattice-table-any-angle", "lattice-a-star:choi",
        "lattice-a-star:site"}},
      {"hRRT",
       {"hrrt:euclid", "hrrt:reeds-shepp", "hrrt:grid", "hrrt:max-reeds-shepp-any-angle",
        "hrrt:choi", "hrrt:site"}},
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
      {"the default planner", {"anytime", with_table}},
      {"hybrid A*, forward only",
       {"hybrid-a-star:grid", "hybrid-a-star:any-angle", "hybrid-a-star:max-reeds-shepp-any-angle",
        "hybrid-a-star:site"},
       forward},
      {"BSC, goal tried, forward only",
       {"rrt-bsc-euc-goal", "rrt-bsc-rs-goal", "rrt-bsc-site-goal"},
       forward},
      {"OPT, goal tried, forward only",
       {"rrt-opt-euc-goal", "rrt-opt-rs-goal", "rrt-opt-site-goal"},
       forward},
      {"the default planner, forward only", {"anytime", with_table}, forward},
      {"hybrid A*, prices of a driver",
       {"hybrid-a-star:grid", "hybrid-a-star:any-angle", "hybrid-a-star:max-reeds-shepp-any-angle",
        "hybrid-a-star:site"},
       driver},
      {"the default planner, prices of a driver", {"anytime", with_table}, driver}};
  return all;
}

/// Searches that coarser tables are tried with: numbers in `entries`.
constexpr std::array<std::size_t, 3> coarse_searches = {0, 2, 4};

/// Runs a planner on a problem and adds what came out.
void run(const Problem& problem, const SiteTable& table, const std::string& asked,
         const PlanOptions& limits, SiteRuns& runs) {
  const std::string name = runs.planner.substr(0, runs.planner.find(','));
  const Planner planner = planner_named(name);
  PlanOptions options = limits;
  ask(options, planner, asked);
  if (honours(planner, "region")) set_option(options, planner, "region", "scene");
  if (runs.planner == with_table || asks_for_estimate(planner, options, "site")) {
    options.site = std::make_shared<const SiteTable>(table);
  }
  const PlanResult result = plan(problem, planner, options);
  const bool is_solved = result.path && !result.anytime.empty();
  runs.costs.push_back(is_solved ? result.cost : never);
  runs.first.push_back(is_solved ? result.anytime.front().time : never);
  if (is_solved) ++runs.solved;
}

/// Calls `use(runs, asked)` with all runs.
template <class Study, class Use>
void for_all_runs(Study& study, Use use) {
  for (auto& search : study.searches) {
    for (auto& runs : search.runs) use(runs, search.asked);
    for (auto& runs : search.learned) use(runs, search.asked);
  }
  for (auto& resolution : study.resolutions) {
    for (auto& runs : resolution.runs) use(runs, std::string());
  }
}

/// Least cost of each problem, by whichever planner that is asked for an option.
std::vector<double> least_costs(const SitesStudy& study, const std::string& asked) {
  std::vector<double> least(study.problems.size(), never);
  for_all_runs(study, [&](const SiteRuns& runs, const std::string& option) {
    if (option != asked) return;
    for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], runs.costs[i]);
  });
  return least;
}

void summarise(SiteRuns& runs, const std::vector<double>& least) {
  std::vector<double> over;
  over.reserve(least.size());
  for (std::size_t i = 0; i < least.size(); ++i) {
    if (least[i] == never) continue;
    over.push_back(runs.costs[i] == least[i] ? 1.0 : runs.costs[i] / least[i]);
  }
  if (over.empty()) over.push_back(never);
  runs.over_best = evaluation::median_of(over, confidence).median;
  runs.median_first = evaluation::median_of(runs.first, confidence).median;
}

SiteComparison compared(const SiteRuns& of, const SiteRuns& against) {
  SiteComparison comparison{.of = of.planner, .against = against.planner};
  for (std::size_t i = 0; i < of.costs.size(); ++i) {
    comparison.shorter += of.costs[i] < against.costs[i] ? 1 : 0;
    comparison.longer += of.costs[i] > against.costs[i] ? 1 : 0;
  }
  comparison.cost = evaluation::compare_pairs(of.costs, against.costs, confidence);
  comparison.first = evaluation::compare_pairs(of.first, against.first, confidence);
  return comparison;
}

/// Whether a planner's estimate is the exact length on open ground, or the way on a grid.
bool is_plain(std::string_view planner) {
  return std::ranges::any_of(
      std::array<std::string_view, 5>{":reeds-shepp", ":lattice-table", "-rs", "-rs-goal", ":grid"},
      [&](std::string_view estimate) { return planner.ends_with(estimate); });
}

void compare(SiteSearch& search) {
  const auto is_better = [](const SiteRuns& a, const SiteRuns& b) {
    return a.solved != b.solved ? a.solved > b.solved : a.over_best < b.over_best;
  };
  const auto rival = std::min_element(search.runs.begin(), search.runs.end() - 1, is_better);
  search.rival = static_cast<std::size_t>(rival - search.runs.begin());
  search.table = compared(search.runs.back(), *rival);
  for (const SiteRuns& network : search.learned) {
    search.networks.push_back(compared(network, search.runs.back()));
    for (const SiteRuns& runs : search.runs) {
      if (is_plain(runs.planner)) search.networks.push_back(compared(network, runs));
    }
  }
}

/// Verdicts on tables, and those on networks, hold together.
void judge(SitesStudy& study) {
  std::vector<PairedComparison*> tables, learned;
  for (SiteSearch& search : study.searches) {
    tables.insert(tables.end(), {&search.table.cost, &search.table.first});
    for (SiteComparison& network : search.networks) {
      learned.insert(learned.end(), {&network.cost, &network.first});
    }
  }
  evaluation::judge_together(tables, confidence);
  evaluation::judge_together(learned, confidence);
}

/// Problems that no planner solves say nothing, and are left out.
void drop_unsolved(SitesStudy& study) {
  const std::vector<double> least = least_costs(study, "");
  const auto drop_from = [&](auto& values) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < least.size(); ++i) {
      if (least[i] < never) values[kept++] = values[i];
    }
    values.resize(kept);
  };
  for_all_runs(study, [&](SiteRuns& runs, const std::string&) {
    drop_from(runs.costs);
    drop_from(runs.first);
    runs.solved = static_cast<int>(
        std::ranges::count_if(runs.costs, [](double cost) { return cost < never; }));
  });
  drop_from(study.problems);
}

/// A site with what networks know of it.
struct Site {
  SiteGround ground;
  std::array<CostSamples, networks> samples = {};
  std::array<std::shared_ptr<const Network>, networks> learned = {};  ///< null: nothing to learn
};

/// The table as a network of a site knows it, for one run.
SiteTable learned_table(const Site& site, std::size_t learner,
                        std::shared_ptr<const Network> network) {
  return with_learned_costs(site.ground.table(0), site.ground.problem(), learners[learner].told,
                            std::move(network));
}

void run_all(SitesStudy& study, const Site& site, const Problem& problem, std::uint64_t seed) {
  PlanOptions limits;
  limits.budget.time_limit = study.options.time_limit;
  limits.budget.processor_time = true;
  limits.budget.seed = seed;
  for (SiteSearch& search : study.searches) {
    const SiteTable& table = site.ground.table(search.asked);
    for (SiteRuns& runs : search.runs) run(problem, table, search.asked, limits, runs);
    for (std::size_t i = 0; i < search.learned.size(); ++i) {
      run(problem, learned_table(site, i, site.learned[i]), search.asked, limits,
          search.learned[i]);
    }
  }
  for (std::size_t i = 0; i < resolutions.size(); ++i) {
    for (SiteRuns& runs : study.resolutions[i].runs) {
      run(problem, site.ground.table(i), "", limits, runs);
    }
  }
}

SitesStudy begun(const SitesOptions& options) {
  SitesStudy study{.options = options};
  if (study.options.sites.empty()) study.options.sites = usual_sites();
  const std::size_t taken = study.options.sites.size() > 1 ? networks : 1;
  for (const auto& [name, planners, asked] : entries()) {
    SiteSearch search{.name = name, .asked = asked};
    for (const char* const planner : planners) search.runs.push_back({.planner = planner});
    const bool is_learned = search.asked.empty() && planners.back() != with_table;
    for (std::size_t i = 0; is_learned && i < taken; ++i) {
      search.learned.push_back({.planner = std::string(planners.back()) + learners[i].planner});
    }
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

/// Makes tables of the sites, and trains networks on them.
std::vector<Site> sites_of(const SitesOptions& options) {
  std::vector<Site> sites;
  sites.reserve(options.sites.size());
  for (const auto& [name, scenario] : options.sites) {
    Site& site = sites.emplace_back(Site{SiteGround(name, scenario, {forward, driver})});
    for (std::size_t i = 0; i < networks; ++i) {
      site.samples[i] = cost_samples(site.ground.table(0), site.ground.problem(), learners[i].told,
                                     samples_of_site, options.seed);
    }
  }
  for (Site& site : sites) {
    CostSamples others;
    for (const Site& other : sites) {
      if (&other == &site) continue;
      const auto& [inputs, targets] = other.samples[1];
      others.inputs.insert(others.inputs.end(), inputs.begin(), inputs.end());
      others.targets.insert(others.targets.end(), targets.begin(), targets.end());
    }
    site.learned[0] = trained_on(site.samples[0], options.training, options.seed);
    if (others.targets.empty()) continue;
    site.learned[1] = trained_on(others, options.training, options.seed);
  }
  return sites;
}

/// Adds an estimate's errors on a site.
void add_errors(const SiteTable& costs, const Site& site, double megabytes, double share,
                std::uint64_t seed, SiteEstimate& estimate) {
  const CostErrors errors = cost_errors(costs, site.ground.table(0), seed);
  estimate.megabytes += share * megabytes;
  estimate.errors.mean += share * errors.mean;
  estimate.errors.percent_95 += share * errors.percent_95;
  estimate.errors.relative += share * errors.relative;
  estimate.errors.nanoseconds += share * errors.nanoseconds;
}

/// Errors of coarser tables, of networks, and of the lengths that networks are told.
std::vector<SiteEstimate> estimates_of(const std::vector<Site>& sites, std::uint64_t seed) {
  const double share = 1.0 / static_cast<double>(sites.size());
  std::vector<SiteEstimate> all;
  for (std::size_t i = 0; i < resolutions.size(); ++i) {
    const auto& [headings, cell] = resolutions[i];
    all.push_back({fmt::format("table of {} headings, cells of {} radii", headings, cell)});
    for (const Site& site : sites) {
      add_errors(site.ground.table(i), site, site.ground.megabytes(i), share, seed, all.back());
    }
  }
  for (std::size_t i = 0; i < networks; ++i) {
    SiteEstimate trained{learners[i].estimate}, untrained{learners[i].untrained};
    for (const Site& site : sites) {
      add_errors(learned_table(site, i, nullptr), site, 0.0, share, seed, untrained);
      const std::shared_ptr<const Network>& network = site.learned[i];
      if (!network) continue;
      const double bytes = static_cast<double>(network->weights().size() * sizeof(float));
      add_errors(learned_table(site, i, network), site, 1e-6 * bytes, share, seed, trained);
    }
    if (sites.front().learned[i]) all.push_back(std::move(trained));
    all.push_back(std::move(untrained));
  }
  return all;
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
  const std::vector<Site> sites = sites_of(study.options);
  for (std::size_t number = 0; number < sites.size(); ++number) {
    const Site& site = sites[number];
    for (std::size_t i = 0; i < study.resolutions.size(); ++i) {
      study.resolutions[i].megabytes +=
          site.ground.megabytes(i) / static_cast<double>(sites.size());
    }
    Rng rng(stream_seed(options.seed, number));
    for (int i = 0; i < options.starts; ++i) {
      const auto [start, goal] = site.ground.ends(i, rng);
      study.problems.push_back({number, start, goal});
      run_all(study, site, with_poses(site.ground.problem(), start, goal), rng());
    }
  }
  study.estimates = estimates_of(sites, options.seed + 1);
  drop_unsolved(study);
  if (study.problems.empty()) throw InputError("sites", "no planner solves any of the problems");
  for (const char* const asked : {"", forward, driver}) {
    const std::vector<double> least = least_costs(study, asked);
    for_all_runs(study, [&](SiteRuns& runs, const std::string& option) {
      if (option == asked) summarise(runs, least);
    });
  }
  for (SiteSearch& search : study.searches) compare(search);
  judge(study);
  return study;
}

}  // namespace vandplan::studies
