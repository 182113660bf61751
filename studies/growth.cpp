// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "studies/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "vandplan/random.h"

namespace vandplan::studies {
namespace {

double distance(const Pose& a, const Pose& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Nodes in square cells over the region; nodes outside are in the cells at its edge.
class NodeGrid {
 public:
  NodeGrid(double reach, double cell)
      : reach_(reach),
        cell_(cell),
        count_(std::max(1, static_cast<int>(std::ceil(2 * reach / cell)))),
        cells_(static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_)) {}

  void add(const std::vector<Pose>& poses, std::size_t node) {
    cells_[at(index(poses[node].x), index(poses[node].y))].push_back(node);
  }

  /// Nearest node to a sample of the region; ties go to the older node.
  std::size_t nearest(const std::vector<Pose>& poses, const Pose& sample) const {
    const int x = index(sample.x);
    const int y = index(sample.y);
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    // Nodes in a ring are at least ring - 1 cells away.
    for (int ring = 0; ring < count_ && (ring - 1) * cell_ <= least; ++ring) {
      for_ring(x, y, ring, [&](std::size_t node) {
        const double length = distance(poses[node], sample);
        if (length > least || (length == least && node > best)) return;
        least = length;
        best = node;
      });
    }
    return best;
  }

 private:
  int index(double coordinate) const {
    return std::clamp(static_cast<int>(std::floor((coordinate + reach_) / cell_)), 0, count_ - 1);
  }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(count_) +
           static_cast<std::size_t>(y);
  }

  template <class Visit>
  void for_ring(int x, int y, int ring, Visit visit) const {
    const int last = count_ - 1;
    for (int i = std::max(0, x - ring); i <= std::min(last, x + ring); ++i) {
      const bool edge = i == x - ring || i == x + ring;
      for (int j = y - ring; j <= y + ring; j += edge ? 1 : 2 * ring) {
        if (j < 0 || j > last) continue;
        for (const std::size_t node : cells_[at(i, j)]) visit(node);
      }
    }
  }

  double reach_;
  double cell_;
  int count_;
  std::vector<std::vector<std::size_t>> cells_;
};

// SelectInput and NewState: end of the input, among six (left, straight, right; forward, reverse),
// that ends nearest to the sample.
Pose driven_towards(const Pose& from, const Pose& sample, const GrowthOptions& options) {
  Pose best = from;
  double least = std::numeric_limits<double>::infinity();
  for (const double gear : {1.0, -1.0}) {
    for (const double side : {0.0, 1.0, -1.0}) {
      const Pose end = advance(from, {side / options.turning_radius, gear * options.step});
      const double left = distance(end, sample);
      if (left >= least) continue;
      least = left;
      best = end;
    }
  }
  return best;
}

GrowthStage stage_of(const GrowthStudy& study, std::size_t nodes) {
  constexpr double square = 10.0;  // side of a square [m]
  const double reach = study.options.reach;
  std::set<std::pair<int, int>> held;
  std::vector<int> depth(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    const Pose& pose = study.tree.poses[i];
    if (i > 0) depth[i] = depth[static_cast<std::size_t>(study.tree.parents[i])] + 1;
    if (std::max(std::abs(pose.x), std::abs(pose.y)) >= reach) continue;
    held.emplace(static_cast<int>(std::floor((pose.x + reach) / square)),
                 static_cast<int>(std::floor((pose.y + reach) / square)));
  }
  const double across = std::ceil(2 * reach / square);
  return {nodes, static_cast<double>(held.size()) / (across * across),
          *std::ranges::max_element(depth)};
}

std::string tree_csv(const TreeSnapshot& tree) {
  std::string csv = "node,parent,x,y,heading,parent_x,parent_y\n";
  for (std::size_t i = 1; i < tree.poses.size(); ++i) {
    const Pose& pose = tree.poses[i];
    const Pose& parent = tree.poses[static_cast<std::size_t>(tree.parents[i])];
    csv += fmt::format("{},{},{:.3f},{:.3f},{:.4f},{:.3f},{:.3f}\n", i, tree.parents[i], pose.x,
                       pose.y, pose.heading, parent.x, parent.y);
  }
  return csv;
}

}  // namespace

// Algorithm 1 of Guo 2020, after LaValle 1998.
//
//   [1] tree := {(0, 0, 0)}
//   until it has as many nodes as asked for:
//   [2]   sample := a random position
//   [3]   near := the node nearest to it
//   [4]   input := of the six, the one that drives from near closest to the sample
//   [5]   add where it ends, with near as its parent
TreeSnapshot grow_tree(const GrowthOptions& options, std::size_t nodes) {
  const double reach = options.reach;
  Rng rng(options.seed);
  TreeSnapshot tree{{Pose{}}, {-1}};  // [1]
  NodeGrid grid(reach, std::max(options.step, reach / 100));
  grid.add(tree.poses, 0);
  while (tree.poses.size() < nodes) {
    const Pose sample = uniform_pose({-reach, reach, -reach, reach}, rng);    // [2]
    const std::size_t near = grid.nearest(tree.poses, sample);                // [3]
    tree.poses.push_back(driven_towards(tree.poses[near], sample, options));  // [4]
    tree.parents.push_back(static_cast<std::int32_t>(near));                  // [5]
    grid.add(tree.poses, tree.poses.size() - 1);
  }
  return tree;
}

GrowthStudy study_growth(const GrowthOptions& options) {
  GrowthStudy study{options, grow_tree(options, growth_stages.back()), {}};
  for (const std::size_t nodes : growth_stages) study.stages.push_back(stage_of(study, nodes));
  return study;
}

StudyFiles files_of(const GrowthStudy& study) {
  std::string panels;
  for (const GrowthStage& stage : study.stages) {
    panels += fmt::format(
        "set title '{} nodes, {:.0f} % explored'\n"
        "plot 'growth.csv' skip 1 every ::0::{} using 6:7:($3-$6):($4-$7) with vectors nohead "
        "linewidth {} linecolor rgb '{}' notitle, \\\n"
        "  '+' using (0):(0) every ::0::0 with points pointtype 7 pointsize 0.7 linecolor rgb "
        "'{}' notitle\n",
        stage.nodes, 100 * stage.explored, stage.nodes - 2, stage.nodes > 20'000 ? 0.3 : 0.7,
        study_colour::blue, study_colour::orange);
  }
  const double shown = study.options.reach * 1.05;
  const std::string body = fmt::format(
      "set multiplot layout 2,3 title 'One random tree from (0, 0) at six ages: steps of {} m, "
      "turning radius {} m, seed {} "
      "(explored: squares of 10 m that hold a node)' font ',13'\n"
      "set size ratio -1\n"
      "set xrange [-{}:{}]\n"
      "set yrange [-{}:{}]\n"
      "set xlabel 'x [m]'\n"
      "set ylabel 'y [m]'\n"
      "{}"
      "unset multiplot\n",
      study.options.step, study.options.turning_radius, study.options.seed, shown, shown, shown,
      shown, panels);
  return study_files({"growth", 1350, 980}, {{"growth.csv", tree_csv(study.tree)}}, body);
}

}  // namespace vandplan::studies
