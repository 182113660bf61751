// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/methods.h"

#include <algorithm>
#include <array>
#include <set>

#include "vandplan/evaluation.h"
#include "vandplan/graphs.h"

namespace vandplan::evaluation {
namespace {

constexpr std::string_view euclid = "euclid";
constexpr std::array<std::string_view, 4> tables = {"hlut-1", "hlut-2", "hlut-3", "hlut-4"};
// Group of the planners of the literature that the thesis builds on; each is run with every
// estimate.
constexpr std::string_view family_group = "family";
// Combined estimates that are run beside every single one.
constexpr std::array<std::string_view, 2> combined = {"max-hlut-4-grid", "max-hlut-4-any-angle"};

const Planner* named(std::string_view name, std::span<const Planner> planners) {
  const auto found = std::ranges::find(planners, name, &Planner::name);
  return found == planners.end() ? nullptr : &*found;
}

// Variants of a search with each estimate that needs no other input; empty if it takes no estimate.
std::vector<Planner> with_each_estimate(const Planner& planner) {
  const auto option = std::ranges::find(planner.options, "estimate", &OptionInfo::name);
  if (option == planner.options.end()) return {};
  std::vector<std::string> estimates = option->words;
  estimates.insert(estimates.end(), combined.begin(), combined.end());
  std::vector<Planner> found;
  for (const std::string& estimate : estimates) {
    const std::optional<Planner> guided = find_planner(planner.name + ":" + estimate);
    const auto asks_for = [&](std::string_view name) {
      return asks_for_estimate(*guided, {}, name);
    };
    if (guided && !asks_for(search::user_table) && !asks_for(search::site_estimate)) {
      found.push_back(*guided);
    }
  }
  return found;
}

}  // namespace

std::optional<int> table_number(const PlannerProperties& properties) noexcept {
  const auto found = std::ranges::find(tables, properties.estimate);
  if (found == tables.end()) return std::nullopt;
  return static_cast<int>(found - tables.begin()) + 1;
}

const Planner* euclid_twin(const Planner& planner, std::span<const Planner> planners) {
  const PlannerProperties& own = planner.properties;
  if (own.estimate.empty() || own.estimate == euclid) return nullptr;
  const auto found = std::ranges::find_if(planners, [&](const Planner& other) {
    const PlannerProperties& its = other.properties;
    return its.estimate == euclid && its.family == own.family && its.strategy == own.strategy &&
           its.tries_goal == own.tries_goal;
  });
  return found == planners.end() ? nullptr : &*found;
}

bool is_in_group(const Planner& planner, std::string_view group) {
  return std::ranges::find(planner.properties.groups, group) != planner.properties.groups.end();
}

bool takes_region(const Planner& planner) {
  const auto option = std::ranges::find(planner.options, "region", &OptionInfo::name);
  if (option == planner.options.end()) return false;
  return std::ranges::all_of(std::array{Region::bounds, Region::scene}, [&](Region region) {
    return std::ranges::find(option->words, name_of(region)) != option->words.end();
  });
}

std::vector<Planner> planners_of(const std::vector<RunRecord>& runs,
                                 std::span<const Planner> known) {
  std::set<std::string> names;
  for (const RunRecord& run : runs) names.insert(run.planner);
  std::vector<Planner> found;
  const auto take = [&](const Planner& planner) {
    if (names.erase(planner.name) > 0) found.push_back(planner);
  };
  for (const Planner& planner : planners()) {
    const Planner* const own = named(planner.name, known);
    take(own == nullptr ? planner : *own);
  }
  for (const Planner& planner : known) take(planner);
  for (const std::string& name : names) {
    found.push_back(find_planner(name).value_or(Planner{.name = name, .summary = ""}));
  }
  return found;
}

std::vector<Planner> planners_called(const std::string& word) {
  std::vector<Planner> found;
  for (const Planner& planner : planners()) {
    if (word != "all" && !is_in_group(planner, word)) continue;
    const std::vector<Planner> guided = with_each_estimate(planner);
    if (word == family_group && !guided.empty()) {
      found.insert(found.end(), guided.begin(), guided.end());
    } else {
      found.push_back(planner);
    }
  }
  if (found.empty()) found = {planner_named(word)};
  return found;
}

const char* name_of(Region region) noexcept {
  return region == Region::bounds ? "bounds" : "scene";
}

std::string upper(std::string name) {
  for (char& letter : name)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  return name;
}

}  // namespace vandplan::evaluation
