// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/site_table.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "base/parallel.h"
#include "search/open_ground.h"
#include "search/route.h"
#include "sites/data.h"
#include "sites/proofs.h"
#include "sites/site.h"
#include "sites/way.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"

namespace vandplan {
namespace {

using search::CostRule;
using sites::SiteData, sites::SiteGrid, sites::SiteLayer, sites::between, sites::place_in,
    sites::require;

constexpr const char* no_trailer =
    "no trailer, as ways of a table are of the tractor alone: plan instead";
constexpr std::size_t starts_of_block = 256;  // starts of a matrix that a thread takes at once
constexpr double never = std::numeric_limits<double>::infinity();

/// Lower bound of what plans cost on open ground, and so at most a cost that was found [m].
double lower_bound(const Task& task, const CostRule& rule, double found) {
  const double least = search::cost_lower_bound(search::open_ground(task, rule), rule, 0.0);
  return std::min(least * (1 - search::rounding_of_cost), found);
}

/// Why a table has no way from a start to the goal of a task.
SiteOutcome why_no_way(const SiteTable& table, const Pose& start, const Task& task) {
  if (!task.checker->is_free(task.start)) return SiteOutcome::start_in_collision;
  if (!task.checker->is_free(task.goal)) return SiteOutcome::goal_in_collision;
  const Bounds box = table.bounds();
  const bool is_inside =
      start.x >= box.x_min && start.x < box.x_max && start.y >= box.y_min && start.y < box.y_max;
  return is_inside ? SiteOutcome::no_way : SiteOutcome::outside;
}

}  // namespace

SiteTable::SiteTable(std::shared_ptr<const SiteData> data) : data_(std::move(data)) {
  for (const SiteLayer& layer : data_->layers) goals_.push_back(layer.goal);
}

Bounds SiteTable::bounds() const noexcept {
  const SiteGrid& grid = data_->grid;
  return {grid.corner.x, grid.corner.x + grid.columns * grid.cell, grid.corner.y,
          grid.corner.y + grid.rows * grid.cell};
}

double SiteTable::cell() const noexcept { return data_->grid.cell; }

int SiteTable::headings() const noexcept { return data_->grid.headings; }

double SiteTable::cost(const Pose& pose, std::size_t goal) const noexcept {
  if (data_->costs) return data_->costs(pose, goal);
  const SiteLayer& layer = data_->layers[goal];
  sites::SiteState state = sites::state_at(data_->grid, layer, pose);
  double least = std::numeric_limits<double>::infinity();
  for (const int gear : {1, -1}) {
    state.gear = gear;
    if (const auto entry = data_->find(layer, state)) least = std::min(least, entry->cost);
  }
  return least;
}

double SiteTable::rounding(std::size_t goal) const noexcept { return data_->layers[goal].unit / 2; }

void SiteTable::expect_made_for(const Problem& problem, const PlanOptions& options) const {
  expect_equal(data_->key, sites::site_key(*problem.world(), problem.vehicle(), options));
}

void SiteTable::expect_goal(const Pose& goal, const std::string& where) const {
  if (sites::number_of(goals_, goal)) return;
  throw InputError(
      where, "the table has no such goal, expected one of its " + std::to_string(goals_.size()));
}

std::string_view name_of(SiteOutcome outcome) noexcept {
  constexpr std::array<std::string_view, 8> names = {
      "way",     "plan",   "start_in_collision", "goal_in_collision", "outside", "no_way",
      "no_path", "no_plan"};
  return names[static_cast<std::size_t>(outcome)];
}

bool sites::is_proven_empty(SiteOutcome outcome) noexcept {
  return outcome == SiteOutcome::start_in_collision || outcome == SiteOutcome::goal_in_collision ||
         outcome == SiteOutcome::no_path;
}

std::vector<std::optional<CheapestGoal>> cheapest_goals(std::span<const SiteCost> costs,
                                                        std::size_t goals) {
  std::vector<std::optional<CheapestGoal>> cheapest;
  for (std::size_t i = 0; goals > 0 && i + goals <= costs.size(); i += goals) {
    const std::span<const SiteCost> row = costs.subspan(i, goals);
    const auto least = std::ranges::min_element(row, {}, &SiteCost::cost);
    std::optional<CheapestGoal>& of_start = cheapest.emplace_back();
    if (least->cost == never) continue;
    double others = never;
    for (const SiteCost& cost : row) {
      if (&cost != &*least) others = std::min(others, cost.lower_bound);
    }
    of_start = {.goal = static_cast<std::size_t>(least - row.begin()),
                .cost = least->cost,
                .lower_bound = std::min(least->lower_bound, others),
                .is_proven = least->cost <= others};
  }
  return cheapest;
}

std::optional<SiteWay> site_way(const SiteTable& table, const Problem& problem,
                                const PlanOptions& options) {
  const bool is_one = problem.goal_set().empty() && problem.via().empty();
  require(is_one, "site", "one goal, no set of goals or vias");
  require(!problem.vehicle().trailer, "site", no_trailer);
  const Task task = task_of(problem, options.clearance);
  sites::expect_serves(table, task, options);
  std::optional<SiteWay> way = sites::way_in_world(table, task, options.cost);
  if (way) way->path.start = problem.start();
  return way;
}

std::vector<SiteCost> site_matrix(const SiteTable& table, const Problem& problem,
                                  std::span<const Pose> starts, const PlanOptions& options,
                                  int threads) {
  table.expect_made_for(problem, options);
  require(problem.task().moving.empty(), "site", "no moving obstacles: a table knows none");
  require(!problem.vehicle().trailer, "site", no_trailer);
  const std::vector<Pose>& goals = table.goals();
  std::vector<SiteCost> costs(starts.size() * goals.size());
  std::vector<LocalPose> from;
  from.reserve(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) {
    from.push_back(between(problem, starts[i], goals.front(), place_in("starts", i)).task().start);
  }
  // Starts of a block share what is known of the ways to the goal, but for ramps around a start.
  const bool has_ramps = options.clearance.margin > 0.0 && options.clearance.margin_ramp > 0.0;
  const std::size_t size = has_ramps ? 1 : starts_of_block;
  const std::size_t blocks = (starts.size() + size - 1) / size;
  parallel_for(goals.size() * blocks, std::max(1, threads), [&](std::size_t work) {
    const std::size_t j = work / blocks;
    const std::size_t begin = work % blocks * size;
    const std::size_t end = std::min(starts.size(), begin + size);
    const Problem pair = between(problem, starts[begin], goals[j], place_in("starts", begin));
    const Task task = task_of(pair, options.clearance, Steering::reeds_shepp);
    const CostRule rule = search::cost_rule(options.cost, task);
    sites::Ways ways(table.data(), table.data().layers[j], task, rule);
    Task open = task;
    for (std::size_t i = begin; i < end; ++i) {
      SiteCost& cost = costs[i * goals.size() + j];
      open.start = from[i];
      const bool is_free = task.checker->is_free(from[i]);
      const auto way = is_free ? ways.find(from[i]) : std::nullopt;
      if (way) cost.cost = way->cost;
      cost.outcome = way ? SiteOutcome::way : why_no_way(table, starts[i], open);
      cost.lower_bound = lower_bound(open, rule, cost.cost);
    }
  });
  sites::prove_empty_entries(problem, starts, goals, options, std::max(1, threads), costs);
  for (SiteCost& cost : costs) {
    if (sites::is_proven_empty(cost.outcome)) cost.lower_bound = never;
  }
  return costs;
}

std::string_view site_table_to_bytes(const SiteTable& table) noexcept { return table.data().bytes; }

SiteTable site_table_from_bytes(std::string_view bytes, std::shared_ptr<const void> owner,
                                const std::string& file) {
  return SiteTable(
      std::make_shared<const SiteData>(sites::site_from_bytes(bytes, std::move(owner), file)));
}

}  // namespace vandplan
