// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// vandplan study sites: what does a table of the site bring the searches?
#include <fmt/format.h>

#include <cmath>

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

}  // namespace

std::string summary_of(const SitesStudy& study) {
  std::string text = fmt::format(
      "Searches with a table of the site: {} problems on {} sites, {} s of processor time each, "
      "seed {}\n"
      "  {:<40} solved  first path [ms]  length over the best\n",
      study.problems.size(), study.options.sites.size(), study.options.time_limit,
      study.options.seed, "planner");
  const auto line_of = [](const SiteRuns& runs) {
    return fmt::format("  {:<40} {:6}  {:>15}  {:>20}\n", runs.planner, runs.solved,
                       milliseconds(runs.median_first), ratio_text(runs.over_best));
  };
  for (const SiteSearch& search : study.searches) {
    for (const SiteRuns& runs : search.runs) text += line_of(runs);
    text += fmt::format(
        "  {}: the table against {}: paths {} ({} shorter, {} longer, p = {:.2g}), the first "
        "path {} (p = {:.2g})\n\n",
        search.name, search.runs[search.rival].planner,
        verdict_of(search.cost, "SHORTER", "LONGER"), search.shorter, search.longer,
        search.cost.p_value, verdict_of(search.first, "SOONER", "LATER"), search.first.p_value);
  }
  text += "Coarser tables\n";
  for (const auto& [headings, cell, megabytes, runs] : study.resolutions) {
    text += fmt::format("  {} headings, cells of {} turning radii, {:.2f} MB\n", headings, cell,
                        megabytes);
    for (const SiteRuns& of_planner : runs) text += line_of(of_planner);
  }
  return text;
}

Json json_of(const SitesStudy& study) {
  Json searches = Json::array();
  for (const SiteSearch& search : study.searches) {
    Json planners = Json::array();
    for (const SiteRuns& runs : search.runs) planners.push_back(runs_json(runs));
    searches.push_back({{"search", search.name},
                        {"planners", planners},
                        {"rival", search.runs[search.rival].planner},
                        {"shorter", search.shorter},
                        {"longer", search.longer},
                        {"length", comparison_json(search.cost)},
                        {"first", comparison_json(search.first)}});
  }
  Json tables = Json::array();
  for (const auto& [headings, cell, megabytes, runs] : study.resolutions) {
    Json planners = Json::array();
    for (const SiteRuns& of_planner : runs) planners.push_back(runs_json(of_planner));
    tables.push_back(
        {{"headings", headings}, {"cell", cell}, {"megabytes", megabytes}, {"planners", planners}});
  }
  return {{"problems", study.problems.size()},
          {"time_limit", study.options.time_limit},
          {"seed", study.options.seed},
          {"searches", searches},
          {"tables", tables}};
}

}  // namespace vandplan::app
