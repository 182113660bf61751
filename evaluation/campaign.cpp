// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "base/hash.h"
#include "evaluation/methods.h"
#include "evaluation/shards.h"
#include "vandplan/graphs.h"
#include "vandplan/input_error.h"
#include "vandplan/random.h"

namespace vandplan::evaluation {
namespace {

// Planners with equally many repeats, as indices into the campaign.
struct Lineup {
  int repeats = 0;
  int repeats_per_goal = 0;
  std::vector<std::size_t> planners;
};

// One turn: every planner of a lineup runs one problem with one seed, in every region.
struct Turn {
  std::size_t scenario = 0;
  std::size_t goal = 0;
  int repeat = 0;
  double when = 0.0;  // position of the turn in the campaign, in (0, 1)
  const std::vector<std::size_t>* planners = nullptr;
};

// Lineup of a planner, still without planners.
Lineup lineup_of(const Campaign& campaign, const Planner& planner) {
  Lineup lineup{campaign.repeats, campaign.repeats_per_goal, {}};
  for (const RepeatCap& cap : campaign.caps) {
    if (!is_in_group(planner, cap.group)) continue;
    lineup.repeats = std::min(lineup.repeats, cap.repeats);
    lineup.repeats_per_goal = std::min(lineup.repeats_per_goal, cap.repeats_per_goal);
  }
  return lineup;
}

std::vector<Lineup> lineups_of(const Campaign& campaign) {
  std::vector<Lineup> lineups;
  for (std::size_t i = 0; i < campaign.planners.size(); ++i) {
    const Lineup wanted = lineup_of(campaign, campaign.planners[i]);
    auto found = std::ranges::find_if(lineups, [&](const Lineup& lineup) {
      return lineup.repeats == wanted.repeats && lineup.repeats_per_goal == wanted.repeats_per_goal;
    });
    if (found == lineups.end()) found = lineups.insert(found, wanted);
    found->planners.push_back(i);
  }
  return lineups;
}

std::vector<Turn> turns_of(const Campaign& campaign, const std::vector<Lineup>& lineups) {
  std::vector<Turn> turns;
  for (const Lineup& lineup : lineups) {
    for (std::size_t s = 0; s < campaign.scenarios.size(); ++s) {
      const ScenarioFile& scenario = campaign.scenarios[s].scenario;
      const int repeats = scenario.is_row() ? lineup.repeats_per_goal : lineup.repeats;
      for (std::size_t goal = 0; goal < scenario.size(); ++goal) {
        for (int repeat = 0; repeat < repeats; ++repeat)
          turns.push_back({s, goal, repeat, (repeat + 0.5) / repeats, &lineup.planners});
      }
    }
  }
  std::ranges::stable_sort(turns, {}, &Turn::when);
  return turns;
}

void check_settings(const Campaign& campaign) {
  for (const Setting& setting : campaign.settings) {
    for (const char* const own : {"seed", "region", "profile"}) {
      if (setting.name == own)
        throw InputError(setting.name, "is set by the comparison itself, run by run");
    }
    const auto takes_it = [&](const Planner& planner) { return honours(planner, setting.name); };
    if (std::ranges::any_of(campaign.planners, takes_it)) continue;
    PlanOptions options;
    set_option(options, campaign.planners.front(), setting.name, setting.value);  // throws
  }
}

void check(const Campaign& campaign) {
  if (campaign.scenarios.empty()) throw InputError("scenarios", "none given");
  if (campaign.planners.empty()) throw InputError("planners", "none given");
  if (campaign.regions.empty()) throw InputError("region", "none given");
  if (campaign.shard &&
      (campaign.shard->number < 1 || campaign.shard->number > campaign.shard->of)) {
    throw InputError(
        "shard", fmt::format("is {}, expected I/N with I from 1 to N", text_of(*campaign.shard)));
  }
  if (campaign.repeats < 1) throw InputError("repeats", "must be at least 1");
  if (campaign.repeats_per_goal < 1) throw InputError("goal-repeats", "must be at least 1");
  for (const RepeatCap& cap : campaign.caps) {
    if (cap.repeats < 1) throw InputError("repeats", "must be at least 1 for " + cap.group);
    if (cap.repeats_per_goal < 1)
      throw InputError("goal-repeats", "must be at least 1 for " + cap.group);
  }
  for (const Planner& planner : campaign.planners) {
    if (std::ranges::count(campaign.planners, planner.name, &Planner::name) > 1)
      throw InputError("planners", "two of them have the name \"" + planner.name + "\"");
  }
  check_settings(campaign);
  const auto takes_table = [&](const Planner& planner) {
    return options_of(campaign, planner, {}).table != nullptr;
  };
  if (campaign.table && std::ranges::none_of(campaign.planners, takes_table)) {
    throw InputError("table", "no planner of these has estimate=table");
  }
}

std::vector<std::size_t> profiled_planners(const Campaign& campaign) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < campaign.planners.size(); ++i)
    if (honours(campaign.planners[i], "profile")) found.push_back(i);
  return found;
}

// One additional run on each scenario, in a row of goals to the middle goal. Measuring slows a run
// down, so profiled runs are kept apart from those whose time counts.
std::vector<Turn> profiling_turns_of(const Campaign& campaign,
                                     const std::vector<std::size_t>& planners) {
  std::vector<Turn> turns;
  for (std::size_t s = 0; s < campaign.scenarios.size(); ++s)
    turns.push_back({s, campaign.scenarios[s].scenario.size() / 2, 0, 1.0, &planners});
  return turns;
}

// Builds the list of runs from turns.
class RunList {
 public:
  explicit RunList(const Campaign& campaign) : campaign_(campaign), shard_(campaign) {}

  void add(const std::vector<Turn>& turns, bool profile) {
    options_.clear();
    for (const Turn& turn : turns) {
      const std::vector<std::size_t>& planners = *turn.planners;
      const std::size_t first = turn.scenario + turn.goal + static_cast<std::size_t>(turn.repeat);
      for (const Region region : campaign_.regions) {
        for (std::size_t i = 0; i < planners.size(); ++i)
          add(turn, region, planners[(first + i) % planners.size()], profile);
      }
    }
  }

  std::vector<RunSpec> take() { return std::move(runs_); }

 private:
  void add(const Turn& turn, Region region, std::size_t planner, bool profile) {
    const Scenario& scenario = campaign_.scenarios[turn.scenario].scenario.scenario;
    const auto [known, is_new] = options_.try_emplace({planner, turn.scenario, region});
    if (is_new) {
      PlanOptions options = options_of(campaign_, campaign_.planners[planner], scenario.vehicle);
      known->second = options_for(campaign_.planners[planner], std::move(options), region, profile);
    }
    const std::string& name = scenario.name;
    RunSpec run{turn.scenario, turn.goal,
                planner,       region,
                known->second, run_seed(campaign_.seed, name, turn.goal, turn.repeat)};
    if (shard_.holds(run)) runs_.push_back(std::move(run));
  }

  static SharedOptions options_for(const Planner& planner, PlanOptions options, Region region,
                                   bool profile) {
    if (takes_region(planner)) options.planner.set("region", std::string(name_of(region)));
    if (profile) {
      options.planner.set("profile", true);
      options.budget.processor_time = false;  // phases are measured by the wall clock
    }
    return options;
  }

  const Campaign& campaign_;
  ShardFilter shard_;
  // Options by planner, scenario and region.
  std::map<std::tuple<std::size_t, std::size_t, Region>, SharedOptions> options_;
  std::vector<RunSpec> runs_;
};

std::string counted(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// Lines such as " 40 = 2 planners x ...", and the total.
class Sum {
 public:
  void add(const std::vector<std::pair<std::size_t, std::string>>& factors,
           const std::string& why = "") {
    std::size_t product = 1;
    std::string text;
    for (const auto& [count, what] : factors) {
      product *= count;
      text += (text.empty() ? "" : " x ") + counted(count, what);
    }
    if (product == 0) return;
    total_ += product;
    lines_ += fmt::format("  {:5} = {}{}\n", product, text, why);
  }
  std::string text() const { return counted(total_, "run") + "\n" + lines_; }

 private:
  std::size_t total_ = 0;
  std::string lines_;
};

}  // namespace

std::vector<RunSpec> runs_of(const Campaign& campaign) {
  check(campaign);
  RunList runs(campaign);
  const std::vector<Lineup> lineups = lineups_of(campaign);
  runs.add(turns_of(campaign, lineups), false);
  std::vector<std::size_t> profiled;
  if (campaign.profile) profiled = profiled_planners(campaign);
  if (!profiled.empty()) runs.add(profiling_turns_of(campaign, profiled), true);
  return runs.take();
}

PlanOptions options_of(const Campaign& campaign, const Planner& planner, const Vehicle& vehicle) {
  PlanOptions options;
  set_option(options, planner, "style", "shortest");
  set_honoured(options, planner, campaign.settings);
  if (asks_for_estimate(planner, options, search::user_table)) options.table = campaign.table;
  options.budget.processor_time = options.budget.threads == 1;
  return complete(planner, options, vehicle);
}

BudgetOptions budget_of(const Campaign& campaign, const Planner& planner) {
  return options_of(campaign, planner, {}).budget;
}

std::string explain_runs(const Campaign& campaign) {
  check(campaign);
  std::size_t single = 0, goals = 0;
  for (const auto& [scenario, file] : campaign.scenarios)
    (scenario.is_row() ? goals : single) += scenario.size();
  const std::pair<std::size_t, std::string> regions = {campaign.regions.size(), "region"};
  Sum sum;
  for (const Lineup& lineup : lineups_of(campaign)) {
    const std::pair<std::size_t, std::string> planners = {lineup.planners.size(), "planner"};
    sum.add({planners,
             regions,
             {single, "scenario"},
             {static_cast<std::size_t>(lineup.repeats), "repeat"}});
    sum.add({planners,
             regions,
             {goals, "goal"},
             {static_cast<std::size_t>(lineup.repeats_per_goal), "repeat"}},
            ", in rows of goals");
  }
  if (campaign.profile) {
    sum.add({{profiled_planners(campaign).size(), "planner"},
             regions,
             {campaign.scenarios.size(), "scenario"}},
            ", once more to measure phases");
  }
  return sum.text();
}

std::uint64_t run_seed(std::uint64_t campaign_seed, const std::string& scenario, std::size_t goal,
                       int repeat) {
  std::uint64_t seed = stream_seed(campaign_seed, base::hash_of(scenario));
  seed = stream_seed(seed, goal);
  seed = stream_seed(seed, static_cast<std::uint64_t>(repeat));
  return seed >> 32;  // short enough to type
}

}  // namespace vandplan::evaluation
