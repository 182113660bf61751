// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/escape.h"
#include "evaluation/report.h"
#include "vandplan/draw.h"

namespace vandplan::evaluation {
namespace {

using base::printable;

constexpr int cell_width = 360;  // width of a cell [pixels]

// Whether a run is a better example than another. In a row of goals the further goal counts first.
bool is_better(const RunRecord& run, const RunRecord& other) {
  if (run.goal != other.goal) return run.goal > other.goal;
  return final_cost(run) < final_cost(other);
}

// Best run of a scenario, of any planner; null if nobody solved it.
const RunRecord* best_run(const Report& report, std::size_t scenario) {
  const RunRecord* best = nullptr;
  for (const ScenarioSummary& summary : report.summary.scenarios) {
    if (summary.scenario != scenario) continue;
    for (const MethodSummary& method : summary.methods) {
      if (!method.best) continue;
      const RunRecord& run = report.runs[*method.best];
      if (best == nullptr || is_better(run, *best)) best = &run;
    }
  }
  return best;
}

}  // namespace

std::string gallery_png(const Report& report) {
  std::set<std::size_t> scenarios;
  std::set<std::string> planners;
  for (const RunRecord& run : report.runs) {
    scenarios.insert(run.scenario);
    planners.insert(run.planner);
  }
  ContactSheet sheet;
  std::vector<Scenario> drawn;
  drawn.reserve(scenarios.size());
  for (const std::size_t index : scenarios) {
    const RunRecord* const best = best_run(report, index);
    const Scenario& scenario =
        drawn.emplace_back(scenario_at(report.scenarios[index], best == nullptr ? 0 : best->goal));
    Drawing drawing{.scenario = &scenario, .caption = printable(scenario.name + ": no path")};
    if (best != nullptr) {
      drawing.path = &*best->result.path;
      std::string caption = fmt::format("{}: {:.1f} m", scenario.name, final_cost(*best));
      if (planners.size() > 1) caption += ", " + best->planner;
      drawing.caption = printable(caption);
    }
    sheet.drawings.push_back(std::move(drawing));
  }
  const double side = std::ceil(std::sqrt(static_cast<double>(scenarios.size())));
  sheet.columns = std::clamp(static_cast<int>(side), 3, 6);
  return draw(sheet, PictureFormat::png, cell_width * sheet.columns);
}

}  // namespace vandplan::evaluation
