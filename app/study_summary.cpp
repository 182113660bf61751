// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "study_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/escape.h"

namespace vandplan::app {
namespace {

using Json = nlohmann::ordered_json;

Json pose_json(const Pose& pose) {
  return {{"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}};
}

Json detour_json(const Detour& detour) {
  return {{"mean", detour.mean}, {"largest", detour.largest}};
}

Json spread_json(const Spread& spread) {
  Json json = {{"least", spread.least}, {"largest", spread.largest}, {"mean", spread.mean}};
  for (std::size_t i = 0; i < percents.size(); ++i) {
    json[fmt::format("p{}", percents[i])] = spread.percentiles[i];
  }
  return json;
}

double percentile_of(const Spread& spread, int percent) {
  const auto at = std::find(percents.begin(), percents.end(), percent);
  return spread.percentiles[static_cast<std::size_t>(at - percents.begin())];
}

}  // namespace

// ---- range ----

std::string summary_of(const RangeStudy& study) {
  std::string text = fmt::format(
      "Detour beyond the straight line [m], turning radius {} m, seed {}\n"
      "  distance    Dubins mean   largest    Reeds-Shepp mean   largest\n",
      study.options.turning_radius, study.options.seed);
  for (const int i : {0, 1, 2, 5, 10, 15, 20, 30, 40, 50}) {
    const auto& [distance, dubins, reeds_shepp] = study.rings[static_cast<std::size_t>(i)];
    text += fmt::format("  {:6.4g} m {:14.2f} {:9.2f} {:19.2f} {:9.2f}\n", distance, dubins.mean,
                        dubins.largest, reeds_shepp.mean, reeds_shepp.largest);
  }
  return text;
}

Json json_of(const RangeStudy& study) {
  Json rings = Json::array();
  for (const auto& [distance, dubins, reeds_shepp] : study.rings) {
    rings.push_back({{"distance", distance},
                     {"dubins", detour_json(dubins)},
                     {"reeds_shepp", detour_json(reeds_shepp)}});
  }
  return {{"turning_radius", study.options.turning_radius},
          {"reach", study.options.reach},
          {"pairs", study.pairs.size()},
          {"seed", study.options.seed},
          {"pairs_per_ring", pairs_of_a_ring},
          {"rings", rings}};
}

// ---- accuracy ----

std::string summary_of(const AccuracyStudy& study) {
  const AccuracyOptions& options = study.options;
  std::string text = fmt::format(
      "Estimate - length over {} random pairs, |x| and |y| below {} m, turning radius {} m, seed "
      "{}\n"
      "  {:<22} within 10 %  too long   mean     5 %  median    95 %     5 % [m]  95 % [m]  worst "
      "[m]\n",
      options.pairs, options.reach, options.turning_radius, options.seed, "estimate");
  for (const Accuracy& estimate : study.estimates) {
    const auto& [least, largest, mean, percentiles] = estimate.metres;
    text += fmt::format(
        "  {:<22} {:9.1f} % {:7.1f} % {:6.3f} {:7.3f} {:7.3f} {:7.3f} {:11.2f} {:9.2f} {:10.2f}\n",
        base::printable(estimate.name), 100 * estimate.within_a_tenth, 100 * estimate.over,
        estimate.relative.mean, percentile_of(estimate.relative, 5),
        percentile_of(estimate.relative, 50), percentile_of(estimate.relative, 95),
        percentile_of(estimate.metres, 5), percentile_of(estimate.metres, 95),
        -least > largest ? least : largest);
  }
  return text;
}

Json json_of(const AccuracyStudy& study) {
  Json estimates = Json::array();
  for (const Accuracy& estimate : study.estimates) {
    estimates.push_back({{"estimate", estimate.name},
                         {"within_10_percent", estimate.within_a_tenth},
                         {"over_estimates", estimate.over},
                         {"relative", spread_json(estimate.relative)},
                         {"metres", spread_json(estimate.metres)}});
  }
  return {{"pairs", study.options.pairs},
          {"reach", study.options.reach},
          {"turning_radius", study.options.turning_radius},
          {"seed", study.options.seed},
          {"estimates", estimates}};
}

// ---- growth ----

std::string summary_of(const GrowthStudy& study) {
  std::string text = fmt::format(
      "A tree from (0, 0) in a square of +-{} m, steps of {} m, turning radius {} m, seed {}\n"
      "  nodes          10 m squares with a node   depth\n",
      study.options.reach, study.options.step, study.options.turning_radius, study.options.seed);
  for (const auto& [nodes, explored, depth] : study.stages) {
    text += fmt::format("  {:<9} {:27.1f} % {:7}\n", nodes, 100 * explored, depth);
  }
  return text;
}

Json json_of(const GrowthStudy& study) {
  Json stages = Json::array();
  for (const auto& [nodes, explored, depth] : study.stages) {
    stages.push_back({{"nodes", nodes}, {"explored", explored}, {"depth", depth}});
  }
  return {{"reach", study.options.reach},
          {"step", study.options.step},
          {"turning_radius", study.options.turning_radius},
          {"seed", study.options.seed},
          {"stages", stages}};
}

// ---- symmetry ----

std::string summary_of(const SymmetryStudy& study) {
  std::string text;
  for (const auto& [images, lengths] : study.examples) {
    for (std::size_t i = 0; i < images.size(); ++i) {
      const auto& [node, sample_heading] = images[i];
      text += fmt::format("  from ({:5.1f}, {:5.1f}, {:7.4f}) to (0, 0, {:7.4f}): {:.12f} m\n",
                          node.x, node.y, node.heading, sample_heading, lengths[i]);
    }
    text += "\n";
  }
  return "Mirrored pairs of poses [m, rad]\n" + text +
         fmt::format(
             "{} random pairs, seed {}: mirror images differ in length by at most {:.2g} m\n",
             study.options.pairs, study.options.seed, study.worst_difference);
}

Json json_of(const SymmetryStudy& study) {
  Json examples = Json::array();
  for (const auto& [images, lengths] : study.examples) {
    Json pairs = Json::array();
    for (std::size_t i = 0; i < images.size(); ++i) {
      pairs.push_back({{"node", pose_json(images[i].node)},
                       {"sample", pose_json(Pose{0.0, 0.0, images[i].sample_heading})},
                       {"length", lengths[i]}});
    }
    examples.push_back(pairs);
  }
  return {{"turning_radius", study.options.turning_radius},
          {"examples", examples},
          {"pairs", study.options.pairs},
          {"seed", study.options.seed},
          {"worst_difference", study.worst_difference}};
}

// ---- steering ----

std::string summary_of(const SteeringStudy& study) {
  std::string text = fmt::format(
      "Shortest paths from (0, 0, 0), turning radius {} m\n"
      "  goal               x [m]   y [m]  heading   Euclid [m]   Dubins [m]            "
      "Reeds-Shepp "
      "[m]\n",
      study.options.turning_radius);
  for (const auto& [name, goal, dubins, reeds_shepp] : study.examples) {
    text +=
        fmt::format("  {:<17} {:6.1f} {:7.1f} {:8.4f} {:12.2f} {:8.2f}  {:<12} {:8.2f}  {}\n", name,
                    goal.x, goal.y, goal.heading, std::hypot(goal.x, goal.y), dubins.length,
                    word_of(dubins.view()), reeds_shepp.length, word_of(reeds_shepp.view()));
  }
  return text;
}

Json json_of(const SteeringStudy& study) {
  Json examples = Json::array();
  for (const auto& [name, goal, dubins, reeds_shepp] : study.examples) {
    const auto steered = [](const Piece& piece) {
      return Json{{"length", piece.length}, {"word", word_of(piece.view())}};
    };
    examples.push_back({{"name", name},
                        {"goal", pose_json(goal)},
                        {"euclid", std::hypot(goal.x, goal.y)},
                        {"dubins", steered(dubins)},
                        {"reeds_shepp", steered(reeds_shepp)}});
  }
  return {{"turning_radius", study.options.turning_radius}, {"examples", examples}};
}

// ---- searches ----

std::string summary_of(const SearchesStudy& study) {
  std::string text = fmt::format(
      "How planners search, {} iterations each, seed {}\n"
      "  planner            scenario            length [m]    first path   poses\n",
      study.options.iterations, study.options.seed);
  for (const auto& [scenario, planner, result] : study.runs) {
    text += fmt::format("  {:<18} {:<18}", planner, study.scenarios[scenario].name);
    text += result.path ? fmt::format(" {:11.2f} {:13}", result.cost, result.anytime[0].iteration)
                        : fmt::format(" {:>11} {:>13}", "none", "never");
    text += result.tree ? fmt::format(" {:7}\n", result.tree->poses.size()) : "       -\n";
  }
  return text;
}

Json json_of(const SearchesStudy& study) {
  Json runs = Json::array();
  for (const auto& [scenario, planner, result] : study.runs) {
    Json run = {{"planner", planner},
                {"scenario", study.scenarios[scenario].name},
                {"status", name_of(result.status)},
                {"iterations", result.iterations}};
    if (result.path) run["length"] = result.cost;
    if (result.tree) run["poses"] = result.tree->poses.size();
    runs.push_back(run);
  }
  return {{"iterations", study.options.iterations}, {"seed", study.options.seed}, {"runs", runs}};
}

}  // namespace vandplan::app
