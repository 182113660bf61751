// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does it cost to drive from everywhere on a site to its goals, looked up?
//
//   const auto table = vandplan::make_site_table(problem, docks, options);
//   options.site = std::make_shared<const vandplan::SiteTable>(*table);
//   const auto result = vandplan::plan(problem, options);
//
// The default planner begins with the way of the table. With a trailer, the first path that the rig
// tries to follow is the way of the tractor alone. If the table has no free way, it plans without.
// A plan to a set of goals, or past vias, begins so with those of their poses that the table has as
// goals. The searches of graphs.h and the thesis' trees take the table's costs as the estimate
// "site".
//
// Method, size and errors: docs/algorithms/site_tables.md.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {

namespace sites {
struct SiteData;
}

/// Resolution of a table, where it reaches, and who makes it.
struct SiteTableOptions {
  int headings = 36;          ///< headings of a full turn; [8, 256]
  double cell = 0.12;         ///< side of a cell of places [turning radii]; [0.01, 1]
  int threads = 1;            ///< threads that share the goals, with equal results; [1, 256]
  std::stop_token stop = {};  ///< the work ends soon after this is asked to stop
  /// Called with the number of goals that are done, one call at a time, from any of the threads.
  std::function<void(std::size_t)> progress = {};
  /// Poses in the scenario's frame that lie in the table's box, besides goals and obstacles. Those
  /// that are not free do not count.
  std::vector<Pose> starts = {};
  bool allows_blocked_goals = false;  ///< a goal that is not free has no ways, and is no error
};

/// Costs of driving from everywhere on a site to each of some goals, for one vehicle and its
/// prices. The costs are those of ways made of arcs and lines of fixed lengths. Immutable; copies
/// share their numbers. Poses are in the scenario's frame.
class SiteTable {
 public:
  /// Goals of the table, as they were given.
  [[nodiscard]] const std::vector<Pose>& goals() const noexcept { return goals_; }

  /// Box of the places that the table knows, but for less than a cell.
  [[nodiscard]] Bounds bounds() const noexcept;
  /// Side of a cell of places [m].
  [[nodiscard]] double cell() const noexcept;
  /// Headings of a full turn.
  [[nodiscard]] int headings() const noexcept;

  /// Approximate cost of driving from a pose to a goal [m]: that of the pose that the pose's cell
  /// keeps, in the cheaper gear. Infinite outside of the table, and where no way was found. No
  /// bound: the pose may lie a cell away from the one that was kept. `goal` must be below the
  /// number of goals.
  [[nodiscard]] double cost(const Pose& pose, std::size_t goal) const noexcept;

  /// Largest error of the costs to a goal by rounding to 16 bits [m].
  [[nodiscard]] double rounding(std::size_t goal) const noexcept;

  /// Checks that the table was made for the world, vehicle, prices and margin of a problem. Throws
  /// InputError naming "site" that says which of them differs. The options must be complete.
  void expect_made_for(const Problem& problem, const PlanOptions& options) const;

  /// Checks that a pose is one of the goals. Throws InputError naming `where` if it is none.
  void expect_goal(const Pose& goal, const std::string& where = "site") const;

  /// The table of some of the goals, in this order. Throws InputError naming "goals[2]" for one
  /// that the table lacks.
  [[nodiscard]] SiteTable with_goals(std::span<const Pose> goals) const;

  /// A table of numbers, and the numbers of a table, for the library alone.
  explicit SiteTable(std::shared_ptr<const sites::SiteData> data);
  [[nodiscard]] const sites::SiteData& data() const noexcept { return *data_; }

 private:
  std::shared_ptr<const sites::SiteData> data_;
  std::vector<Pose> goals_;
};

/// Goals of a table that are those of a problem.
struct SiteGoals {
  std::vector<Pose> poses = {};  ///< the goals, in the scenario's frame
  std::size_t left_out = 0;      ///< poses of a set of goals where the vehicle cannot stand
};

/// The goals of a problem for a table: its goal, or the poses of its set where the vehicle can
/// stand. A trailer is left out, and so are straight last stretches. The options must be complete.
/// Throws InputError naming "goals" if the set holds infinitely many poses, or none is free.
[[nodiscard]] SiteGoals site_goals(const Problem& problem, const PlanOptions& options);

/// What is wrong with setting an option of that name for a table; empty: nothing. A table is made
/// for prices, gears and margin. The budget of plans means nothing to it, and "site" is no option
/// of a table.
[[nodiscard]] std::string_view fault_of_site_option(std::string_view option) noexcept;

/// Makes a table of a problem's world and vehicle to some goals, in the scenario's frame. Start and
/// goal of the problem do not matter. The options must be complete (`complete` of planner.h);
/// steering and budget do not matter. A trailer is left out: the table is that of the tractor
/// alone. None if `stop` was asked to stop. Throws InputError naming:
///
/// - "goals" if there are none, "goals[2]" for one that is not free or out of range,
/// - "starts[2]" for a start of `table` that is out of range,
/// - "headings", "cell" or "threads" out of range, "cell" also if there are too many cells,
/// - "cost" if the cost is the time, "moving" if obstacles move.
[[nodiscard]] std::optional<SiteTable> make_site_table(const Problem& problem,
                                                       std::span<const Pose> goals,
                                                       const PlanOptions& options,
                                                       const SiteTableOptions& table = {});

/// A table that follows its world: where obstacles come and go it is repaired, not made anew.
///
///   ChangingSiteTable docks(problem, goals, options);
///   ground.patch({.added = {parked}});  // ground: a ChangingWorld
///   docks.repair(make_problem(ground.world(), vehicle, start, goal));
///   const auto way = site_way(docks.table(), problem, options);
///
/// It keeps some 15 MB for each goal, where a table has one.
class ChangingSiteTable {
 public:
  /// Makes the table as `make_site_table` does, and throws InputError as that, also naming "stop"
  /// if it was asked to stop.
  ChangingSiteTable(const Problem& problem, std::span<const Pose> goals, const PlanOptions& options,
                    const SiteTableOptions& table = {});
  ~ChangingSiteTable();
  ChangingSiteTable(ChangingSiteTable&&) noexcept;
  ChangingSiteTable& operator=(ChangingSiteTable&&) noexcept;

  /// Makes the table that of the problem's world. It finds itself where that world differs from the
  /// last one. The result is the table that `make_site_table` makes for the world, byte for byte,
  /// except that the table keeps its box. A goal that is not free has no ways until it is free
  /// again. Where bounds, origin or the shape of a map differ, the table is made anew. Throws
  /// InputError naming "problem" if the vehicle's body or radius is another or obstacles move; then
  /// the table stays.
  void repair(const Problem& problem);

  /// Repairs as above for the world of a scenario, wherever its start is: the table keeps its
  /// origin. Also throws InputError naming a key of the scenario.
  void repair(const Scenario& scenario);

  /// Makes the ways to some goals, by number, those of the problem's world. Goals that the world's
  /// changes concern, and that were left out, have no ways until they are repaired. False if it
  /// ended early because `is_over` said so: the table stays, and a later repair goes on. `is_over`
  /// is called from any of the table's threads. Throws InputError as above, also naming "goals".
  bool repair(const Problem& problem, std::span<const std::size_t> goals,
              const std::function<bool()>& is_over);

  /// The table. Copies that were taken before a repair stay as they are.
  [[nodiscard]] const SiteTable& table() const noexcept;

  /// Origin of the worlds that the table can be repaired for, in the scenario's frame [m]. A world
  /// that is made near this place has it.
  [[nodiscard]] Point origin() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// A way that a table knows. It is free: the vehicle's checker has accepted it.
struct SiteWay {
  std::size_t goal = 0;  ///< number of the goal in the table
  Path path = {};        ///< from the problem's start to its goal, of arcs and lines
  double cost = 0.0;     ///< cost of the path under the options [m]
};

/// The way of a table from a problem's start to its goal. None if no free one was found: the start
/// is not free, outside of the table, or in a place that the goal cannot be reached from. The
/// options must be complete. Throws InputError naming "site" if the table was made for something
/// else (`SiteTable::expect_made_for`), if it has no such goal, or if the problem has a trailer, a
/// set of goals, vias or moving obstacles.
[[nodiscard]] std::optional<SiteWay> site_way(const SiteTable& table, const Problem& problem,
                                              const PlanOptions& options);

/// What a cost from a start to a goal is the cost of, or why there is none.
enum class SiteOutcome : std::uint8_t {
  way,                 ///< cost of the table's way
  plan,                ///< cost of a plan
  start_in_collision,  ///< none: the start is not free, or zones keep the vehicle there
  goal_in_collision,   ///< none: the goal is not free, or zones keep the vehicle away
  outside,             ///< none: the start is outside of the table
  no_way,              ///< none: the table has no free way
  no_path,             ///< none: it is proven that there is no path
  no_plan,             ///< none: the table has no free way, and the budget brought no plan
};

/// Name of the outcome: "way", "start_in_collision", ...
[[nodiscard]] std::string_view name_of(SiteOutcome outcome) noexcept;

/// What driving from a start to a goal costs.
struct SiteCost {
  /// Cost of a free path that was found [m]; infinite if none was found.
  double cost = std::numeric_limits<double>::infinity();
  /// Proven lower bound of the cost of every path [m]; infinite if it is proven that there is none.
  double lower_bound = 0.0;
  SiteOutcome outcome = SiteOutcome::no_way;
};

/// Costs from each start to each goal of a table, in the scenario's frame: start by start, and for
/// each start as many as there are goals. They are those of ways, as `SiteWay::cost`. Lower bounds
/// are of open ground, and at most the cost. A bound is infinite if an end is not free, or walls,
/// zones or one-way streets are proven to part start and goal. As those of plans, they hold for all
/// paths that the judge accepts, but by length for exact ends only. Start and goal of the problem
/// do not matter; the options must be complete. `threads` share the pairs, with equal results;
/// below 1 counts as 1. Throws InputError naming "site" as `site_way` does, or "starts[2]" for a
/// start out of range.
[[nodiscard]] std::vector<SiteCost> site_matrix(const SiteTable& table, const Problem& problem,
                                                std::span<const Pose> starts,
                                                const PlanOptions& options, int threads = 1);

/// Costs of plans from each start to each goal of `options.site`, ordered as by `site_matrix`. Each
/// is a plan of the default planner (planner.h) with the budget of the options, which begins with
/// the table's way; `jobs` at a time. No cost is above that of `site_matrix`: where no plan is as
/// cheap, it is the cost of the way of arcs and lines, at whose joints the wheels turn at a
/// standstill. Only with a trailer or the steering `continuous` all costs are those of plans. Lower
/// bounds are those of the plans, 0 where nothing is proven, and at most the cost. They are
/// infinite where it is proven that there is no path. Trailers are straight at both ends. Start and
/// goal of the problem do not matter. Throws InputError as `plan` does, also naming "site" without
/// a table, or "starts[2]" for a start out of range.
[[nodiscard]] std::vector<SiteCost> plan_matrix(const Problem& problem,
                                                std::span<const Pose> starts,
                                                const PlanOptions& options, int jobs = 1);

/// The goal that costs least from a start.
struct CheapestGoal {
  std::size_t goal = 0;      ///< its number
  double cost = 0.0;         ///< [m]
  double lower_bound = 0.0;  ///< proven lower bound of the cost of every path to any goal [m]
  bool is_proven = false;    ///< whether it costs no more than the lower bounds of all other goals
};

/// The cheapest goal for each start of a matrix with so many goals; of equal ones the first. None
/// for a start without costs.
[[nodiscard]] std::vector<std::optional<CheapestGoal>> cheapest_goals(
    std::span<const SiteCost> costs, std::size_t goals);

// ---- How does a table become a file, and how does a file become a table? ----
//
// The functions convert bytes; vandplan/files.h reads and writes them. Layout: docs/formats.md.

/// The table as the bytes of a file, equal on every machine. They live as long as the table.
[[nodiscard]] std::string_view site_table_to_bytes(const SiteTable& table) noexcept;

/// Largest file of a table that is read [bytes].
inline constexpr std::size_t largest_site_table = static_cast<std::size_t>(
    std::min(std::uint64_t{1} << 34, std::uint64_t{std::numeric_limits<std::size_t>::max()}));

/// The table that `site_table_to_bytes` wrote. It looks into the bytes where they lie, and keeps
/// their owner. Throws InputError naming `file` if the bytes are foreign, truncated, altered, or of
/// another version.
[[nodiscard]] SiteTable site_table_from_bytes(std::string_view bytes,
                                              std::shared_ptr<const void> owner,
                                              const std::string& file);

}  // namespace vandplan
