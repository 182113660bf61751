// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/prm.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/guarded.h"
#include "lab/estimate_options.h"
#include "lab/milestones.h"
#include "vandplan/graphs.h"
#include "vandplan/search.h"

namespace vandplan::prm {
namespace {

using search::Budget, search::MilestoneOptions, search::Milestones;
using RoadmapPointer = std::shared_ptr<const Roadmap>;

constexpr std::size_t first_level = 64;  // milestones of the first level
constexpr int batch = 16;                // samples between two looks at the clock
constexpr std::size_t most_kept = 4;     // roadmaps kept with a world

/// Settings that identify a roadmap of a world.
struct Key {
  std::shared_ptr<const CollisionChecker> checker;
  double radius = 0.0;  // turning radius [m]
  MilestoneOptions options = {};
  std::size_t most = 0;  // largest number of milestones
  bool operator==(const Key&) const = default;
};

/// A growing roadmap, and its levels: copies with 64, 128, ... milestones, and with all of them.
struct Growing {
  explicit Growing(const Key& key)
      : milestones(key.checker, key.radius, key.options), most(key.most) {}

  [[nodiscard]] bool is_full() const { return milestones.size() == most; }
  /// Number of milestones of the next level.
  [[nodiscard]] std::size_t next_level() const {
    return std::min(first_level << levels.size(), most);
  }
  void sample() {
    milestones.sample();
    if (milestones.size() < next_level()) return;
    levels.push_back(std::make_shared<const Roadmap>(
        milestones, levels.empty() ? nullptr : levels.back().get()));
  }

  Milestones milestones;
  std::size_t most;
  std::vector<RoadmapPointer> levels = {};
};

/// A growing roadmap that several threads may extend, one after the other.
using Shared = base::Guarded<Growing>;

/// The roadmaps of a world, in the order of their last use.
struct Shelf {
  std::vector<std::pair<Key, std::shared_ptr<const Shared>>> roadmaps = {};

  std::shared_ptr<const Shared> find_or_make(const Key& key) {
    auto found =
        std::ranges::find(roadmaps, key, &std::pair<Key, std::shared_ptr<const Shared>>::first);
    if (found == roadmaps.end()) {
      if (roadmaps.size() == most_kept) roadmaps.erase(roadmaps.begin());
      roadmaps.emplace_back(key, std::make_shared<const Shared>(key));
    } else {
      std::rotate(found, found + 1, roadmaps.end());
    }
    return roadmaps.back().second;
  }
};

std::shared_ptr<const Shared> roadmap_of(const Task& task, const PlanOptions& options) {
  const auto integer = [&](const char* name) { return options.planner.integer(name); };
  const Key key{task.checker,
                task.vehicle.min_turning_radius,
                {sampling_region(task, planning::region_of(options)),
                 static_cast<int>(integer("neighbours")), options.budget.seed},
                static_cast<std::size_t>(integer("nodes"))};
  // With ramps the checker is that of one start and goal, so no later query could use the roadmap.
  const Margin margin{.wanted = options.clearance.margin};
  if (task.world->checker(task.vehicle, margin) != task.checker) {
    return std::make_shared<const Shared>(key);
  }
  using Kept = base::Guarded<Shelf>;
  const auto shelf = std::static_pointer_cast<const Kept>(
      task.world->kept(typeid(Kept), [] { return std::make_shared<const Kept>(); }));
  return shelf->with([&](Shelf& all) { return all.find_or_make(key); });
}

/// Level `number` of a roadmap, which grows if necessary. Null if the budget is spent before, or
/// the roadmap has no such level. Samples count as iterations even if another run drew them.
RoadmapPointer level_of(const Shared& roadmap, std::size_t number, const PlanOptions& options,
                        Budget& budget) {
  const std::int64_t most =
      options.budget.max_iterations.value_or(std::numeric_limits<std::int64_t>::max());
  RoadmapPointer level;
  bool is_over = false;
  const auto grow = [&](Growing& growing) {
    for (int i = 0; i < batch && growing.levels.size() <= number; ++i) {
      if (growing.is_full() || growing.milestones.samples() >= most) break;
      growing.sample();
    }
    std::int64_t samples = growing.milestones.samples();
    if (growing.levels.size() > number) {
      level = growing.levels[number];
      samples = level->samples();
      if (samples > most) level = nullptr;
    }
    is_over = level || growing.is_full() || samples >= most;
    budget.spend(std::min(samples, most) - budget.iterations());
  };
  const auto is_interrupted = [&] { return budget.is_interrupted(); };
  while (!is_over && !is_interrupted() && roadmap.with(grow, is_interrupted)) {
  }
  return level;
}

/// Counters of a run.
struct Counts {
  std::int64_t nodes = 0, edges = 0, expansions = 0;
};

PlannerAnswer plan(const Task& task, const PlanOptions& options);

}  // namespace

Planner planner() {
  std::vector<OptionInfo> options = planning::estimate_options("reeds-shepp");
  options.insert(options.begin(), planning::region_option());
  options.push_back({.name = "nodes",
                     .summary = "largest number of milestones",
                     .default_value = std::int64_t{10'000},
                     .least = 1,
                     .most = 1'000'000});
  options.push_back({.name = "neighbours",
                     .summary = "older milestones joined to each milestone",
                     .default_value = std::int64_t{12},
                     .least = 1,
                     .most = 100});
  options.push_back(
      {.name = "keep_tree", .summary = "return the last roadmap search", .default_value = false});
  return {.name = "prm",
          .summary = "roadmap of free poses, kept with the world for further queries",
          .properties = {.family = "prm",
                         .estimate = "reeds-shepp",
                         .anytime = true,
                         .groups = {"family"}},
          .options = std::move(options),
          .function = plan};
}

namespace {

// A probabilistic roadmap (Kavraki, Svestka, Latombe and Overmars 1996), checked lazily (Bohlin and
// Kavraki 2000), grown in levels.
//
//   [1] try the piece from start to goal: if it is free there is nothing shorter
//   for levels of 64, 128, ... milestones, until there are enough of them or the budget is spent:
//   [2]   grow the roadmap to that level, unless somebody has
//   [3]   join start and goal to their nearest milestones, and search the shortest way
//   [4]   keep the shortest way of all levels
PlannerAnswer plan(const Task& task, const PlanOptions& options) {
  PlannerAnswer answer;
  Budget budget(options.budget);
  double least = std::numeric_limits<double>::infinity();
  const auto keep = [&](std::vector<Segment> segments, double length) {
    if (length >= least) return;
    least = length;
    answer.segments = std::move(segments);
    answer.anytime.push_back({budget.elapsed(), budget.iterations(), length});
  };
  if (const auto end = budget.exhausted()) return {.status = *end};
  search::Connector connector(task);
  if (const auto direct = connector.connect(task.start, task.goal)) {  // [1]
    keep(merged(direct->piece.view()), direct->cost);
    answer.status = PlanStatus::solved;
    answer.lower_bound = direct->cost;
    if (options.planner.flag("keep_tree")) {
      answer.tree = TreeSnapshot{{task.start, task.goal}, {-1, 0}};
    }
    return answer;
  }
  const search::GoalEstimate estimate = planning::estimate_of(options, task);
  const RouteOptions asked{.estimate = estimate.length,
                           .is_interrupted = [&] { return budget.is_interrupted(); },
                           .keep_tree = options.planner.flag("keep_tree")};
  const std::shared_ptr<const Shared> roadmap = roadmap_of(task, options);
  Counts counts;
  if (asked.keep_tree) answer.tree = TreeSnapshot{{task.start}, {-1}};
  for (std::size_t number = 0;; ++number) {
    const RoadmapPointer level = level_of(*roadmap, number, options, budget);  // [2]
    if (!level) break;
    RoadmapAnswer found = level->route(task.start, task.goal, asked);  // [3]
    counts = {level->nodes(), level->edges(), counts.expansions + found.expansions};
    if (found.route) keep(std::move(found.route->segments), found.route->length);  // [4]
    answer.tree = std::move(found.tree);
  }
  answer.status =
      answer.segments ? PlanStatus::solved : budget.exhausted().value_or(PlanStatus::node_limit);
  if (answer.status == PlanStatus::node_limit) {
    answer.reason = "there is no way through " + std::to_string(counts.nodes) + " milestones";
  }
  answer.iterations = budget.iterations();
  answer.counters = {
      {"nodes", counts.nodes}, {"edges", counts.edges}, {"expansions", counts.expansions}};
  return answer;
}

}  // namespace

}  // namespace vandplan::prm
