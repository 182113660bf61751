// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <fmt/format.h>

#include <algorithm>

#include "studies/sites.h"

namespace vandplan::studies {
namespace {

std::string csv_of_runs(const SitesStudy& study) {
  std::string csv = "search,runs,planner,site,start,length,first\n";
  for (std::size_t s = 0; s < study.searches.size(); ++s) {
    std::vector<SiteRuns> all = study.searches[s].runs;
    all.insert(all.end(), study.searches[s].learned.begin(), study.searches[s].learned.end());
    for (std::size_t r = 0; r < all.size(); ++r) {
      for (std::size_t i = 0; i < study.problems.size(); ++i) {
        csv += fmt::format("{},{},\"{}\",{},{},{:.6g},{:.6g}\n", s, r, all[r].planner,
                           study.options.sites[study.problems[i].site].name, i, all[r].costs[i],
                           all[r].first[i]);
      }
    }
  }
  return csv;
}

std::string csv_of_tables(const SitesStudy& study) {
  std::string csv = "headings,cell,megabytes,planner,solved,over_best,first\n";
  for (const auto& [headings, cell, megabytes, all] : study.resolutions) {
    for (const SiteRuns& runs : all) {
      csv += fmt::format("{},{},{:.4f},\"{}\",{},{:.6g},{:.6g}\n", headings, cell, megabytes,
                         runs.planner, runs.solved, runs.over_best, runs.median_first);
    }
  }
  return csv;
}

std::string csv_of_estimates(const SitesStudy& study) {
  std::string csv = "estimate,megabytes,mean,percent_95,relative,nanoseconds\n";
  for (const auto& [name, megabytes, errors] : study.estimates) {
    csv += fmt::format("\"{}\",{:.6f},{:.6g},{:.6g},{:.6g},{:.4g}\n", name, megabytes, errors.mean,
                       errors.percent_95, errors.relative, errors.nanoseconds);
  }
  return csv;
}

/// Share of the problems that some runs have solved by a time. Other lines of the file weigh
/// nothing and stand far off: missing values would cut the curve.
std::string curve(std::size_t search, std::size_t runs, double share, const std::string& title,
                  const std::string& look) {
  const std::string counts = fmt::format("$1=={} && $2=={} && $7<1e9", search, runs);
  return fmt::format(
      "'sites_runs.csv' skip 1 using ({0} ? 1000*$7 : 1e9):({0} ? {1:.6f} : 0) smooth cumulative "
      "with lines {2} title '{3}'",
      counts, share, look, title);
}

}  // namespace

StudyFiles files_of(const SitesStudy& study) {
  std::vector<TextFile> data = {{"sites_runs.csv", csv_of_runs(study)},
                                {"sites_tables.csv", csv_of_tables(study)},
                                {"sites_estimates.csv", csv_of_estimates(study)}};
  std::string body = fmt::format(
      "set multiplot layout 3,5 title 'Problems with a path [%] by processor time [ms]: with the "
      "table "
      "of the site (solid), with the best other estimate (dashed)' font ',14'\n"
      "set logscale x\nset xrange [0.01:{}]\nset yrange [0:100]\nset key below samplen 1 font "
      "',9'\n",
      1e3 * study.options.time_limit);
  const double share = 100.0 / static_cast<double>(std::max(study.problems.size(), std::size_t{1}));
  for (std::size_t s = 0; s < study.searches.size(); ++s) {
    const SiteSearch& search = study.searches[s];
    body += fmt::format(
        "set title '{}'\nplot {}, {}, -1 notitle\n", search.name,
        curve(s, search.runs.size() - 1, share, "table of the site",
              fmt::format("linewidth 2.5 linecolor rgb '{}'", study_colour::blue)),
        curve(s, search.rival, share, search.runs[search.rival].planner,
              fmt::format("linewidth 2 dashtype (8,5) linecolor rgb '{}'", study_colour::orange)));
  }
  return study_files({"sites", 2000, 1200}, std::move(data), body + "unset multiplot\n");
}

}  // namespace vandplan::studies
