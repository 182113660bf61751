// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I write a planner of my own, judged and compared like those of the library?
// usage: 07_own_planner [FOLDER]    for the report

#include <vandplan/evaluation.h>
#include <vandplan/planner.h>
#include <vandplan/search.h>
#include <vandplan/tables.h>

#include <cstdio>
#include <random>
#include <vector>

namespace {

using namespace vandplan;

/// Grows a tree of random poses, each joined to its nearest node, until the goal is reached.
PlannerAnswer grow(const Task& task, const PlanOptions& options) {
  search::Budget budget(options.budget);
  search::Connector connector(task);
  search::Tree tree(task.start, 1000);
  NearestNodes nodes(connector.radius());
  nodes.add(task.start);
  const Bounds& area = task.world->local().bounds;
  std::mt19937_64 random(options.budget.seed);
  const auto between = [&](double low, double high) {  // gives the same numbers everywhere
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  PlannerAnswer answer;
  while (budget.next()) {
    const bool is_goal = between(0, 1) < options.planner.number("goal_share");
    LocalPose sample = task.goal;
    if (!is_goal) {
      sample = LocalPose(
          {between(area.x_min, area.x_max), between(area.y_min, area.y_max), between(-3.14, 3.14)});
    }
    const search::NodeId nearest = nodes.nearest(sample)->node;
    const auto edge = connector.connect(tree.pose(nearest), sample);  // steered, priced, checked
    if (!edge) continue;
    const search::NodeId node = tree.add(sample, nearest, tree.cost_to_come(nearest) + edge->cost);
    nodes.add(sample);
    if (!is_goal) continue;
    answer.anytime = {{budget.elapsed(), budget.iterations(), tree.cost_to_come(node)}};
    answer.segments.emplace();
    const std::vector<LocalPose> poses = tree.branch(node);
    for (std::size_t i = 1; i < poses.size(); ++i) {
      const Piece piece = *connector.steer(poses[i - 1], poses[i]);
      answer.segments->insert(answer.segments->end(), piece.view().begin(), piece.view().end());
    }
    break;
  }
  answer.status = answer.segments ? PlanStatus::solved : budget.reason();
  answer.iterations = budget.iterations();
  return answer;
}

const Planner mine{.name = "mine",
                   .summary = "a random tree that ends at its first path",
                   .properties = {.family = "tree"},
                   .options = {{.name = "goal_share",
                                .summary = "share of samples that are the goal",
                                .default_value = 0.2,
                                .least = 0,
                                .most = 1}},
                   .function = grow};

}  // namespace

int main(int argc, char** argv) {
  Scenario yard;
  yard.name = "yard";
  yard.bounds = {-50, 50, -50, 50};
  yard.goal = {0, 12, 0};
  yard.obstacles = {{{-20, 5}, {15, 5}, {15, 7}, {-20, 7}}};

  PlanOptions options;
  options.budget.max_iterations = 2000;
  options.planner.set("goal_share", 0.3);
  const PlanResult result = plan(make_problem(yard), mine, options);  // `plan` asks the judge, too
  std::printf("%.2f m, %.2f m of it in reverse\n\n", result.cost,
              result.check ? result.check->reverse_length : 0);

  // Runs both planners with the same seeds, and reports as text and as a page for a browser.
  evaluation::Campaign campaign{
      .planners = {mine, default_planner()}, .regions = {Region::bounds}, .repeats = 4};
  campaign.scenarios.push_back({{.scenario = yard}, "yard.yaml"});
  campaign.settings.push_back({"max_iterations", "2000"});
  const auto comparison = evaluation::compare(campaign, argc > 1 ? argv[1] : "own_planner");
  std::printf("%s\n%s\n", comparison.headline.c_str(), comparison.page.c_str());
  return result.path && comparison.missing == 0 ? 0 : 1;
}
