// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I plan?
//
//   const auto result = vandplan::plan(scenario);
//
// A planner is a value: a name, its properties, its own options and a function. Those of the
// library stand in one list; yours are used, judged and compared alike. `plan` lets the independent
// judge see a path before anybody else does.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/drive_check.h"
#include "vandplan/outcome.h"
#include "vandplan/path_check.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {

/// What a planner honours and promises. Reports, help and comparisons read these; a name means
/// nothing to them.
struct PlannerProperties {
  std::string family = {};        ///< planners that are built alike: "rrt"
  std::string strategy = {};      ///< which node becomes a parent: "bsc", "opt"; or empty
  std::string estimate = {};      ///< what ranks nodes: "euclid", "hlut-2", ...; or empty
  std::string search = {};        ///< its name without the estimate; empty if it takes none
  bool tries_goal = false;        ///< tries the goal from every new node
  bool honours_prices = false;    ///< CostOptions; else its cost is the length
  bool honours_gears = false;     ///< `CostOptions::gears`
  Style style = Style::shortest;  ///< what it minimises when no style and price is set
  /// Steering of a vehicle without a trailer when none is set; none: that of the style.
  std::optional<Steering> steering = {};
  bool honours_time = false;        ///< CostMeasure::time
  bool honours_threads = false;     ///< BudgetOptions::threads
  bool honours_target_gap = false;  ///< BudgetOptions::target_gap: it proves lower bounds
  bool honours_steering = false;    ///< PlanOptions::steering; else it is `reeds_shepp`
  bool honours_primitives = false;  ///< PlanOptions::primitives
  bool honours_moving = false;      ///< Task::moving: it answers speeds, too
  bool honours_trailers = false;    ///< plans for a vehicle that pulls a trailer, too
  /// Task::goal_set; else `plan` lets it plan to single goals of a set in turn.
  bool honours_goal_sets = false;
  bool honours_steering_of_rigs = false;  ///< PlanOptions::steering with a trailer, too
  bool anytime = false;                   ///< goes on improving its path for as long as it may
  bool deterministic = true;              ///< same seed and iterations, same path
  std::vector<std::string> groups = {};   ///< sets that it belongs to: "thesis"
};

/// What plans: called with a task and options that are complete and in range. It may hold state; it
/// may be called from several threads at once.
using PlannerFunction = std::function<PlannerAnswer(const Task&, const PlanOptions&)>;

/// A planner that can be chosen by name.
struct Planner {
  std::string name;
  std::string summary;  ///< one line
  PlannerProperties properties = {};
  std::vector<OptionInfo> options = {};  ///< its own
  PlannerFunction function = {};
};

/// What a run brought. Poses are in the scenario's frame.
struct PlanResult {
  PlanStatus status = PlanStatus::stopped;
  std::string reason = {};        ///< why there is no path, or no valid one; or empty
  std::optional<Hit> hit = {};    ///< what is in the way of a start or goal in collision
  std::optional<Path> path = {};  ///< from the start as it was given to the goal
  /// The goal that the path ends at. None if the problem has one goal pose only, or without a path.
  std::optional<ReachedGoal> goal = {};
  double cost = 0.0;         ///< of the path [m], or [s] where the cost is the time
  CostOptions rule = {};     ///< what was minimised, every price set
  double lower_bound = 0.0;  ///< no path costs less; proven; 0: nothing is
  std::int64_t iterations = 0;
  double time_total = 0.0;  ///< in the planner [s]
  std::vector<CostSample> anytime = {};
  std::vector<Counter> counters = {};
  std::vector<PhaseTime> phases = {};
  std::optional<TreeSnapshot> tree = {};
  /// What the judge found: of the path, or of a path that it rejected.
  std::optional<PathCheck> check = {};
  /// When the vehicle is where on the path, if anything moves in the problem.
  std::optional<SpeedProfile> speeds = {};
  /// What the judge found of these times, or of times that it rejected.
  std::optional<DriveCheck> drive_check = {};
};

/// What was counted under this name; 0 if nothing was.
[[nodiscard]] std::int64_t counter(const PlanResult& result, std::string_view name) noexcept;

/// The planners of the library, the default one first.
[[nodiscard]] std::span<const Planner> planners();

/// The planner that is used when none is named.
[[nodiscard]] const Planner& default_planner();

/// The default planner, told of a path that was good for a like problem: whose start, goal or
/// obstacles were a little different. If a path along it is free, that is the first one, and it is
/// bettered before others are looked for. `path` is in the scenario's frame; of one for a vehicle
/// with a trailer, or among what moves, no notice is taken. Throws InputError for one with a number
/// that is not finite.
[[nodiscard]] Planner warm_started(const Path& path);

/// The planner of that name; none if there is none. A search that is guided by an estimate may be
/// named with one behind a colon, or with the larger of two: "hrrt:hlut-4",
/// "hrrt:max-hlut-4-bound".
[[nodiscard]] std::optional<Planner> find_planner(std::string_view name);

/// The planner of that name, as `find_planner` knows it. Throws InputError that lists all planners,
/// or all estimates, when there is none.
[[nodiscard]] Planner planner_named(std::string_view name);

/// What is in force: all prices, the steering and the planner's own options are set. `plan`, the
/// command line, Python and the evaluation get their defaults here, and only here. Prices that are
/// not set are those of the style for that vehicle. A path for one that pulls a trailer is made of
/// arcs and lines unless another steering is asked for. Completing twice changes nothing.
/// Throws InputError naming the first option that is out of range, or that the planner does not
/// honour (and which planners of the library do); "planner" when it plans for vehicles without a
/// trailer alone, "steering" when it does so with that steering.
[[nodiscard]] PlanOptions complete(const Planner& planner, const PlanOptions& options = {},
                                   const Vehicle& vehicle = {});

/// Whether a planner honours an option of that name, one of its own or of all planners.
[[nodiscard]] bool honours(const Planner& planner, std::string_view option);

/// Whether the planner looks lengths up in `PlanOptions::table` when it has these options: an
/// estimate of its is "table".
[[nodiscard]] bool asks_for_table(const Planner& planner, const PlanOptions& options);

/// Sets an option for a planner by name from text, as `--set` does. Throws InputError naming the
/// option when there is none, the planner does not honour it, or the value is no good.
void set_option(PlanOptions& options, const Planner& planner, std::string_view name,
                std::string_view text);

/// Whether an option is set before others, since it takes back what they set: "style" the prices
/// and the steering, "cost" the prices.
[[nodiscard]] bool is_set_first(std::string_view option) noexcept;

/// Sets those options that the planner honours, and passes over the others. Throws InputError
/// naming the option whose value is no good.
void set_honoured(PlanOptions& options, const Planner& planner, std::span<const Setting> settings);

/// Plans a path. A run without limit of time or iterations takes `default_time_limit`. Throws
/// InputError for options that `complete` refuses. A path that the judge rejects, whoever planned
/// it, is none: the status is `rejected`, and `check` says why. Where something moves the planner
/// has to honour that, else InputError names those that do.
[[nodiscard]] PlanResult plan(const Problem& problem, const Planner& planner,
                              const PlanOptions& options = {});

/// Plans a path with the default planner.
[[nodiscard]] PlanResult plan(const Problem& problem, const PlanOptions& options = {});

/// Plans a path for a scenario with the default planner. Throws InputError naming what is wrong
/// with the scenario.
[[nodiscard]] PlanResult plan(const Scenario& scenario, const PlanOptions& options = {});

/// Plans many problems, `jobs` at a time, each with the same options. `take(i, result)` is called
/// once for each problem, one at a time, in the order of the problems. Throws what a planner or
/// `take` throws.
void plan_many(std::span<const Problem> problems, const Planner& planner,
               const PlanOptions& options, int jobs,
               const std::function<void(std::size_t, PlanResult)>& take);

}  // namespace vandplan
