// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/site_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/parallel.h"
#include "geometry/boxes.h"
#include "search/clearance_raster.h"
#include "search/drive_field.h"
#include "search/guide.h"
#include "sites/data.h"
#include "sites/way.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"

namespace vandplan {
namespace {

using search::Connector, search::CostRule, search::DriveField, search::ClearanceRaster;
using sites::SiteData, sites::SiteEntry, sites::SiteGrid, sites::SiteLayer, sites::SiteRecord;

constexpr double most_pairs = 1e8;    // pairs of cell and heading in a table
constexpr double room_of_step = 0.2;  // room that the longest step needs [turning radii]
/// Costs up to which ways are looked for: turning radii, and sides of the site.
constexpr double most_radii = 160.0;
constexpr double most_sides = 8.0;
constexpr std::size_t starts_of_block = 256;  // starts of a matrix that a thread takes at once
constexpr int poses_between_looks = 4096;     // poses expanded between looks at the stop token

/// Guide of a field that spreads to everywhere.
class Nowhere final : public search::Guide {
 public:
  bool step() override { return false; }
  [[nodiscard]] bool is_connected() const noexcept override { return true; }
  [[nodiscard]] double at(double, double) const noexcept override { return 0.0; }
};

void require(bool holds, const char* where, const char* expected) {
  if (!holds) throw InputError(where, std::string("expected ") + expected);
}

void check(const Problem& problem, std::span<const Pose> goals, const PlanOptions& options,
           const SiteTableOptions& table) {
  require(!goals.empty(), "goals", "at least one");
  require(table.headings >= 8 && table.headings <= 256, "headings", "8 to 256");
  require(table.cell >= 0.01 && table.cell <= 1.0, "cell", "0.01 to 1 turning radii");
  require(table.threads >= 1 && table.threads <= 256, "threads", "1 to 256");
  require(options.cost.measure == CostMeasure::prices, "cost", "prices: a table knows no times");
  require(!problem.vehicle().trailer, "trailers", "none: a table knows no trailers");
  require(problem.task().moving.empty(), "moving", "none: a table knows no moving obstacles");
}

/// The problem from another start to another goal. Throws InputError naming `where`.
Problem between(const Problem& problem, const Pose& start, const Pose& goal,
                const std::string& where) {
  try {
    return with_poses(problem, start, goal);
  } catch (const InputError& error) {
    throw InputError(where, error.problem());
  }
}

/// Place of a pose in a list, for errors: "goals[2]".
std::string place_in(const char* list, std::size_t number) {
  return std::string(list) + "[" + std::to_string(number) + "]";
}

/// The task to a goal: it begins there, so that margins have ramps around the goal alone.
Task task_to(const Problem& problem, const Pose& goal, std::size_t number,
             const PlanOptions& options) {
  const std::string where = place_in("goals", number);
  Task task = task_of(between(problem, goal, goal, where), options.clearance);
  if (!task.checker->is_free(task.goal)) throw InputError(where, "is not free");
  return task;
}

/// [1] Box around what the tasks reach, in the world's frame.
Bounds box_around(const std::vector<Task>& tasks) {
  Bounds box = sampling_region(tasks.front(), Region::scene);
  for (const Task& task : tasks) {
    box = geometry::united(box, sampling_region(task, Region::scene));
  }
  return box;
}

/// The raster of a task. It is wider than the box of the poses, since bodies reach beyond it.
ClearanceRaster raster_around(const Task& task, const Bounds& box, double most) {
  double reach = 0.0;
  for (const Point& corner : body_outline(task.vehicle)) {
    reach = std::max(reach, std::hypot(corner.x, corner.y));
  }
  ClearanceRaster raster(task, geometry::widened(box, reach), most);
  while (raster.step()) {
  }
  return raster;
}

/// [2] Costs to one goal, made by a field that spreads from there.
class LayerMaker {
 public:
  LayerMaker(const Task& task, const CostRule& rule, const Bounds& box,
             const SiteTableOptions& options)
      : back_(task, reversed(rule, 0)),
        raster_(raster_around(task, box,
                              std::max(rule.clearance_distance, room_of_step * back_.radius()))),
        headings_(options.headings),
        field_(back_, raster_, box,
               {.headings = options.headings,
                .cell = options.cell,
                .of_table = task.checker.get(),
                .arcs = sites::arcs_of_site},
               task.goal, 0,
               std::max(most_radii * back_.radius(),
                        most_sides * (box.x_max - box.x_min + box.y_max - box.y_min))),
        stop_(options.stop) {}

  /// [3] Records of all states that were reached, in order; none if the work was stopped.
  [[nodiscard]] std::optional<std::vector<SiteRecord>> records() {
    field_.look_towards(nowhere_);
    std::size_t count = 0;
    for (int poses = 0; !field_.is_exhausted(); ++poses) {
      if (poses % poses_between_looks == 0 && stop_.stop_requested()) return std::nullopt;
      if (field_.step() != DriveField::none) ++count;
    }
    std::vector<SiteRecord> records;
    records.reserve(count);
    for (std::int64_t pair = 0; pair < field_.columns() * field_.rows() * headings_; ++pair) {
      for (const int gear : {1, -1}) {
        const auto heading = static_cast<int>(pair % headings_);
        const std::int32_t id = field_.expanded(pair / headings_, heading, gear);
        if (id != DriveField::none) records.push_back(record(field_.node(id)));
      }
    }
    return records;
  }

 private:
  [[nodiscard]] SiteRecord record(const DriveField::Node& node) const {
    const std::int64_t cell = field_.cell_of(node.x, node.y);
    SiteRecord record{.pair = static_cast<std::uint64_t>(cell * headings_ + node.heading),
                      .gear = node.gear < 0 ? 1 : -1,
                      .entry = {.cost = static_cast<double>(node.cost)}};
    record.entry.is_goal = node.parent == DriveField::none;
    if (record.entry.is_goal) return record;
    const DriveField::Node& parent = field_.node(node.parent);
    const std::int64_t next = field_.cell_of(parent.x, parent.y);
    const std::int64_t columns = field_.columns();
    record.entry.arc = node.side;
    record.entry.columns = static_cast<std::int32_t>(next % columns - cell % columns);
    record.entry.rows = static_cast<std::int32_t>(next / columns - cell / columns);
    record.entry.next_gear = -parent.gear;
    return record;
  }

  Connector back_;
  ClearanceRaster raster_;
  Nowhere nowhere_;
  int headings_;
  DriveField field_;
  std::stop_token stop_;
};

SiteGrid grid_of(const Bounds& box, const Task& task, const SiteTableOptions& options) {
  const double radius = task.vehicle.min_turning_radius;
  const double cell = options.cell * radius;
  const double columns = (box.x_max - box.x_min) / cell + 1;
  const double rows = (box.y_max - box.y_min) / cell + 1;
  require(columns * rows * options.headings <= most_pairs, "cell",
          "larger cells: the site has too many");
  const Point& origin = task.world->origin();
  return {.corner = {box.x_min + origin.x, box.y_min + origin.y},
          .cell = cell,
          .radius = radius,
          .columns = static_cast<std::int32_t>(columns),
          .rows = static_cast<std::int32_t>(rows),
          .headings = options.headings};
}

}  // namespace

SiteTable::SiteTable(std::shared_ptr<const SiteData> data) : data_(std::move(data)) {
  for (const SiteLayer& layer : data_->layers) goals_.push_back(layer.goal);
}

std::optional<SiteTable> make_site_table(const Problem& problem, std::span<const Pose> goals,
                                         const PlanOptions& options,
                                         const SiteTableOptions& table) {
  check(problem, goals, options, table);
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    tasks.push_back(task_to(problem, goals[i], i, options));
  }
  const CostRule rule = search::cost_rule(options.cost, tasks.front());
  const Bounds box = box_around(tasks);
  const SiteGrid grid = grid_of(box, tasks.front(), table);
  std::vector<SiteLayer> layers(goals.size());
  std::vector<std::string> numbers(goals.size());
  const auto work = [&](std::size_t i) {
    if (table.stop.stop_requested()) return;
    auto records = LayerMaker(tasks[i], rule, box, table).records();
    if (!records) return;
    layers[i].goal = goals[i];
    numbers[i] = sites::layer_to_bytes(grid, *records, layers[i]);
  };
  parallel_in_order(goals.size(), table.threads, work, [&](std::size_t i) {
    if (table.progress) table.progress(i + 1);
  });
  if (std::ranges::any_of(numbers, [](const std::string& part) { return part.empty(); })) {
    return std::nullopt;
  }
  const sites::SiteKey key = sites::site_key(*problem.world(), problem.vehicle(), options);
  auto bytes =
      std::make_shared<const std::string>(sites::site_to_bytes(key, grid, layers, numbers));
  return site_table_from_bytes(*bytes, bytes, "site");
}

Bounds SiteTable::bounds() const noexcept {
  const SiteGrid& grid = data_->grid;
  return {grid.corner.x, grid.corner.x + grid.columns * grid.cell, grid.corner.y,
          grid.corner.y + grid.rows * grid.cell};
}

double SiteTable::cell() const noexcept { return data_->grid.cell; }

int SiteTable::headings() const noexcept { return data_->grid.headings; }

double SiteTable::cost(const Pose& pose, std::size_t goal) const noexcept {
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

std::optional<SiteWay> site_way(const SiteTable& table, const Problem& problem,
                                const PlanOptions& options) {
  const bool is_one = problem.goal_set().empty() && problem.via().empty();
  require(is_one, "site", "one goal, no set of goals or vias");
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
  const std::vector<Pose>& goals = table.goals();
  const CostRule rule = search::cost_rule(options.cost);  // bounds leave zones out
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
    const CostRule prices = search::cost_rule(options.cost, task);
    sites::Ways ways(table.data(), table.data().layers[j], task, prices);
    Connector open(task, rule);
    for (std::size_t i = begin; i < end; ++i) {
      SiteCost& cost = costs[i * goals.size() + j];
      cost.lower_bound = open.least_cost(from[i], task.goal, {rule.initial_gear, 0});
      if (!task.checker->is_free(from[i])) continue;
      const auto way = ways.find(from[i]);
      if (way) cost.cost = way->cost;
    }
  });
  return costs;
}

std::string_view site_table_to_bytes(const SiteTable& table) noexcept { return table.data().bytes; }

SiteTable site_table_from_bytes(std::string_view bytes, std::shared_ptr<const void> owner,
                                const std::string& file) {
  return SiteTable(
      std::make_shared<const SiteData>(sites::site_from_bytes(bytes, std::move(owner), file)));
}

}  // namespace vandplan
