// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a table of a site bring to searches that an estimate guides? How coarse may the table
// be, and does a network that learned it do as well?

#include <cstdint>
#include <string>
#include <vector>

#include "evaluation/statistics.h"
#include "studies/learned.h"
#include "studies/study_files.h"
#include "vandplan/problem.h"
#include "vandplan/site_table.h"

namespace vandplan::studies {

/// A site to drive on.
struct StudiedSite {
  std::string name;
  Scenario scenario;
};

struct SitesOptions {
  int starts = 4;           ///< starts on each site: that of the scenario, and random ones
  double time_limit = 0.1;  ///< processor time of each run [s]
  std::uint64_t seed = 1;
  int training = 50'000;                ///< steps of training of each network
  std::vector<StudiedSite> sites = {};  ///< sites; none: `usual_sites`
};

/// Start on a site, and the goal that is driven to.
struct SiteProblem {
  std::size_t site = 0;  ///< index of the site in the study
  Pose start, goal;
};

/// Runs of one planner, one for each problem.
struct SiteRuns {
  std::string planner;
  std::vector<double> costs = {};  ///< length of the path [m]; infinite without a path
  std::vector<double> first = {};  ///< time of the first path [s]; infinite without a path
  int solved = 0;
  double over_best = 0.0;     ///< median of the lengths over the least that any planner found
  double median_first = 0.0;  ///< median time of the first path [s]
};

/// One planner's runs against another's.
struct SiteComparison {
  std::string of = {}, against = {};        ///< planners
  int shorter = 0, longer = 0;              ///< problems in which the first ends shorter, or longer
  evaluation::PairedComparison cost = {};   ///< lengths of the first over those of the second
  evaluation::PairedComparison first = {};  ///< times of the first path, likewise
};

/// A search with each of its estimates. The last runs are guided by the table of the site. The
/// rival is the best of the others: it solves most, and of those that solve as many its paths are
/// shortest.
struct SiteSearch {
  std::string name;
  std::string asked = {};  ///< option that all runs and the table are asked for, as KEY=VALUE
  std::vector<SiteRuns> runs = {};
  std::size_t rival = 0;
  SiteComparison table = {};  ///< the table against the rival
  /// Runs that networks guide: one that learned the site, and one that is told the map and learned
  /// the other sites.
  std::vector<SiteRuns> learned = {};
  /// Each network against the table, exact lengths and the grid.
  std::vector<SiteComparison> networks = {};
};

/// Tables of one resolution, and what the searches do with them.
struct SiteResolution {
  int headings = 0;                 ///< headings of a full turn
  double cell = 0.0;                ///< side of a cell [turning radii]
  double megabytes = 0.0;           ///< size of a table to one goal, mean over the sites
  std::vector<SiteRuns> runs = {};  ///< runs of some searches with such tables
};

/// Costs by an estimate, against those of the table, means over the sites.
struct SiteEstimate {
  std::string name;
  double megabytes = 0.0;  ///< its numbers for one goal
  CostErrors errors = {};
};

struct SitesStudy {
  SitesOptions options;
  std::vector<SiteProblem> problems = {};
  std::vector<SiteSearch> searches = {};
  std::vector<SiteResolution> resolutions = {};  ///< the finest first: that of `searches`
  std::vector<SiteEstimate> estimates = {};
};

/// Sites of the repository: five of the thesis, and the depot of the examples.
[[nodiscard]] std::vector<StudiedSite> usual_sites();

/// Runs all planners from all starts, problem by problem, with equal seeds. Verdicts on tables hold
/// together with 95 % confidence, and so do those on networks. Problems that nobody solves are left
/// out. Throws InputError naming a site that has no table, or "sites" if nobody solves any problem.
[[nodiscard]] SitesStudy study_sites(const SitesOptions& options);

[[nodiscard]] StudyFiles files_of(const SitesStudy& study);

}  // namespace vandplan::studies
