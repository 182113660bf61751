// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which planner is best at what?
//
//   evaluation::Campaign campaign{.planners = {mine, planner_named("anytime")}, .repeats = 10};
//   campaign.scenarios.push_back({read_scenario_file("yard.yaml"), "yard.yaml"});
//   campaign.settings.push_back({"time_limit", "0.1"});
//   std::cout << evaluation::compare(campaign, "out", {.jobs = 2}).headline;
//
// Every planner runs on every problem with the same seeds, the judge checks every path, and every
// run is kept. How it is done: docs/evaluation.md.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "vandplan/files.h"
#include "vandplan/planner.h"

namespace vandplan::evaluation {

/// A scenario of a campaign, with one goal or a row of goals.
struct CampaignScenario {
  ScenarioFile scenario;
  std::string file;  ///< file of the scenario, which reports and commands name
};

using vandplan::Setting;

/// A limit on the repeats of the planners of one group (`PlannerProperties::groups`).
struct RepeatCap {
  std::string group;         ///< name of the group
  int repeats = 1;           ///< largest number for every scenario with one goal; >= 1
  int repeats_per_goal = 1;  ///< largest number for every goal in a row of goals; >= 1
};

/// One of the parts into which a campaign is split, by a hash of what each run is. The split does
/// not depend on the machine. All shards together have every run once.
struct Shard {
  int number = 1;  ///< number of the shard; 1 to `of`
  int of = 1;      ///< number of shards
  bool operator==(const Shard&) const = default;
};

/// A comparison of planners: scenarios, planners, options and repeats.
struct Campaign {
  std::vector<CampaignScenario> scenarios = {};
  std::vector<Planner> planners = {};  ///< planners of the library or your own; their names differ
  /// Regions where samples are drawn. A planner without an option "region" runs alike in each of
  /// them.
  std::vector<Region> regions = {Region::bounds, Region::scene};
  int repeats = 25;                  ///< repeats of every scenario with one goal; >= 1
  int repeats_per_goal = 1;          ///< repeats of every goal in a row of goals; >= 1
  std::vector<RepeatCap> caps = {};  ///< groups of planners with fewer repeats
  std::uint64_t seed = 1;            ///< seed from which the seed of every run is derived
  /// Whether one more run of each kind measures where the time goes, for planners that have an
  /// option "profile".
  bool profile = false;
  /// Options for those planners that honour them; at least one planner must. "seed", "region" and
  /// "profile" are not allowed: the campaign sets them itself.
  std::vector<Setting> settings = {};
  /// Table of lengths for planners whose estimate is "table". If it is there, at least one planner
  /// must use it.
  std::shared_ptr<const HeuristicTable> table = {};
  /// The shard of the campaign to run. None: all runs.
  std::optional<Shard> shard = {};
};

/// Progress of a campaign.
struct Progress {
  int total = 0;         ///< number of runs of the campaign
  int kept = 0;          ///< number of runs that were found in the store
  int done = 0;          ///< number of runs that were done now
  double elapsed = 0.0;  ///< time since the first run began [s]

  /// Expected time to the end [s]; 0 before the first run has ended.
  [[nodiscard]] double left() const noexcept;
};

/// Options for carrying out a campaign.
struct RunnerOptions {
  int jobs = 1;  ///< runs at the same time, each on one thread; >= 1
  /// Ends the campaign when asked to stop; runs in flight are dropped.
  std::stop_token stop = {};
  /// Function that is called after every run and now and then, on the thread of the caller; or
  /// none.
  std::function<void(const Progress&)> report = {};
};

/// Result of a campaign, and the files of its report.
struct Comparison {
  int missing = 0;  ///< number of runs that are missing because the campaign was stopped
  /// Answer, with tables of all planners and scenarios, as Markdown.
  std::string headline;
  std::string json;     ///< figures of the headline as a JSON object
  std::string store;    ///< file with every run (SQLite)
  std::string page;     ///< file of one page for a browser with everything in it
  std::string text;     ///< file with everything as Markdown
  std::string gallery;  ///< file of a picture (PNG) with the best path in every scenario
};

/// The planners of the library that a word means. Throws InputError naming "planner" for another
/// word.
///
/// - The name of a planner.
/// - A group. "thesis": the ten methods of the thesis as printed. "thesis-goal": these ten with the
///   goal tried from every node.
/// - "all".
[[nodiscard]] std::vector<Planner> planners_called(const std::string& word);

/// The number of runs of a campaign and its reason: one line for the sum and one for each term.
/// Throws InputError when something in the campaign is out of range.
[[nodiscard]] std::string explain_runs(const Campaign& campaign);

/// Does the runs of a campaign that the store in a folder does not hold yet, and writes the reports
/// beside the store. The folder is made if it does not exist. A run whose path the judge rejects is
/// kept as `rejected` with its reason, and counts as unsolved.
///
/// Throws InputError when the campaign is not valid, when more jobs than cores would compete for a
/// time budget, or when a file cannot be written. Also throws what a planner throws.
[[nodiscard]] Comparison compare(const Campaign& campaign, const std::string& folder,
                                 const RunnerOptions& options = {});

/// Does the runs of the campaign's shard that the store in a folder does not hold yet, without a
/// report. Throws InputError as `compare` does, and when the store holds something other than that
/// shard.
[[nodiscard]] Progress run_shard(const Campaign& campaign, const std::string& folder,
                                 const RunnerOptions& options = {});

/// Joins the stores of all shards of a campaign into one new store in `folder`, and writes the
/// reports beside it. `stores` are files, or the folders they lie in.
///
/// If no run was limited by time, store and report are equal, byte for byte, for every number of
/// shards. What depends on the machine, such as times, stays behind in the shards' stores.
///
/// Throws InputError naming the store when a shard is missing, incomplete or there twice, or
/// belongs to another campaign, program or kind of machine. Also throws when the folder holds a
/// store already.
[[nodiscard]] Comparison merge_shards(const std::vector<std::string>& stores,
                                      const std::string& folder);

/// Whether a store file, or the one in a folder, holds a shard. Throws InputError when it is no
/// store.
[[nodiscard]] bool is_shard(const std::string& store);

}  // namespace vandplan::evaluation
