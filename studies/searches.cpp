// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/searches.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "embedded_scenarios.h"
#include "vandplan/files.h"
#include "vandplan/steering.h"

namespace vandplan::studies {
namespace {

// Shades of a search from its begin to its end: dark to light, also on grey paper (plasma of
// matplotlib without its lightest part).
constexpr std::array shades = {"#0d0887", "#46039f", "#7201a8", "#9c179e", "#bd3786",
                               "#d8576b", "#ed7953", "#fb9f3a", "#fdca26"};
// Largest number of points of one search, besides ends of segments.
constexpr double most_points = 15'000;
constexpr double least_step = 1.5;  // least distance between points of an edge [m]
constexpr double room = 20.0;  // margin around obstacles that is shown, where samples are drawn [m]

bool is_of_family(const Planner& planner) {
  return std::ranges::count(planner.properties.groups, "family") > 0;
}

Bounds shown(const SearchesStudy& study, std::size_t scenario) {
  std::vector<Point> points;
  const Scenario& scene = study.scenarios[scenario].scenario;
  for (const Polygon& polygon : scene.obstacles) {
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  for (const Pose& pose : {scene.start, scene.goal}) points.push_back({pose.x, pose.y});
  const Bounds box = bounding_box(points);
  return {box.x_min - room, box.x_max + room, box.y_min - room, box.y_max + room};
}

/// Edge of a tree. It is the shortest path, or so short that the shortest path is similar.
Path edge_of(const TreeSnapshot& tree, std::size_t node, double radius) {
  const Pose& from = tree.poses[static_cast<std::size_t>(tree.parents[node])];
  const Piece piece = reeds_shepp(from, tree.poses[node], radius);
  return {from, {piece.view().begin(), piece.view().end()}};
}

/// CSV of the edges in their order, grouped by shade. A blank line ends an edge, two end a shade,
/// as gnuplot expects.
std::string tree_csv(const TreeSnapshot& tree, double radius) {
  const std::size_t nodes = tree.poses.size();
  double metres = 0.0;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (tree.parents[i] >= 0) metres += length(edge_of(tree, i, radius));
  }
  const double step = std::max(least_step, metres / most_points);
  std::string csv = "shade,x,y\n";
  std::size_t shade = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (tree.parents[i] < 0) continue;
    for (; shade < i * shades.size() / nodes; ++shade) csv += "\n\n";
    for (const auto& [s, pose, curvature, direction] : sampled(edge_of(tree, i, radius), step)) {
      csv += fmt::format("{},{:.2f},{:.2f}\n", shade, pose.x, pose.y);
    }
    csv += "\n";
  }
  return csv;
}

std::string tree_file(const SearchesStudy& study, const Searched& run) {
  return fmt::format("searches_{}_{}.csv", study.scenarios[run.scenario].name, run.planner);
}

/// Labels of a panel: the result, and in a planner's first panel its name.
std::string words_of(const Searched& run) {
  const PlanResult& result = run.result;
  const std::string found =
      result.path ? fmt::format("{:.1f} m", length(*result.path)) : std::string("no path");
  std::string text = fmt::format("set label '{}{}' at graph 0.02,0.05 left front boxed\n", found,
                                 result.tree ? "" : " (no tree)");
  if (run.scenario == 0) {
    text += fmt::format("set label '{}' at graph 0,1.06 left font ',13'\n", run.planner);
  }
  return text;
}

/// Commands that draw obstacles, start and goal of a scenario.
std::string scenery(const Scenario& scenario) {
  std::string text = "unset object\nunset arrow\nunset label\n";
  for (const Polygon& polygon : scenario.obstacles) {
    text += "set object polygon from ";
    for (const Point& corner : polygon) text += fmt::format("{},{} to ", corner.x, corner.y);
    text += fmt::format("{},{} fillstyle solid noborder fillcolor rgb '#59616e' front\n",
                        polygon.front().x, polygon.front().y);
  }
  return text + arrow_at(scenario.start, 7.0, study_colour::green) +
         arrow_at(scenario.goal, 7.0, study_colour::blue);
}

/// Place of a panel on the page [pixels from the page's upper left corner].
struct Panel {
  double left, top, width, height;
};

std::string plot_of(const SearchesStudy& study, std::size_t number, const Panel& panel,
                    double page_width, double page_height) {
  const Searched& run = study.runs[number];
  const Bounds box = shown(study, run.scenario);
  std::string text = scenery(study.scenarios[run.scenario].scenario);
  text += fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
      "set xrange [{}:{}]\nset yrange [{}:{}]\n{}plot ",
      panel.left / page_width, (panel.left + panel.width) / page_width, 1 - panel.top / page_height,
      1 - (panel.top + panel.height) / page_height, box.x_min, box.x_max, box.y_min, box.y_max,
      words_of(run));
  if (run.result.tree) {
    for (std::size_t shade = 0; shade < shades.size(); ++shade) {
      text += fmt::format(
          "'{}' skip 1 index {} using 2:3 with lines linewidth 0.6 linecolor rgb '{}' notitle, \\\n"
          "  ",
          tree_file(study, run), shade, shades[shade]);
    }
  }
  if (!run.result.path) return text + "NaN notitle\n";
  const auto scenario = static_cast<int>(run.scenario);
  return text + plot_of_path("searches.csv", static_cast<int>(number), scenario, "#000000") + "\n";
}

/// Commands that draw the legend: a row of boxes with the shades, below all panels.
std::string legend(double page_width, double page_height) {
  std::string text = "unset object\nunset arrow\nunset label\nunset border\n";
  const double size = 26.0;
  const double top = page_height - 30.0;
  double x = 190.0;
  const auto word = [&](double at, const char* align, const std::string& words) {
    text += fmt::format("set label '{}' at screen {:.5f},{:.5f} {}\n", words, at / page_width,
                        1 - (top + 7) / page_height, align);
  };
  word(x - 10, "right", "looked at first");
  for (const char* shade : shades) {
    text += fmt::format(
        "set object rectangle from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} fillstyle solid "
        "noborder fillcolor rgb '{}'\n",
        x / page_width, 1 - top / page_height, (x + size) / page_width,
        1 - (top + 14) / page_height, shade);
    x += size;
  }
  word(x + 10, "left",
       "last          black: the path, dashed in reverse          green: start, blue: goal");
  return text +
         "set lmargin at screen 0\nset rmargin at screen 1\nset tmargin at screen 1\n"
         "set bmargin at screen 0\nset xrange [0:1]\nset yrange [0:1]\nplot 2 notitle\n";
}

}  // namespace

std::vector<SearchedScenario> searched_scenarios() {
  std::vector<SearchedScenario> all;
  for (const auto& [name, text] : embedded_scenarios) {
    const std::string words(name);
    all.push_back({words, scenario_from_yaml(std::string(text), words).scenario});
  }
  return all;
}

std::vector<Planner> searching_planners() {
  std::vector<Planner> all;
  std::ranges::copy_if(planners(), std::back_inserter(all), is_of_family);
  for (const char* name : {"rrt-opt-hlut-4", "anytime"}) all.push_back(planner_named(name));
  return all;
}

SearchesStudy study_searches(const SearchesOptions& options) {
  SearchesStudy study{options, searched_scenarios()};
  for (const Planner& planner : searching_planners()) {
    PlanOptions wanted{.cost = shortest_style};
    wanted.budget.max_iterations = options.iterations;
    wanted.budget.seed = options.seed;
    for (const auto& [name, value] : {std::pair{"region", "scene"}, {"keep_tree", "true"}}) {
      if (honours(planner, name)) set_option(wanted, planner, name, value);
    }
    for (std::size_t i = 0; i < study.scenarios.size(); ++i) {
      const Problem problem = make_problem(study.scenarios[i].scenario);
      study.runs.push_back({i, planner.name, plan(problem, planner, wanted)});
    }
  }
  return study;
}

StudyFiles files_of(const SearchesStudy& study) {
  std::vector<TextFile> data = {{"searches.csv", "run,scenario,x,y,heading,direction\n"}};
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const Searched& run = study.runs[i];
    if (run.result.path) {
      append_path(data[0].content, fmt::format("{},{}", i, run.scenario), *run.result.path);
    }
    if (!run.result.tree) continue;
    const double radius = study.scenarios[run.scenario].scenario.vehicle.min_turning_radius;
    data.push_back({tree_file(study, run), tree_csv(*run.result.tree, radius)});
  }
  // All panels have the same height. Their width follows from the scenario. A row has two planners.
  constexpr double height = 250.0;
  constexpr double gap = 14.0;
  constexpr double head = 26.0;  // height of a title [pixels]
  std::vector<double> left;
  double width = gap;
  for (std::size_t i = 0; i < 2 * study.scenarios.size(); ++i) {
    const Bounds box = shown(study, i % study.scenarios.size());
    left.push_back(width);
    width += height * (box.x_max - box.x_min) / (box.y_max - box.y_min) + gap;
  }
  const std::size_t columns = left.size();
  const std::size_t rows = (study.runs.size() + columns - 1) / columns;
  const double page_height = 40.0 + static_cast<double>(rows) * (height + head + gap) + 40.0;
  std::string body = fmt::format(
      "set multiplot title 'How planners search: {} iterations each, seed {}' font ',14'\n"
      "set style textbox opaque noborder\nunset key\nunset tics\nunset grid\nset border 31 "
      "linecolor rgb '#c9ced6'\n",
      study.options.iterations, study.options.seed);
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const std::size_t column = i % columns;
    const std::size_t row = i / columns;
    const double right = column + 1 < columns ? left[column + 1] : width;
    const Panel panel{left[column], 40.0 + static_cast<double>(row) * (height + head + gap) + head,
                      right - gap - left[column], height};
    body += plot_of(study, i, panel, width, page_height);
  }
  body += legend(width, page_height) + "unset multiplot\n";
  return study_files({"searches", static_cast<int>(width), static_cast<int>(page_height)},
                     std::move(data), body);
}

}  // namespace vandplan::studies
