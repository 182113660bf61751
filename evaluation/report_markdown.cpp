// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/escape.h"
#include "base/text.h"
#include "evaluation/methods.h"
#include "evaluation/pooled.h"
#include "evaluation/report.h"
#include "evaluation/report_json.h"
#include "evaluation/text_table.h"

namespace vandplan::evaluation {
namespace {

using base::markdown;

constexpr const char* none = "-";

std::string cost_text(double cost) { return std::isinf(cost) ? none : fmt::format("{:.1f}", cost); }

std::string ratio_text(double ratio) {
  return std::isinf(ratio) ? none : fmt::format("x{:.2f}", ratio);
}

std::string time_text(double seconds) {
  return std::isinf(seconds) ? none : fmt::format("{:.2f}", 1000.0 * seconds);
}

template <typename Text>
std::string with_interval(const MedianEstimate& estimate, Text text) {
  if (std::isinf(estimate.median)) return none;
  if (std::isinf(estimate.interval.low)) return text(estimate.median);
  const std::string high =
      std::isinf(estimate.interval.high) ? "..." : text(estimate.interval.high);
  return fmt::format("{} [{}, {}]", text(estimate.median), text(estimate.interval.low), high);
}

bool is_row(const Report& report, const ScenarioSummary& scenario) {
  return report.scenarios[scenario.scenario].is_row();
}

// Name without its prefix: "5-leave-cage" for "thesis-5-leave-cage".
std::string short_name(const std::string& scenario) {
  return scenario.starts_with("thesis-") ? scenario.substr(7) : scenario;
}

// Cost at the end, with the solved runs if not all are solved. In a row of goals the furthest
// distance.
std::string headline_cell(const MethodSummary& method, bool row) {
  if (row)
    return method.furthest > 0.0 ? fmt::format("{:.0f} m", method.furthest) : std::string(none);
  std::string cost = cost_text(method.cost_at_end.median);
  if (method.solved == method.runs) return cost;
  return fmt::format("{} ({}/{})", cost, method.solved, method.runs);
}

std::string first_time_cell(const MethodSummary& method, bool) {
  return time_text(method.first_time.median);
}

using CellText = std::string (*)(const MethodSummary&, bool);

// Table of planners and scenarios; the longer list goes down.
std::string matrix(const Report& report, Region region, CellText cell) {
  std::vector<std::string> planners, scenarios;
  // Cells of each scenario, in the order of the planners.
  std::vector<std::vector<std::string>> cells;
  for (const ScenarioSummary& scenario : report.summary.scenarios) {
    if (scenario.region != region) continue;
    scenarios.push_back(markdown(short_name(report.scenarios[scenario.scenario].scenario.name)));
    std::vector<std::string>& row = cells.emplace_back(planners.size());
    for (const MethodSummary& method : scenario.methods) {
      const auto known = std::ranges::find(planners, method.planner);
      const auto at = static_cast<std::size_t>(known - planners.begin());
      if (known == planners.end()) planners.push_back(method.planner);
      row.resize(planners.size());
      row[at] = cell(method, is_row(report, scenario));
    }
  }
  for (std::string& planner : planners) planner = markdown(planner);
  const bool planners_down = planners.size() >= scenarios.size();
  const std::vector<std::string>& down = planners_down ? planners : scenarios;
  std::vector<std::string> head = planners_down ? scenarios : planners;
  const std::size_t across = head.size();
  head.insert(head.begin(), planners_down ? "planner" : "scenario");
  TextTable table(head);
  for (std::vector<std::string>& row : cells) row.resize(planners.size());
  for (std::size_t i = 0; i < down.size(); ++i) {
    std::vector<std::string> line = {down[i]};
    for (std::size_t j = 0; j < across; ++j)
      line.push_back(planners_down ? cells[j][i] : cells[i][j]);
    table.add(std::move(line));
  }
  return table.markdown();
}

std::string phases_text(const MethodSummary& method) {
  if (!method.phases) return none;
  const auto& [ranking, steering, checking] = *method.phases;
  return fmt::format("{:.0f}/{:.0f}/{:.0f}", 100.0 * ranking, 100.0 * steering, 100.0 * checking);
}

std::string solved_text(const MethodSummary& method) {
  std::string text =
      fmt::format("{}/{} [{:.0f}, {:.0f} %]", method.solved, method.runs,
                  100.0 * method.solved_interval.low, 100.0 * method.solved_interval.high);
  if (method.no_path > 0) text += fmt::format(", {} proved no path", method.no_path);
  return text;
}

std::string scenario_table(const ScenarioSummary& scenario, bool row) {
  const auto cost = row ? ratio_text : cost_text;
  TextTable table({"planner", "solved", "first [ms]", "at 10 ms", "at 100 ms", "tree full",
                   "at the end", "nodes", "iterations", "time [ms]", "rank/steer/check [%]"});
  for (const MethodSummary& method : scenario.methods) {
    table.add({markdown(method.planner), solved_text(method),
               with_interval(method.first_time, time_text), cost(method.cost_at_10ms.median),
               cost(method.cost_at_100ms.median),
               method.full > 0 ? cost(method.cost_when_full.median) : none,
               with_interval(method.cost_at_end, cost), fmt::format("{:.0f}", method.nodes),
               fmt::format("{:.0f}", method.iterations), time_text(method.time_total),
               phases_text(method)});
  }
  return table.markdown();
}

std::string row_table(const ScenarioSummary& scenario) {
  std::vector<std::string> head = {"planner", "furthest [m]"};
  for (const GoalSummary& goal : scenario.methods.front().goals)
    head.push_back(fmt::format("{:.0f} m", goal.distance));
  TextTable table(head);
  for (const MethodSummary& method : scenario.methods) {
    std::vector<std::string> cells = {markdown(method.planner),
                                      fmt::format("{:.0f}", method.furthest)};
    for (const GoalSummary& goal : method.goals) cells.push_back(cost_text(goal.cost));
    cells.resize(head.size());
    table.add(std::move(cells));
  }
  return table.markdown();
}

std::string comparison_text(const PairedComparison& comparison) {
  if (comparison.verdict == PairedComparison::Verdict::nothing_searched)
    return verdict_name(comparison.verdict);
  const auto& [low, high] = comparison.interval;
  std::string text =
      fmt::format("{}: {}", verdict_name(comparison.verdict), change_text(comparison.ratio));
  if (low == 0.0 && std::isinf(high)) return text;  // too few or too mixed pairs for a bound
  return fmt::format("{} [{}, {}]", text, change_text(low), change_text(high));
}

std::string twin_table(const ScenarioSummary& scenario) {
  if (scenario.twins.empty()) return "";
  TextTable table({"against its Euclid twin", "cost", "first solution", "whole run"});
  for (const TwinComparison& twins : scenario.twins) {
    table.add({markdown(twins.planner), comparison_text(twins.cost),
               comparison_text(twins.first_time), comparison_text(twins.time_total)});
  }
  return table.markdown();
}

// Table of planners against their Euclid twins over all scenarios of a region.
std::string pooled_table(const Report& report, Region region) {
  const std::vector<Pooled> planners = pooled(report.summary, region);
  if (planners.empty()) return "";
  TextTable table({"all scenarios together", "solved", "Euclid solves", "pairs", "better", "equal",
                   "worse", "cost", "exact lengths per iteration", "verdict"});
  const auto share = [](int part, int whole) {
    return fmt::format("{:.0f} %", 100.0 * part / whole);
  };
  for (const Pooled& found : planners) {
    const PairedComparison::Verdict verdict = found.verdict;
    table.add({markdown(found.planner), share(found.solved, found.runs),
               share(found.twin_solved, found.twin_runs), std::to_string(found.pairs),
               share(found.cheaper, found.pairs),
               share(found.pairs - found.cheaper - found.dearer, found.pairs),
               share(found.dearer, found.pairs), change_text(found.ratio),
               fmt::format("{:.1f}", found.exact_solves), verdict_name(verdict)});
  }
  return "\nAgainst the twin that ranks by Euclid, pairs of equal seed, cost at the end:\n\n" +
         table.markdown();
}

std::string jobs_text(const Report& report) {
  std::set<int> jobs;
  for (const RunRecord& run : report.runs) jobs.insert(run.jobs);
  return fmt::format("{} at a time", fmt::join(jobs, " or "));
}

// Text on the machine. Runs that every machine repeats have no machine and no times.
std::string machine_text(const Environment& here) {
  if (here.cores == 0) return "any machine, which finds the same; times are not told";
  return fmt::format("{} ({} cores), {}", markdown(here.processor), here.cores,
                     markdown(here.system));
}

// Options of the runs: one line for shared options, and one for each that differs.
std::string options_text(const ReportOptions& options) {
  std::string text = "Options: `" + shared_options_json(options).dump() + "`.\n";
  for (const ReportOptions::Own& own : options.differing) {
    text += fmt::format("`{}` is {} for {}.\n", own.name, markdown(own.value),
                        markdown(base::joined(own.planners)));
  }
  return text;
}

std::string rejected_text(const Report& report) {
  std::string text;
  for (const OrderedJson& rejected : rejected_json(report.runs)) {
    text += fmt::format("{} paths of {} were rejected by the judge, the first because {}.\n",
                        rejected.at("runs").get<int>(),
                        markdown(rejected.at("planner").get<std::string>()),
                        markdown(rejected.at("reason").get<std::string>()));
  }
  return text;
}

std::string circumstances(const Report& report) {
  const Environment& here = report.environment;
  std::string text = fmt::format("{} runs, {}vandplan {} ({}, {}) on {}.\n", report.runs.size(),
                                 here.cores > 0 ? jobs_text(report) + ", " : "", here.version,
                                 here.compiler, here.build_type, machine_text(here));
  text += options_text(report.options);
  text += rejected_text(report);
  const OrderedJson harness = harness_json(report.sessions);
  const double planning = harness.at("planning");
  const auto share = [&](const char* part) {
    return 100.0 * harness.at(part).get<double>() / planning;
  };
  if (planning > 0.0) {
    text += fmt::format(
        "Planning took {:.1f} s; storing the runs {:.2f} % of that, judging their paths {:.1f} %, "
        "the rest {:.1f} %.\n",
        planning, share("storing"), share("judging"), share("rest"));
  }
  if (report.left_out > 0) {
    text += fmt::format(
        "{} runs in the store are of other programs, machines or options, or of files changed "
        "since, and are left out.\n",
        report.left_out);
  }
  return text;
}

// Table of verdicts: claims down, circumstances across.
std::string claims_table(const std::vector<Finding>& findings) {
  std::vector<std::string> head = {"claim"}, claims;
  std::vector<Circumstances> circumstances;
  for (const Finding& finding : findings) {
    if (std::ranges::find(claims, finding.claim) == claims.end()) claims.push_back(finding.claim);
    if (std::ranges::find(circumstances, finding.where) != circumstances.end()) continue;
    circumstances.push_back(finding.where);
    head.push_back(
        fmt::format("{}, {}", name_of(finding.where.setting), name_of(finding.where.region)));
  }
  TextTable table(head);
  for (const std::string& claim : claims) {
    std::vector<std::string> line = {claim};
    for (const Circumstances& where : circumstances) {
      const auto found = std::ranges::find_if(findings, [&](const Finding& finding) {
        return finding.claim == claim && finding.where == where;
      });
      line.emplace_back(found->holds ? "confirmed" : "not confirmed");
    }
    table.add(std::move(line));
  }
  return table.markdown();
}

std::string claims(const Report& report) {
  if (report.findings.empty()) return "";
  std::string text = "\n## The thesis' claims about its tables\n\n" +
                     claims_table(report.findings) +
                     "\nAs printed: the goal is a sample like others. Goal tried: from every new "
                     "node.\n\n";
  for (const Finding& finding : report.findings) {
    text += fmt::format("- {}, region {}, \"{}\": **{}**. {}. {}\n",
                        finding.where.setting == GoalSetting::sampled ? "As printed" : "Goal tried",
                        name_of(finding.where.region), finding.claim,
                        finding.holds ? "confirmed" : "not confirmed", markdown(finding.found),
                        markdown(finding.why));
  }
  return text;
}

bool has_region(const Report& report, Region region) {
  return std::ranges::count(report.summary.scenarios, region, &ScenarioSummary::region) > 0;
}

}  // namespace

std::string headline_markdown(const Report& report) {
  std::string text = "# Comparison of planners\n\n";
  for (const Region region : {Region::bounds, Region::scene}) {
    if (has_region(report, region)) {
      text += fmt::format("- Samples from the {}: {}\n", name_of(region),
                          markdown(headline(report.summary, report.scenarios, region)));
    }
  }
  for (const std::string& verdict : verdicts(report.findings))
    text += "- " + markdown(verdict) + "\n";
  text += "\n" + circumstances(report);
  for (const Region region : {Region::bounds, Region::scene}) {
    if (!has_region(report, region)) continue;
    text += fmt::format(
        "\n## Samples from the {}: median cost at the end [m] (and runs solved if not all; "
        "in a row of goals the furthest reached)\n\n{}"
        "\nMedian time of the first solution [ms]:\n\n{}",
        name_of(region), matrix(report, region, headline_cell),
        matrix(report, region, first_time_cell));
    text += pooled_table(report, region);
  }
  return text + claims(report);
}

std::string report_markdown(const Report& report) {
  std::string text = headline_markdown(report) + search_matrix_markdown(report);
  for (const ScenarioSummary& scenario : report.summary.scenarios) {
    const bool row = is_row(report, scenario);
    text += fmt::format(
        "\n## {}, samples from the {}\n\n{}{}\n",
        markdown(report.scenarios[scenario.scenario].scenario.name), name_of(scenario.region),
        row ? "Costs per metre of the goal's distance.\n\n" : "", scenario_table(scenario, row));
    if (row) text += row_table(scenario) + "\n";
    text += twin_table(scenario);
  }
  return text + fmt::format(
                    "\nMedians with their {0:.0f} % intervals in brackets, from ranks alone; an "
                    "unsolved run counts as infinite.\nComparisons are paired by seed. An interval "
                    "holds for its comparison alone with {0:.0f} % confidence, the verdicts of all "
                    "comparisons hold together (Holm).\nThe first solution is timed from the first "
                    "iteration. A difference below what setting a run up takes is a tie. Nothing "
                    "searched: every run found its path at once, which says nothing about a "
                    "heuristic.\n",
                    100.0 * confidence);
}

}  // namespace vandplan::evaluation
