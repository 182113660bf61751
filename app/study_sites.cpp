// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan study sites: what does a table of the site bring the searches?
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "study_summary.h"

namespace vandplan::app {
namespace {

using Json = nlohmann::ordered_json;
using evaluation::PairedComparison;

const char* verdict_of(const PairedComparison& comparison, const char* smaller,
                       const char* larger) {
  switch (comparison.verdict) {
    case PairedComparison::Verdict::smaller:
      return smaller;
    case PairedComparison::Verdict::larger:
      return larger;
    default:
      return "no difference";
  }
}

std::string milliseconds(double seconds) {
  return std::isfinite(seconds) ? fmt::format("{:.2f}", 1e3 * seconds) : "-";
}

std::string ratio_text(double ratio) {
  return std::isfinite(ratio) ? fmt::format("{:.3f}", ratio) : "-";
}

/// JSON has no infinite numbers: null.
Json number_of(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json runs_json(const SiteRuns& runs) {
  return {{"planner", runs.planner},
          {"solved", runs.solved},
          {"over_best", number_of(runs.over_best)},
          {"first", number_of(runs.median_first)}};
}

Json comparison_json(const PairedComparison& comparison) {
  return {{"ratio", number_of(comparison.ratio)},
          {"p", comparison.p_value},
          {"verdict", verdict_of(comparison, "smaller", "larger")}};
}

Json against_json(const SiteComparison& comparison) {
  return {{"of", comparison.of},
          {"against", comparison.against},
          {"shorter", comparison.shorter},
          {"longer", comparison.longer},
          {"length", comparison_json(comparison.cost)},
          {"first", comparison_json(comparison.first)}};
}

std::string line_of(const SiteRuns& runs) {
  return fmt::format("  {:<40} {:6}  {:>15}  {:>20}\n", runs.planner, runs.solved,
                     milliseconds(runs.median_first), ratio_text(runs.over_best));
}

std::string line_of(const SiteComparison& comparison) {
  return fmt::format(
      "  {} against {}: paths {} ({} shorter, {} longer, p = {:.2g}), the first path {} ({} times, "
      "p = {:.2g})\n",
      comparison.of, comparison.against, verdict_of(comparison.cost, "SHORTER", "LONGER"),
      comparison.shorter, comparison.longer, comparison.cost.p_value,
      verdict_of(comparison.first, "SOONER", "LATER"), ratio_text(comparison.first.ratio),
      comparison.first.p_value);
}

}  // namespace

std::string summary_of(const SitesStudy& study) {
  std::string text = fmt::format(
      "Searches with a table of the site: {} problems on {} sites, {} s of processor time each, "
      "seed {}\n"
      "  {:<40} solved  first path [ms]  length over the best\n",
      study.problems.size(), study.options.sites.size(), study.options.time_limit,
      study.options.seed, "planner");
  for (const SiteSearch& search : study.searches) {
    text += "  " + search.name + '\n';
    for (const SiteRuns& runs : search.runs) text += line_of(runs);
    for (const SiteRuns& runs : search.learned) text += line_of(runs);
    text += line_of(search.table);
    for (const SiteComparison& network : search.networks) text += line_of(network);
    text += '\n';
  }
  text += "Coarser tables\n";
  for (const auto& [headings, cell, megabytes, runs] : study.resolutions) {
    text += fmt::format("  {} headings, cells of {} turning radii, {:.2f} MB\n", headings, cell,
                        megabytes);
    for (const SiteRuns& of_planner : runs) text += line_of(of_planner);
  }
  text +=
      fmt::format("Costs against those of the table\n  {:<40} {:>8}  {:>8}  {:>8}  {:>6}  {:>5}\n",
                  "estimate", "MB", "mean [m]", "95 % [m]", "mean %", "[ns]");
  for (const auto& [name, megabytes, errors] : study.estimates) {
    text += fmt::format("  {:<40} {:8.4f}  {:8.2f}  {:8.2f}  {:6.2f}  {:5.0f}\n", name, megabytes,
                        errors.mean, errors.percent_95, 100 * errors.relative, errors.nanoseconds);
  }
  return text;
}

Json json_of(const SitesStudy& study) {
  Json searches = Json::array();
  for (const SiteSearch& search : study.searches) {
    Json planners = Json::array(), learned = Json::array(), networks = Json::array();
    for (const SiteRuns& runs : search.runs) planners.push_back(runs_json(runs));
    for (const SiteRuns& runs : search.learned) learned.push_back(runs_json(runs));
    for (const SiteComparison& network : search.networks) networks.push_back(against_json(network));
    searches.push_back({{"search", search.name},
                        {"asked", search.asked},
                        {"planners", planners},
                        {"table", against_json(search.table)},
                        {"learned", learned},
                        {"networks", networks}});
  }
  Json tables = Json::array();
  for (const auto& [headings, cell, megabytes, runs] : study.resolutions) {
    Json planners = Json::array();
    for (const SiteRuns& of_planner : runs) planners.push_back(runs_json(of_planner));
    tables.push_back(
        {{"headings", headings}, {"cell", cell}, {"megabytes", megabytes}, {"planners", planners}});
  }
  Json estimates = Json::array();
  for (const auto& [name, megabytes, errors] : study.estimates) {
    estimates.push_back({{"estimate", name},
                         {"megabytes", megabytes},
                         {"mean", errors.mean},
                         {"percent_95", errors.percent_95},
                         {"relative", errors.relative},
                         {"nanoseconds", errors.nanoseconds}});
  }
  return {{"problems", study.problems.size()},
          {"time_limit", study.options.time_limit},
          {"seed", study.options.seed},
          {"searches", searches},
          {"tables", tables},
          {"estimates", estimates}};
}

}  // namespace vandplan::app
