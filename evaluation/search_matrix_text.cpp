// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/escape.h"
#include "evaluation/findings.h"
#include "evaluation/methods.h"
#include "evaluation/report_json.h"
#include "evaluation/search_matrix.h"
#include "evaluation/text_table.h"

namespace vandplan::evaluation {
namespace {

std::string number_text(double value, int digits) {
  return std::isinf(value) ? "-" : fmt::format("{:.{}f}", value, digits);
}

std::string between(const MedianEstimate& estimate, double unit, int digits) {
  const auto& [median, interval] = estimate;
  std::string text = number_text(median * unit, digits);
  if (std::isinf(median) || std::isinf(interval.low)) return text;
  const std::string high =
      std::isinf(interval.high) ? "..." : number_text(interval.high * unit, digits);
  return fmt::format("{} [{}, {}]", text, number_text(interval.low * unit, digits), high);
}

// Contents of one table: a title and the text of a cell.
struct Measure {
  const char* title;
  std::string (*text)(const MatrixCell&);
};

constexpr std::array measures = {
    Measure{"Runs solved, with the interval of the share",
            [](const MatrixCell& cell) {
              const auto& [low, high] = cell.solved_interval;
              return fmt::format("{}/{} [{:.0f}, {:.0f} %]", cell.solved, cell.runs, 100 * low,
                                 100 * high);
            }},
    Measure{"Time to the first path [ms]",
            [](const MatrixCell& cell) { return between(cell.first_time, 1e3, 2); }},
    Measure{"Iterations (expansions or samples) to the first path",
            [](const MatrixCell& cell) { return between(cell.first_work, 1.0, 0); }},
    Measure{"Cost at 10 ms over the least one found",
            [](const MatrixCell& cell) { return between(cell.cost_at_10ms, 1.0, 3); }},
    Measure{"Cost at 100 ms over the least one found",
            [](const MatrixCell& cell) { return between(cell.cost_at_100ms, 1.0, 3); }},
    Measure{"Cost at 1 s over the least one found",
            [](const MatrixCell& cell) { return between(cell.cost_at_1s, 1.0, 3); }}};

template <typename Name>
std::vector<std::string> distinct(const std::vector<MatrixCell>& cells, Name name) {
  std::vector<std::string> found;
  for (const MatrixCell& cell : cells) {
    if (std::ranges::find(found, cell.*name) == found.end()) found.push_back(cell.*name);
  }
  return found;
}

// Table of a measure: estimates down, searches across.
std::string table_of(const std::vector<MatrixCell>& cells, const Measure& measure) {
  const std::vector<std::string> searches = distinct(cells, &MatrixCell::search);
  std::vector<std::string> head = {"estimate"};
  for (const std::string& search : searches) head.push_back(base::markdown(search));
  TextTable table(head);
  for (const std::string& estimate : distinct(cells, &MatrixCell::estimate)) {
    std::vector<std::string> line = {base::markdown(estimate)};
    for (const std::string& search : searches) {
      const auto found = std::ranges::find_if(cells, [&](const MatrixCell& cell) {
        return cell.search == search && cell.estimate == estimate;
      });
      line.push_back(found == cells.end() ? "" : measure.text(*found));
    }
    table.add(std::move(line));
  }
  return table.markdown();
}

std::string ratio_text(const PairedComparison& compared) {
  const auto& [low, high] = compared.interval;
  std::string text = number_text(compared.ratio, 3);
  if (low == 0.0 && std::isinf(high)) return text;
  return fmt::format("{} [{}, {}]", text, number_text(low, 3),
                     std::isinf(high) ? "..." : number_text(high, 3));
}

OrderedJson json_of_ratio(const PairedComparison& compared) {
  return {{"pairs", compared.pairs},
          {"ratio", finite_json(compared.ratio)},
          {"interval", {finite_json(compared.interval.low), finite_json(compared.interval.high)}}};
}

}  // namespace

std::string search_matrix_markdown(const Report& report) {
  std::string text;
  for (const Region region : {Region::bounds, Region::scene}) {
    const std::vector<MatrixCell> cells = search_matrix(report.planners, report.runs, region);
    if (cells.empty()) continue;
    text += fmt::format(
        "\n## Every estimate in every search, samples from the {}\n\nMedians over all runs of all "
        "scenarios, an unsolved run counting as infinite, with intervals.\n",
        name_of(region));
    for (const Measure& measure : measures)
      text += fmt::format("\n{}:\n\n{}", measure.title, table_of(cells, measure));
  }
  const std::vector<LiteratureFinding> found = literature_findings(report.planners, report.runs);
  if (found.empty()) return text;
  text += "\n## What the literature says of searches and estimates\n\n";
  TextTable table({"claim", "pairs", "first path, time over its rival's", "iterations to it",
                   "cost at the end", "solved"});
  for (const LiteratureFinding& finding : found) {
    table.add({base::markdown(fmt::format("{}: {} against {}, {}", finding.claim, finding.planner,
                                          finding.rival, name_of(finding.region))),
               std::to_string(finding.cost.pairs), ratio_text(finding.first_time),
               ratio_text(finding.first_work), ratio_text(finding.cost),
               fmt::format("{} against {}", finding.solved, finding.rival_solved)});
  }
  return text + table.markdown() +
         "\nMedian ratios over pairs of runs to the same goal with the same seed; below 1 the "
         "first "
         "one is better.\n";
}

OrderedJson search_matrix_json(const Report& report) {
  OrderedJson json = OrderedJson::array();
  for (const Region region : {Region::bounds, Region::scene}) {
    for (const MatrixCell& cell : search_matrix(report.planners, report.runs, region)) {
      json.push_back({{"region", name_of(region)},
                      {"planner", cell.planner},
                      {"search", cell.search},
                      {"estimate", cell.estimate},
                      {"runs", cell.runs},
                      {"solved", cell.solved},
                      {"first_solution", json_of(cell.first_time)},
                      {"first_iterations", json_of(cell.first_work)},
                      {"cost_ratio_at_10ms", json_of(cell.cost_at_10ms)},
                      {"cost_ratio_at_100ms", json_of(cell.cost_at_100ms)},
                      {"cost_ratio_at_1s", json_of(cell.cost_at_1s)}});
    }
  }
  return json;
}

OrderedJson literature_json(const Report& report) {
  OrderedJson json = OrderedJson::array();
  for (const LiteratureFinding& finding : literature_findings(report.planners, report.runs)) {
    json.push_back({{"region", name_of(finding.region)},
                    {"claim", finding.claim},
                    {"planner", finding.planner},
                    {"rival", finding.rival},
                    {"first_solution", json_of_ratio(finding.first_time)},
                    {"first_iterations", json_of_ratio(finding.first_work)},
                    {"cost", json_of_ratio(finding.cost)},
                    {"solved", finding.solved},
                    {"rival_solved", finding.rival_solved}});
  }
  return json;
}

}  // namespace vandplan::evaluation
