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
// Every planner runs on every problem with the same seeds, the judge looks at every path, and every
// run is kept. How it is done: docs/evaluation.md.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/planner.h"
#include "vandplan/scenario_file.h"

namespace vandplan::evaluation {

/// A scenario that takes part, with one goal or a row of goals.
struct CampaignScenario {
  ScenarioFile scenario;
  std::string file;  ///< where it was read from: reports and commands name it
};

using vandplan::Setting;

/// A limit on the repeats of the planners of one group (`PlannerProperties::groups`).
struct RepeatCap {
  std::string group;
  int repeats = 1;           ///< at most so many of every scenario with one goal; >= 1
  int repeats_per_goal = 1;  ///< at most so many of every goal in a row of goals; >= 1
};

/// One of the parts that a campaign is split into, by a hash of what each run is: who has which run
/// does not depend on the machine, and shard after shard gives all of them.
struct Shard {
  int number = 1;  ///< 1 to `of`
  int of = 1;
  bool operator==(const Shard&) const = default;
};

/// What to compare.
struct Campaign {
  std::vector<CampaignScenario> scenarios = {};
  std::vector<Planner> planners = {};  ///< of the library or your own; names differ
  /// Where samples are drawn. A planner without an option "region" runs in each of them alike.
  std::vector<Region> regions = {Region::bounds, Region::scene};
  int repeats = 25;                  ///< of every scenario with one goal; >= 1
  int repeats_per_goal = 1;          ///< of every goal in a row of goals; >= 1
  std::vector<RepeatCap> caps = {};  ///< fewer repeats for some planners
  std::uint64_t seed = 1;            ///< every run's seed is derived from it
  /// One run more of each kind that measures where the time goes, for planners that have an option
  /// "profile".
  bool profile = false;
  /// Options of those planners that honour them; at least one planner must. Not "seed", "region"
  /// and "profile", which the campaign sets itself.
  std::vector<Setting> settings = {};
  /// What planners whose estimate is "table" look lengths up in; at least one must if it is there.
  std::shared_ptr<const HeuristicTable> table = {};
  /// Only this part of the runs; none: all of them.
  std::optional<Shard> shard = {};
};

/// How far a campaign is.
struct Progress {
  int total = 0;         ///< runs of the campaign
  int kept = 0;          ///< of these, found in the store
  int done = 0;          ///< run now
  double elapsed = 0.0;  ///< since the first run began [s]

  /// Expected time to the end [s].
  [[nodiscard]] double left() const noexcept;
};

/// How to carry out a campaign.
struct RunnerOptions {
  int jobs = 1;                             ///< runs at once, each on one thread; >= 1
  const std::atomic<bool>* stop = nullptr;  ///< ends the campaign; runs in flight are dropped
  /// Called after every run and now and then, on the thread of the caller; or none.
  std::function<void(const Progress&)> report = {};
};

/// What a campaign has shown, and the files that tell of it.
struct Comparison {
  int missing = 0;       ///< runs that were not done, because the campaign was stopped
  std::string headline;  ///< the answer and tables of all planners and scenarios, as Markdown
  std::string json;      ///< the figures of the headline as a JSON object
  std::string store;     ///< file with every run (SQLite)
  std::string page;      ///< file: one page for a browser with everything in it
  std::string text;      ///< file: everything as Markdown
  std::string gallery;   ///< file: a picture (PNG) of the best path in every scenario
};

/// The planners of the library that a word means: a name; a group ("thesis": its ten methods as
/// printed; "thesis-goal": the ten with the goal tried from every node); or "all". Throws
/// InputError for another word.
[[nodiscard]] std::vector<Planner> planners_called(const std::string& word);

/// How many runs a campaign has, and why so many: a line for the sum and one for each term. Throws
/// InputError when something in the campaign is out of range.
[[nodiscard]] std::string explain_runs(const Campaign& campaign);

/// Runs what the store in a folder does not hold yet of a campaign, and writes the reports beside
/// it; the folder is made if it is not there. A run whose path the judge rejects is kept as
/// `rejected` with its reason and counts as unsolved. Throws InputError when the campaign is no
/// good, when more jobs than cores would compete for a time budget, or when a file cannot be
/// written; and what a planner throws.
[[nodiscard]] Comparison compare(const Campaign& campaign, const std::string& folder,
                                 const RunnerOptions& options = {});

/// Runs what the store in a folder does not hold yet of the campaign's shard; no report. Throws
/// InputError as `compare` does, and when the store holds something else than that shard.
[[nodiscard]] Progress run_shard(const Campaign& campaign, const std::string& folder,
                                 const RunnerOptions& options = {});

/// Joins the stores of all shards of a campaign (files, or the folders they lie in) into one new
/// store, and writes the reports beside it. Where no run was limited by time, store and report are
/// the same, byte for byte, for every number of shards: what depends on the machine, times among
/// it, stays behind in the shards' stores. Throws InputError naming the store when a shard is
/// missing, incomplete or there twice, is of another campaign, program or kind of machine, or when
/// the folder holds a store already.
[[nodiscard]] Comparison merge_shards(const std::vector<std::string>& stores,
                                      const std::string& folder);

/// Whether a store file, or the one in a folder, holds a shard. Throws InputError when it is no
/// store.
[[nodiscard]] bool is_shard(const std::string& store);

}  // namespace vandplan::evaluation
