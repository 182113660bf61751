// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/report_json.h"

#include <cmath>
#include <map>
#include <utility>

#include "evaluation/methods.h"
#include "evaluation/pooled.h"

namespace vandplan::evaluation {
namespace {

OrderedJson json_of(const Interval& interval) {
  return {finite_json(interval.low), finite_json(interval.high)};
}

OrderedJson json_of(const PairedComparison& comparison) {
  return {{"pairs", comparison.pairs},
          {"ratio", finite_json(comparison.ratio)},
          {"interval", json_of(comparison.interval)},
          {"p_value", comparison.p_value},
          {"verdict", verdict_name(comparison.verdict)}};
}

}  // namespace

const char* verdict_name(PairedComparison::Verdict verdict) {
  switch (verdict) {
    case PairedComparison::Verdict::smaller:
      return "better";
    case PairedComparison::Verdict::larger:
      return "worse";
    case PairedComparison::Verdict::nothing_searched:
      return "nothing searched";
    case PairedComparison::Verdict::no_difference:
      break;
  }
  return "no difference";
}

OrderedJson json_of(const MedianEstimate& estimate) {
  return {{"median", finite_json(estimate.median)}, {"interval", json_of(estimate.interval)}};
}

OrderedJson json_of(const MethodSummary& method, bool row) {
  OrderedJson json = {{"planner", method.planner},
                      {"runs", method.runs},
                      {"solved", method.solved},
                      {"rejected", method.rejected},
                      {"no_path", method.no_path},
                      {"solved_interval", json_of(method.solved_interval)},
                      {"first_solution", json_of(method.first_time)},
                      {"cost_at_10ms", json_of(method.cost_at_10ms)},
                      {"cost_at_100ms", json_of(method.cost_at_100ms)},
                      {"cost_at_end", json_of(method.cost_at_end)},
                      {"time", method.time_total},
                      {"nodes", method.nodes},
                      {"iterations", method.iterations}};
  if (row) json["furthest"] = method.furthest;
  return json;
}

OrderedJson json_of(const TwinComparison& twins) {
  return {{"planner", twins.planner},
          {"twin", twins.twin},
          {"cost", json_of(twins.cost)},
          {"first_solution", json_of(twins.first_time)},
          {"time", json_of(twins.time_total)}};
}

OrderedJson pooled_json(const Summary& summary) {
  OrderedJson json = OrderedJson::array();
  for (const Region region : {Region::bounds, Region::scene}) {
    for (const Pooled& planner : pooled(summary, region)) {
      json.push_back({{"region", name_of(region)},
                      {"planner", planner.planner},
                      {"tries_goal", planner.properties.tries_goal},
                      {"runs", planner.runs},
                      {"solved", planner.solved},
                      {"twin_runs", planner.twin_runs},
                      {"twin_solved", planner.twin_solved},
                      {"pairs", planner.pairs},
                      {"better", planner.cheaper},
                      {"worse", planner.dearer},
                      {"cost_ratio", finite_json(planner.ratio)},
                      {"exact_lengths_per_iteration", planner.exact_solves},
                      {"verdict", verdict_name(planner.verdict)}});
    }
  }
  return json;
}

OrderedJson environment_json(const Environment& environment) {
  return {{"version", environment.version},       {"compiler", environment.compiler},
          {"build_type", environment.build_type}, {"executable", environment.executable},
          {"processor", environment.processor},   {"cores", environment.cores},
          {"system", environment.system}};
}

OrderedJson finite_json(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}

OrderedJson harness_json(const std::vector<Session>& sessions) {
  Session sum;
  double wall = 0.0;
  for (const Session& session : sessions) {
    sum.runs += session.runs;
    sum.planning_time += session.planning_time;
    sum.judging_time += session.judging_time;
    sum.storing_time += session.storing_time;
    wall += session.wall_time * session.jobs;
  }
  return {{"runs", sum.runs},
          {"planning", sum.planning_time},
          {"judging", sum.judging_time},
          {"storing", sum.storing_time},
          {"rest", wall - sum.planning_time - sum.judging_time}};
}

OrderedJson claims_json(const std::vector<Finding>& findings) {
  OrderedJson claims = OrderedJson::array();
  for (const Finding& finding : findings) {
    claims.push_back({{"setting", name_of(finding.where.setting)},
                      {"region", name_of(finding.where.region)},
                      {"claim", finding.claim},
                      {"holds", finding.holds},
                      {"found", finding.found},
                      {"why", finding.why}});
  }
  return claims;
}

OrderedJson verdicts_json(const std::vector<Finding>& findings) {
  OrderedJson sentences = OrderedJson::array();
  for (const std::string& sentence : verdicts(findings)) sentences.push_back(sentence);
  return sentences;
}

OrderedJson rejected_json(const std::vector<RunRecord>& runs) {
  // Number of rejected paths, and the first reason.
  std::map<std::string, std::pair<int, std::string>> found;
  for (const RunRecord& run : runs) {
    if (run.result.status != PlanStatus::rejected) continue;
    auto& [count, reason] = found[run.planner];
    if (count++ == 0) reason = run.result.reason;
  }
  OrderedJson rejected = OrderedJson::array();
  for (const auto& [planner, what] : found)
    rejected.push_back({{"planner", planner}, {"runs", what.first}, {"reason", what.second}});
  return rejected;
}

OrderedJson shared_options_json(const ReportOptions& options) {
  OrderedJson json = OrderedJson::object();
  for (const auto& [name, value] : options.shared) json[name] = OrderedJson::parse(value);
  return json;
}

OrderedJson differing_options_json(const ReportOptions& options) {
  OrderedJson json = OrderedJson::array();
  for (const ReportOptions::Own& own : options.differing) {
    json.push_back(
        {{"name", own.name}, {"value", OrderedJson::parse(own.value)}, {"planners", own.planners}});
  }
  return json;
}

OrderedJson planners_json(const std::vector<Planner>& planners) {
  OrderedJson list = OrderedJson::array();
  for (const Planner& planner : planners) {
    list.push_back({{"name", planner.name},
                    {"summary", planner.summary},
                    {"family", planner.properties.family},
                    {"strategy", planner.properties.strategy},
                    {"estimate", planner.properties.estimate},
                    {"search", planner.properties.search},
                    {"tries_goal", planner.properties.tries_goal}});
  }
  return list;
}

OrderedJson headlines_json(const Report& report) {
  OrderedJson headlines = OrderedJson::object();
  for (const Region region : {Region::bounds, Region::scene}) {
    const std::string text = headline(report.summary, report.scenarios, region);
    if (!text.empty()) headlines[name_of(region)] = text;
  }
  return headlines;
}

std::string headline_json(const Report& report) {
  OrderedJson scenarios = OrderedJson::array();
  for (const ScenarioSummary& summary : report.summary.scenarios) {
    const ScenarioFile& scenario = report.scenarios[summary.scenario];
    OrderedJson methods = OrderedJson::array(), twins = OrderedJson::array();
    for (const MethodSummary& method : summary.methods)
      methods.push_back(json_of(method, scenario.is_row()));
    for (const TwinComparison& twin : summary.twins) twins.push_back(json_of(twin));
    scenarios.push_back({{"scenario", scenario.scenario.name},
                         {"region", name_of(summary.region)},
                         {"planners", methods},
                         {"against_euclid", twins}});
  }
  const OrderedJson all = {{"verdicts", verdicts_json(report.findings)},
                           {"headline", headlines_json(report)},
                           {"runs", report.runs.size()},
                           {"left_out", report.left_out},
                           {"environment", environment_json(report.environment)},
                           {"options", shared_options_json(report.options)},
                           {"differing_options", differing_options_json(report.options)},
                           {"harness", harness_json(report.sessions)},
                           {"scenarios", scenarios},
                           {"against_euclid", pooled_json(report.summary)},
                           {"claims", claims_json(report.findings)},
                           {"searches", search_matrix_json(report)},
                           {"literature", literature_json(report)},
                           {"rejected", rejected_json(report.runs)},
                           {"planners", planners_json(report.planners)}};
  return all.dump(2);
}

}  // namespace vandplan::evaluation
