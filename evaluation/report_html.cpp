// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "evaluation/methods.h"
#include "evaluation/page.h"
#include "evaluation/report.h"
#include "evaluation/report_json.h"
#include "vandplan/draw.h"

namespace vandplan::evaluation {
namespace {

using Json = OrderedJson;

constexpr std::size_t most_listed_runs = 20000;  // a page with more runs is too large to open
constexpr int largest_map_image = 1000;          // largest side of the picture of a map [pixels]

// Rounds all numbers to six digits, more than the page shows.
Json rounded(Json json) {
  if (json.is_structured())
    for (Json& part : json) part = rounded(std::move(part));
  if (!json.is_number_float()) return json;
  const double value = json.get<double>();
  if (!std::isfinite(value)) return nullptr;
  if (value == std::trunc(value) && std::abs(value) < 1e15) return static_cast<std::int64_t>(value);
  return std::stod(fmt::format("{:.6g}", value));
}

Json pose(const Pose& value) { return {value.x, value.y, value.heading}; }

Json polygons(const std::vector<Polygon>& values) {
  Json json = Json::array();
  for (const Polygon& polygon : values) {
    Json corners = Json::array();
    for (const Point& point : polygon) corners.push_back({point.x, point.y});
    json.push_back(std::move(corners));
  }
  return json;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j <= bytes.size() ? digits[group >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

// Picture of a map, and its place.
Json map_json(const OccupancyGrid& map) {
  const MapImage image = map_image(map, largest_map_image);
  return {{"image", "data:image/png;base64," + base64(image.png)},
          {"origin", pose(map.origin)},
          {"size", {image.width, image.height}},
          {"extent", {map.columns * map.resolution, map.rows * map.resolution}}};
}

// List of maps; scenarios with the same cells share one picture.
class MapList {
 public:
  // Index of a map in the list; null without a map.
  Json index_of(const std::optional<OccupancyGrid>& map) {
    if (!map) return nullptr;
    const auto [found, is_new] = indices_.try_emplace(map->cells.get(), list_.size());
    if (is_new) list_.push_back(map_json(*map));
    return found->second;
  }
  const Json& list() const { return list_; }

 private:
  std::map<const void*, std::size_t> indices_;
  Json list_ = Json::array();
};

Json goals_json(const ScenarioFile& scenario) {
  if (!scenario.is_row()) {
    return {{{"pose", pose(scenario.scenario.goal)},
             {"distance", nullptr},
             {"obstacles", Json::array()}}};
  }
  Json goals = Json::array();
  for (const RowGoal& goal : scenario.row) {
    goals.push_back({{"pose", pose(goal.goal)},
                     {"distance", goal.distance},
                     {"obstacles", polygons(goal.obstacles)}});
  }
  return goals;
}

Json scenario_json(const ScenarioFile& whole, const StoredScenario& file, MapList& maps) {
  const Scenario& scenario = whole.scenario;
  const Footprint body = footprint(scenario.vehicle);
  return {{"name", scenario.name},
          {"file", file.file},
          {"description", scenario.description},
          {"row", whole.is_row()},
          {"footprint", {body.rear, body.front, body.half_width}},
          {"start", pose(scenario.start)},
          {"goals", goals_json(whole)},
          {"obstacles", polygons(scenario.obstacles)},
          {"kerbs", polygons(scenario.kerbs)},
          {"map", maps.index_of(scenario.map)}};
}

Json path_json(const RunRecord& run) {
  Json segments = Json::array();
  for (const Segment& segment : run.result.path->segments) {
    Json item = {segment.curvature, segment.length};
    if (segment.curvature_rate != 0.0) item.push_back(segment.curvature_rate);
    segments.push_back(std::move(item));
  }
  return segments;
}

// Runs that the page lists, with their rows. If there are too many, it lists the examples and a
// part of all runs, evenly spread.
class ListedRuns {
 public:
  explicit ListedRuns(const Report& report) {
    const std::size_t step = (report.runs.size() + most_listed_runs - 1) / most_listed_runs;
    for (std::size_t i = 0; i < report.runs.size(); i += step) row_.emplace(i, 0);
    for (const ScenarioSummary& scenario : report.summary.scenarios) {
      for (const MethodSummary& method : scenario.methods) {
        for (const std::optional<std::size_t>& example : {method.best, method.typical})
          if (example) row_.emplace(*example, 0);
      }
    }
    std::size_t next = 0;
    for (auto& [run, row] : row_) row = next++;
  }
  // Row of a run that is listed.
  std::size_t row_of(std::size_t run) const { return row_.at(run); }
  const std::map<std::size_t, std::size_t>& all() const { return row_; }

 private:
  std::map<std::size_t, std::size_t> row_;  // rows by index of the run in the report
};

Json example_json(const Report& report, const ListedRuns& listed,
                  std::optional<std::size_t> index) {
  if (!index) return nullptr;
  return {{"run", listed.row_of(*index)}, {"segments", path_json(report.runs[*index])}};
}

Json curve_json(const std::vector<CurvePoint>& curve) {
  Json cost = Json::array(), solved = Json::array();
  for (const CurvePoint& point : curve) {
    cost.push_back({point.cost.median, point.cost.interval.low, point.cost.interval.high});
    solved.push_back({point.solved, point.solved_interval.low, point.solved_interval.high});
  }
  return {{"cost", cost}, {"solved", solved}};
}

Json method_json(const Report& report, const ListedRuns& listed, const MethodSummary& method) {
  const bool row = !method.goals.empty();
  Json json = json_of(method, row);
  Json goals = Json::array();
  for (const GoalSummary& goal : method.goals)
    goals.push_back({goal.distance, goal.runs, goal.solved, goal.cost});
  json["goals"] = goals;
  json["full"] = method.full;
  json["cost_when_full"] = json_of(method.cost_when_full);
  json["phases"] = nullptr;
  if (method.phases)
    json["phases"] = {method.phases->ranking, method.phases->steering, method.phases->checking};
  json["quantiles"] = method.cost_quantiles;
  json["curve"] = curve_json(method.curve);
  json["best"] = example_json(report, listed, method.best);
  json["typical"] = example_json(report, listed, method.typical);
  return json;
}

// Comparison with its Euclid twin; changes are given as words, too.
Json twin_json(const TwinComparison& twins) {
  Json json = json_of(twins);
  for (const auto& [key, comparison] : {std::pair("cost", &twins.cost),
                                        {"first_solution", &twins.first_time},
                                        {"time", &twins.time_total}}) {
    const auto& [low, high] = comparison->interval;
    json[key]["text"] = change_text(comparison->ratio);
    json[key]["between"] = {change_text(low), change_text(high)};
    json[key]["bounded"] = low > 0.0 || std::isfinite(high);
  }
  return json;
}

Json cells_json(const Report& report, const ListedRuns& listed) {
  Json cells = Json::array();
  for (const ScenarioSummary& scenario : report.summary.scenarios) {
    Json methods = Json::array(), twins = Json::array();
    for (const MethodSummary& method : scenario.methods)
      methods.push_back(method_json(report, listed, method));
    for (const TwinComparison& twin : scenario.twins) twins.push_back(twin_json(twin));
    cells.push_back({{"scenario", scenario.scenario},
                     {"region", name_of(scenario.region)},
                     {"methods", methods},
                     {"twins", twins}});
  }
  return cells;
}

// One short row for each run; the page finds columns by name.
Json runs_json(const Report& report, const ListedRuns& listed) {
  Json rows = Json::array();
  for (const auto& [index, row] : listed.all()) {
    const RunRecord& run = report.runs[index];
    rows.push_back({run.scenario, name_of(run.region), run.goal, run.planner, run.seed,
                    name_of(run.result.status), final_cost(run), first_solution_time(run),
                    run.result.time_total, run.result.iterations, counter(run.result, "nodes"),
                    is_profiled(run), run.result.reason, reproduce_command(report, run)});
  }
  return {{"columns",
           {"scenario", "region", "goal", "planner", "seed", "status", "cost", "first", "total",
            "iterations", "nodes", "profile", "reason", "command"}},
          {"rows", rows}};
}

Json data_of(const Report& report) {
  Json scenarios = Json::array();
  MapList maps;
  const ListedRuns listed(report);
  for (std::size_t i = 0; i < report.scenarios.size(); ++i)
    scenarios.push_back(scenario_json(report.scenarios[i], report.files[i], maps));
  return {{"created", report.runs.back().started},
          {"environment", environment_json(report.environment)},
          {"options", shared_options_json(report.options)},
          {"differing_options", differing_options_json(report.options)},
          {"jobs", report.runs.back().jobs},
          {"left_out", report.left_out},
          {"overhead", harness_json(report.sessions)},
          {"planners", planners_json(report.planners)},
          {"scenarios", scenarios},
          {"maps", maps.list()},
          {"times", report.summary.times},
          {"cells", cells_json(report, listed)},
          {"claims", claims_json(report.findings)},
          {"verdicts", verdicts_json(report.findings)},
          {"rejected", rejected_json(report.runs)},
          {"pooled", pooled_json(report.summary)},
          {"searches", search_matrix_json(report)},
          {"literature", literature_json(report)},
          {"headlines", headlines_json(report)},
          {"all_runs", report.runs.size()},
          {"runs", runs_json(report, listed)}};
}

// The program of the page. Its parts share one scope, which nothing else on the page can see.
std::string program() {
  std::string text = "(function () {\n'use strict';\n";
  for (const std::string_view part :
       {page::js_data, page::js_methods, page::js_tables, page::js_overview, page::js_searches,
        page::js_scenario, page::js_charts, page::js_motion, page::js_pictures, page::js_runs,
        page::js_frame, page::js_page})
    text += part;
  return text + "})();\n";
}

// Replaces a mark by `value`.
void fill(std::string& page, std::string_view mark, std::string_view value) {
  page.replace(page.find(mark), mark.size(), value);
}

}  // namespace

std::string report_html(const Report& report, std::string_view gallery) {
  const std::string image =
      "<img alt=\"The best path in every scenario\" src=\"data:image/png;base64," +
      base64(gallery) + "\">";
  std::string data;
  for (const char character : rounded(data_of(report)).dump())
    data += character == '<' ? std::string("\\u003c") : std::string(1, character);
  std::string page(page::html);
  fill(page, "/*STYLE*/", page::css);
  fill(page, "<!--LICENCE-->", page::d3_licence);
  fill(page, "/*D3*/", page::d3);
  fill(page, "/*PROGRAM*/", program());
  fill(page, "<!--SHEET-->", image);
  fill(page, "/*DATA*/", data);  // last, because it may contain any text
  return page;
}

}  // namespace vandplan::evaluation
