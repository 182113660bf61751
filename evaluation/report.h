// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a comparison presented to people?

#include <string>
#include <string_view>
#include <vector>

#include "evaluation/campaign.h"
#include "evaluation/findings.h"
#include "evaluation/report_options.h"
#include "evaluation/store.h"
#include "evaluation/summary.h"

namespace vandplan::evaluation {

/// Contents of a report.
struct Report {
  Environment environment;
  std::vector<Planner> planners;  ///< planners of the runs, in the order of presentation
  ReportOptions options;
  std::vector<StoredScenario> files;
  std::vector<ScenarioFile> scenarios;  ///< scenarios of the files, in the same order
  std::vector<RunRecord> runs;          ///< runs; only paths that the summary picks have segments
  std::vector<Session> sessions;
  /// Number of runs in the store that the report leaves out: other environment, other options, or a
  /// file that changed since.
  int left_out = 0;
  Summary summary;
  std::vector<Finding> findings;
};

/// Report on the runs of a store that have the environment and the limits of the last run. For each
/// planner it takes the options of its last run, for each file the contents at its last run. Throws
/// InputError when there is no run.
[[nodiscard]] Report make_report(Store& store);

/// Report on the runs that this program made on this machine with the settings of a campaign, and
/// on other planners with the same limits. Throws InputError when there is no run.
[[nodiscard]] Report make_report(Store& store, const Campaign& campaign);

/// Headline and tables of all planners and scenarios for each region, as Markdown that is easy to
/// read in a terminal.
[[nodiscard]] std::string headline_markdown(const Report& report);

/// JSON object with the figures of the headline; times in seconds, costs as in `MethodSummary`.
[[nodiscard]] std::string headline_json(const Report& report);

/// Markdown tables of every search with every estimate, and of the literature's claims on them.
/// Empty if no search was run with more than one estimate.
[[nodiscard]] std::string search_matrix_markdown(const Report& report);

/// Markdown of the whole report: headline, searches, and a table for each scenario and region.
[[nodiscard]] std::string report_markdown(const Report& report);

/// PNG with one cell for each scenario, which shows the best path of any planner.
[[nodiscard]] std::string gallery_png(const Report& report);

/// HTML page that contains text, data, pictures and program. `gallery` is the PNG of `gallery_png`.
[[nodiscard]] std::string report_html(const Report& report, std::string_view gallery);

/// Command that repeats a run and finds the same path, whatever the machine's speed. With a row of
/// goals it plans for all of them. For a planner outside the library it lists the options.
[[nodiscard]] std::string reproduce_command(const Report& report, const RunRecord& run);

}  // namespace vandplan::evaluation
