// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/shards.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "evaluation/methods.h"
#include "evaluation/options_json.h"
#include "evaluation/stored_scenario.h"
#include "vandplan/random.h"

namespace vandplan::evaluation {
namespace {

using Json = nlohmann::ordered_json;

Json caps_json(const Campaign& campaign) {
  Json caps = Json::array();
  for (const RepeatCap& cap : campaign.caps)
    caps.push_back({cap.group, cap.repeats, cap.repeats_per_goal});
  return caps;
}

Json scenarios_json(const Campaign& campaign) {
  Json scenarios = Json::array();
  for (const auto& [scenario, file] : campaign.scenarios) {
    const std::uint64_t hash = base::hash_of(stored(scenario, file).yaml);
    scenarios.push_back(fmt::format("{} ({:016x})", scenario.scenario.name, hash));
  }
  return scenarios;
}

// Adds a planner's options for a scenario. Options that differ from those of an earlier scenario,
// because the vehicle differs, name the scenario.
void add_options(const Campaign& campaign, const Planner& planner, const Scenario& scenario,
                 Json& json) {
  for (const auto& [name, text] : option_values(options_of(campaign, planner, scenario.vehicle))) {
    const Json value = Json::parse(text);
    const std::string key = name + " of " + planner.name;
    if (!json.contains(key)) json[key] = value;
    if (json[key] != value) json[key + " in " + scenario.name] = value;
  }
}

}  // namespace

std::string text_of(const Shard& shard) { return fmt::format("{}/{}", shard.number, shard.of); }

bool is_repeatable(const Campaign& campaign) {
  return std::ranges::none_of(campaign.planners, [&](const Planner& planner) {
    return budget_of(campaign, planner).time_limit.has_value();
  });
}

Environment environment_of(const Campaign& campaign) {
  Environment environment = this_environment();
  if (!campaign.shard || !is_repeatable(campaign)) return environment;
  environment.processor.clear();
  environment.system.clear();
  environment.cores = 0;
  return environment;
}

bool ShardFilter::holds(const RunSpec& run) {
  if (!campaign_.shard) return true;
  const auto [number, of] = *campaign_.shard;
  const std::uint64_t key = stream_seed(stream_seed(hash_of_shared(run), run.goal), run.seed);
  return key % static_cast<std::uint64_t>(of) + 1 == static_cast<std::uint64_t>(number);
}

std::uint64_t ShardFilter::hash_of_shared(const RunSpec& run) {
  const auto [known, is_new] = known_.try_emplace(
      {run.scenario, run.planner, run.region, run.options.identity()}, Known{0, run.options});
  if (!is_new) return known->second.hash;
  std::uint64_t hash = base::hash_of(campaign_.scenarios[run.scenario].scenario.scenario.name);
  hash = base::hash_of(campaign_.planners[run.planner].name, hash);
  hash = base::hash_of(name_of(run.region), hash);
  return known->second.hash = base::hash_of(options_to_json(*run.options), hash);
}

StoredShard stored_shard(const Campaign& campaign, int runs) {
  Json json = {{"scenarios", scenarios_json(campaign)}, {"regions", Json::array()}};
  for (const Region region : campaign.regions) json["regions"].push_back(name_of(region));
  json["repeats"] = campaign.repeats;
  json["goal-repeats"] = campaign.repeats_per_goal;
  json["repeats of groups"] = caps_json(campaign);
  json["seed"] = campaign.seed;
  json["profile"] = campaign.profile;
  json["planners"] = Json::array();
  for (const Planner& planner : campaign.planners) json["planners"].push_back(planner.name);
  for (const Planner& planner : campaign.planners) {
    for (const auto& [scenario, file] : campaign.scenarios)
      add_options(campaign, planner, scenario.scenario, json);
  }
  return {*campaign.shard, runs, json.dump()};
}

std::string difference(const std::string& campaign, const std::string& other) {
  const Json first = Json::parse(campaign), second = Json::parse(other);
  for (const auto& [name, value] : first.items()) {
    const auto found = second.find(name);
    if (found == second.end() || *found != value) {
      return fmt::format("{}: {}, not {}", name, value.dump(),
                         found == second.end() ? "none" : found->dump());
    }
  }
  return first.size() == second.size() ? "" : "options: fewer";
}

}  // namespace vandplan::evaluation
