// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "evaluation/methods.h"
#include "evaluation/pooled.h"
#include "evaluation/reasons.h"

namespace vandplan::evaluation {
namespace {

using Verdict = PairedComparison::Verdict;
using Measure = PairedComparison TwinComparison::*;

std::vector<Pooled> pooled_tables(const Summary& summary, const Circumstances& where) {
  std::vector<Pooled> found = pooled(summary, where.region);
  std::erase_if(found, [&](const Pooled& planner) {
    return !is_table_under(planner.properties, where.setting);
  });
  return found;
}

// A comparison with its scenario.
struct Compared {
  const TwinComparison* twins;
  std::size_t scenario;
  PairedComparison result;
};

std::vector<Compared> table_comparisons(const Summary& summary, const Circumstances& where,
                                        Measure measure) {
  std::vector<Compared> found;
  for (const ScenarioSummary& scenario : summary.scenarios) {
    if (scenario.region != where.region) continue;
    for (const TwinComparison& twins : scenario.twins) {
      if (is_table_under(twins.properties, where.setting))
        found.push_back({&twins, scenario.scenario, twins.*measure});
    }
  }
  return found;
}

// Largest difference of one kind beyond chance.
std::optional<Compared> extreme(const std::vector<Compared>& comparisons, Verdict kind) {
  std::optional<Compared> best;
  for (const Compared& comparison : comparisons) {
    if (comparison.result.verdict != kind) continue;
    const bool smaller = !best || comparison.result.ratio < best->result.ratio;
    const bool larger = !best || comparison.result.ratio > best->result.ratio;
    if (kind == Verdict::smaller ? smaller : larger) best = comparison;
  }
  return best;
}

std::string describe(const std::optional<Compared>& comparison,
                     const std::vector<ScenarioFile>& scenarios) {
  if (!comparison) return "nothing beyond chance";
  const auto& [low, high] = comparison->result.interval;
  const std::string change = change_text(comparison->result.ratio);
  const bool is_sure = change_text(low) == change && change_text(high) == change;
  const std::string between =
      is_sure ? "" : fmt::format(" ({} to {})", change_text(low), change_text(high));
  return fmt::format("{}{} by {} in {}", change, between, comparison->twins->planner,
                     scenarios[comparison->scenario].scenario.name);
}

Finding better_in_six_of_nine(const Summary& summary, const Circumstances& where, int scenarios) {
  Tally best;
  for (const Tally& found : tally(summary, where.region, &TwinComparison::cost)) {
    if (!is_table_under(found.properties, where.setting)) continue;
    if (best.planner.empty() ||
        std::pair(found.better, -found.worse) > std::pair(best.better, -best.worse))
      best = found;
  }
  std::string found =
      best.better == 0
          ? fmt::format("In none of {} scenarios, by any table", scenarios)
          : fmt::format("At most in {} of {}, by {}; worse in {}, no difference in {}", best.better,
                        scenarios, best.planner, best.worse, best.no_difference);
  if (best.nothing_searched > 0)
    found += fmt::format(", nothing searched in {}", best.nothing_searched);
  for (const Verdict kind : {Verdict::smaller, Verdict::larger}) {
    std::string list;
    for (const Pooled& planner : pooled_tables(summary, where)) {
      if (planner.verdict == kind) {
        list += fmt::format("{}{} ({:.0f} % of the pairs better, {:.0f} % worse)",
                            list.empty() ? "" : ", ", planner.planner,
                            100.0 * planner.cheaper / planner.pairs,
                            100.0 * planner.dearer / planner.pairs);
      }
    }
    if (!list.empty()) {
      found += fmt::format(". All scenarios together {} beyond chance: {}",
                           kind == Verdict::smaller ? "better" : "worse", list);
    }
  }
  return {where, "better paths in at least six of nine scenarios", 9 * best.better >= 6 * scenarios,
          found};
}

Finding up_to(const Summary& summary, const Circumstances& where,
              const std::vector<ScenarioFile>& scenarios, double share, const std::string& what,
              std::initializer_list<std::pair<Measure, const char*>> measures) {
  Finding finding{where, fmt::format("up to {:.0f} % {}", 100.0 * share, what), false, ""};
  for (const auto& [measure, name] : measures) {
    const std::vector<Compared> comparisons = table_comparisons(summary, where, measure);
    const std::optional<Compared> best = extreme(comparisons, Verdict::smaller);
    const std::optional<Compared> worst = extreme(comparisons, Verdict::larger);
    finding.holds = finding.holds || (best && best->result.ratio <= 1.0 - share);
    finding.found += fmt::format("{}{}: at best {}; at worst {}", finding.found.empty() ? "" : ". ",
                                 name, describe(best, scenarios), describe(worst, scenarios));
  }
  return finding;
}

// Planners of a kind that have the least median cost at the end most often, and in how many
// scenarios.
struct Winner {
  std::string names;
  int scenarios = 0;
};

template <class Kind>
Winner winner(const Summary& summary, Region region, Kind is_of_kind) {
  std::vector<std::pair<std::string, int>> wins;
  for (const ScenarioSummary& scenario : summary.scenarios) {
    if (scenario.region != region) continue;
    double least = std::numeric_limits<double>::infinity();
    for (const MethodSummary& method : scenario.methods)
      if (is_of_kind(method)) least = std::min(least, method.cost_at_end.median);
    for (const MethodSummary& method : scenario.methods) {
      if (!is_of_kind(method)) continue;
      auto found = std::ranges::find(wins, method.planner, &std::pair<std::string, int>::first);
      if (found == wins.end()) found = wins.insert(found, {method.planner, 0});
      found->second += std::isfinite(least) && method.cost_at_end.median == least;
    }
  }
  Winner best;
  for (const auto& [name, count] : wins) best.scenarios = std::max(best.scenarios, count);
  for (const auto& [name, count] : wins)
    if (count == best.scenarios) best.names += (best.names.empty() ? "" : " and ") + name;
  return best;
}

// Sentence on the largest gain of a table in one scenario.
std::string gain_sentence(const Summary& summary, const Circumstances& where,
                          const std::vector<ScenarioFile>& scenarios) {
  const auto best =
      extreme(table_comparisons(summary, where, &TwinComparison::cost), Verdict::smaller);
  if (!best) return "no table makes paths shorter in any one scenario, beyond chance.";
  const PlannerProperties& properties = best->twins->properties;
  const std::string table = upper(properties.estimate), tree = upper(properties.strategy);
  const std::string& scenario = scenarios[best->scenario].scenario.name;
  const auto here = std::ranges::find_if(summary.scenarios, [&](const ScenarioSummary& found) {
    return found.scenario == best->scenario && found.region == where.region;
  });
  const auto solved = [&](const std::string& planner) {
    const MethodSummary& method =
        *std::ranges::find(here->methods, planner, &MethodSummary::planner);
    return 100.0 * method.solved / method.runs;
  };
  const double with = solved(best->twins->planner), without = solved(best->twins->twin);
  if (with > without) {
    return fmt::format(
        "with {}, {} finds a path in {} in {:.0f} % of the runs, with Euclid in {:.0f} %.", table,
        tree, scenario, with, without);
  }
  return fmt::format("with {}, paths of {} in {} change most: {} against Euclid.", table, tree,
                     scenario, change_text(best->result.ratio));
}

// Sentences on each strategy: with how many tables it ends better or worse over all scenarios.
std::string together_sentence(const std::vector<Pooled>& tables) {
  std::vector<std::string> strategies;
  for (const Pooled& table : tables) {
    const std::string& strategy = table.properties.strategy;
    if (std::ranges::find(strategies, strategy) == strategies.end()) strategies.push_back(strategy);
  }
  std::string text;
  for (const std::string& strategy : strategies) {
    const auto count = [&](Verdict verdict) {
      return std::ranges::count_if(tables, [&](const Pooled& table) {
        return table.properties.strategy == strategy && table.verdict == verdict;
      });
    };
    text += fmt::format(
        " Over all scenarios {} ends better with {} of {} tables, worse with {}.", upper(strategy),
        count(Verdict::smaller),
        std::ranges::count_if(
            tables, [&](const Pooled& table) { return table.properties.strategy == strategy; }),
        count(Verdict::larger));
  }
  return text;
}

// Sentences on the gain of the tables; empty if no table was run beside Euclid.
std::string tables_sentences(const Summary& summary, const Circumstances& where,
                             const std::vector<ScenarioFile>& scenarios) {
  const std::vector<Pooled> tables = pooled_tables(summary, where);
  if (tables.empty()) return "";
  return fmt::format(" {}: {}{}",
                     where.setting == GoalSetting::sampled ? "As printed" : "Goal tried",
                     gain_sentence(summary, where, scenarios), together_sentence(tables));
}

// Circumstances in which a claim holds: "as printed (bounds, scene), goal tried (bounds)".
std::string places_text(const std::vector<Finding>& findings, const std::string& claim) {
  std::string text;
  for (const GoalSetting setting : {GoalSetting::sampled, GoalSetting::tried}) {
    std::string regions;
    for (const Finding& finding : findings) {
      if (finding.claim != claim || finding.where.setting != setting || !finding.holds) continue;
      regions += fmt::format("{}{}", regions.empty() ? "" : ", ", name_of(finding.where.region));
    }
    if (!regions.empty())
      text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", name_of(setting), regions);
  }
  return text;
}

// Whether a planner is a random tree: only random trees have a strategy, such as "BSC".
bool is_random_tree(const MethodSummary& method) { return !method.properties.strategy.empty(); }

// Family of the thesis' trees, in either setting. Other searches may use its tables as well.
constexpr std::string_view thesis_family = "rrt";

}  // namespace

const char* name_of(GoalSetting setting) noexcept {
  return setting == GoalSetting::sampled ? "as printed" : "goal tried";
}

bool is_table_under(const PlannerProperties& properties, GoalSetting setting) noexcept {
  return properties.family == thesis_family && table_number(properties) &&
         properties.tries_goal == (setting == GoalSetting::tried);
}

std::string headline(const Summary& summary, const std::vector<ScenarioFile>& scenarios,
                     Region region) {
  const auto count = std::ranges::count(summary.scenarios, region, &ScenarioSummary::region);
  if (count == 0) return "";
  const Winner all = winner(summary, region, [](const MethodSummary&) { return true; });
  const Winner tree = winner(summary, region, is_random_tree);
  if (all.scenarios == 0) return "No planner solves half of its runs in any scenario.";
  std::string text = fmt::format(
      "{} {} with the shortest paths (medians) in {} of {} scenarios.", all.names,
      all.names.find(" and ") == std::string::npos ? "ends" : "end", all.scenarios, count);
  if (tree.scenarios > 0 && tree.names != all.names)
    text += fmt::format(" Best random tree: {}, in {} of {}.", tree.names, tree.scenarios, count);
  for (const GoalSetting setting : {GoalSetting::sampled, GoalSetting::tried})
    text += tables_sentences(summary, {region, setting}, scenarios);
  return text;
}

std::vector<Tally> tally(const Summary& summary, Region region, Measure measure) {
  std::vector<Tally> tallies;
  for (const ScenarioSummary& scenario : summary.scenarios) {
    if (scenario.region != region) continue;
    for (const TwinComparison& twins : scenario.twins) {
      auto found = std::ranges::find(tallies, twins.planner, &Tally::planner);
      if (found == tallies.end())
        found = tallies.insert(found, Tally{twins.planner, twins.properties});
      const Verdict verdict = (twins.*measure).verdict;
      found->better += verdict == Verdict::smaller;
      found->worse += verdict == Verdict::larger;
      found->no_difference += verdict == Verdict::no_difference;
      found->nothing_searched += verdict == Verdict::nothing_searched;
    }
  }
  return tallies;
}

std::vector<Finding> findings(const Summary& summary, const std::vector<ScenarioFile>& scenarios) {
  std::vector<Finding> found;
  for (const GoalSetting setting : {GoalSetting::sampled, GoalSetting::tried}) {
    for (const Region region : {Region::bounds, Region::scene}) {
      const Circumstances where{region, setting};
      if (table_comparisons(summary, where, &TwinComparison::cost).empty()) continue;
      const auto count =
          static_cast<int>(std::ranges::count(summary.scenarios, region, &ScenarioSummary::region));
      found.push_back(better_in_six_of_nine(summary, where, count));
      found.back().why = reason_for_paths(summary, scenarios, where);
      found.push_back(up_to(summary, where, scenarios, 0.2, "less time",
                            {{&TwinComparison::first_time, "First solution"},
                             {&TwinComparison::time_total, "Whole run"}}));
      found.back().why = reason_for_times(summary, where);
      found.push_back(up_to(summary, where, scenarios, 0.9, "better path",
                            {{&TwinComparison::cost, "Cost at the end"}}));
      found.back().why = reason_for_gains(summary, where);
    }
  }
  return found;
}

std::vector<std::string> verdicts(const std::vector<Finding>& findings) {
  std::vector<std::string> claims, sentences;
  for (const Finding& finding : findings) {
    if (std::ranges::find(claims, finding.claim) != claims.end()) continue;
    claims.push_back(finding.claim);
    const std::string holds = places_text(findings, finding.claim);
    sentences.push_back(
        holds.empty() ? fmt::format("The thesis claims {}: not confirmed.", finding.claim)
                      : fmt::format("The thesis claims {}: confirmed {}.", finding.claim, holds));
  }
  return sentences;
}

std::string change_text(double ratio) {
  if (ratio == 1.0) return "0 %";
  if (ratio == 0.0) return "from unsolved to solved";
  if (std::isinf(ratio)) return "from solved to unsolved";
  if (ratio >= 3.0) return fmt::format("x {:.1f}", ratio);
  const double percent = 100.0 * (ratio - 1.0);
  return fmt::format("{}{:.{}f} %", percent < 0 ? "-" : "+", std::abs(percent),
                     std::abs(percent) < 10 ? 1 : 0);
}

}  // namespace vandplan::evaluation
