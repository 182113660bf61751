// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a comparison told to people?

#include <string>
#include <string_view>
#include <vector>

#include "evaluation/campaign.h"
#include "evaluation/findings.h"
#include "evaluation/report_options.h"
#include "evaluation/store.h"
#include "evaluation/summary.h"

namespace vandplan::evaluation {

/// Everything that a report tells.
struct Report {
  Environment environment;
  std::vector<Planner> planners;  ///< of the runs, in the order in which to show them
  ReportOptions options;
  std::vector<StoredScenario> files;
  std::vector<ScenarioFile> scenarios;  ///< what the files say
  std::vector<RunRecord> runs;          ///< with the segments of those paths that the summary picks
  std::vector<Session> sessions;
  /// Runs in the store that are of another environment, other options, or of files changed since.
  int left_out = 0;
  Summary summary;
  std::vector<Finding> findings;
};

/// Tells of the runs of a store that were made where and with the limits with which the last one
/// was, of each planner those with the options and of each file those of what it held last. Throws
/// InputError when there is none.
[[nodiscard]] Report make_report(Store& store);

/// Tells of the runs that this program made on this machine with the settings of a campaign, and of
/// other planners with the same limits. Throws InputError when there is none.
[[nodiscard]] Report make_report(Store& store, const Campaign& campaign);

/// The headline and a table of all planners and scenarios for each region, as Markdown that is
/// easy to read in a terminal.
[[nodiscard]] std::string headline_markdown(const Report& report);

/// The figures of the headline as a JSON object; times [s], costs as in `MethodSummary`.
[[nodiscard]] std::string headline_json(const Report& report);

/// Every search with every estimate, and what the literature says of them; empty if no search was
/// run with more than one estimate.
[[nodiscard]] std::string search_matrix_markdown(const Report& report);

/// The headline, the searches and a table for each scenario and region.
[[nodiscard]] std::string report_markdown(const Report& report);

/// A picture (PNG) with a cell for each scenario: the best path, whoever found it.
[[nodiscard]] std::string gallery_png(const Report& report);

/// One page with everything in it: text, data, pictures and program. `gallery` as above.
[[nodiscard]] std::string report_html(const Report& report, std::string_view gallery);

/// The command that repeats a run and finds the same path, whatever the machine's speed; with a
/// row of goals it plans for all of them, the run's goal among them. Of a planner that is not the
/// library's: the options to plan with.
[[nodiscard]] std::string reproduce_command(const Report& report, const RunRecord& run);

}  // namespace vandplan::evaluation
