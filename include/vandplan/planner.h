// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I plan?
//
//   const auto result = vandplan::plan(scenario);
//
// A planner is a value: a name, its properties, its own options and a function. The planners of the
// library stand in one list. Your own planners are used, judged and compared in the same way.
// `plan` shows every path to the independent judge before it returns it.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/judge.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {

/// What a planner honours and promises. Reports, help and comparisons read these properties; they
/// conclude nothing from names.
struct PlannerProperties {
  std::string family = {};    ///< family of planners that are built alike: "rrt"
  std::string strategy = {};  ///< how a parent node is chosen: "bsc", "opt"; or empty
  std::string estimate = {};  ///< estimate that ranks nodes: "euclid", "hlut-2", ...; or empty
  /// Name of the planner without its estimate; empty if it takes no estimate.
  std::string search = {};
  bool tries_goal = false;         ///< whether every new node tries to reach the goal
  Capabilities capabilities = {};  ///< what the planner can do: {Capability::prices}
  Style style = Style::shortest;   ///< style when no style and no price is set
  /// Steering when no steering is set; with a trailer only if the cost is the time. None: the
  /// steering of the style.
  std::optional<Steering> steering = {};
  /// Whether the planner improves its path until the budget is spent.
  bool anytime = false;
  bool deterministic = true;  ///< whether equal seeds and iterations give equal paths
  /// Names of the groups that the planner belongs to: "thesis".
  std::vector<std::string> groups = {};
};

/// Function that plans. It is called with a task, and with options that are complete and in range.
/// It may hold state. It may be called from several threads at once.
using PlannerFunction = std::function<PlannerAnswer(const Task&, const PlanOptions&)>;

/// A planner that can be chosen by name.
struct Planner {
  std::string name;
  std::string summary;  ///< the planner in one line
  PlannerProperties properties = {};
  std::vector<OptionInfo> options = {};  ///< options of this planner alone
  PlannerFunction function = {};

  /// Whether the planner says that it can do that.
  [[nodiscard]] bool can(Capability capability) const noexcept {
    return properties.capabilities.has(capability);
  }
};

/// Result of a planning run. Poses are in the scenario's frame.
struct PlanResult {
  PlanStatus status = PlanStatus::stopped;
  std::string reason = {};  ///< why there is no path, or no valid one; or empty
  /// Obstacle, cell or bound in the way of a start or goal in collision.
  std::optional<Hit> hit = {};
  std::optional<Path> path = {};  ///< path from the start, as it was given, to the goal
  /// The goal of a set at which the path ends. None without a path, or without a set of goals.
  std::optional<ReachedGoal> goal = {};
  /// Where the path passes each via of the problem. Empty without a path, or without vias.
  std::vector<PassedVia> via = {};
  double cost = 0.0;      ///< cost of the path [m], or [s] where the cost is the time
  CostOptions rule = {};  ///< prices that were minimised; all of them are set
  /// Proven lower bound of the cost of every path [m] or [s]; above 0. None: nothing is proven.
  std::optional<double> lower_bound = {};
  std::int64_t iterations = 0;            ///< iterations that the run has spent
  double time_total = 0.0;                ///< time of the run, without the judge [s]
  std::vector<CostSample> anytime = {};   ///< moments at which the best path became cheaper
  std::vector<Counter> counters = {};     ///< counts of the planner, by names of its own
  std::vector<PhaseTime> phases = {};     ///< times of phases, if they were asked for
  std::optional<TreeSnapshot> tree = {};  ///< search tree, if it was asked for
  /// The judge's verdict on the path, or on a path that it rejected.
  std::optional<PathCheck> check = {};
  /// Speeds along the path, if the problem has moving obstacles.
  std::optional<SpeedProfile> speeds = {};
  /// The judge's verdict on these speeds, or on speeds that it rejected.
  std::optional<DriveCheck> drive_check = {};
};

/// The count of that name; 0 if the planner has none.
[[nodiscard]] std::int64_t counter(const PlanResult& result, std::string_view name) noexcept;

/// The planners of the library, the default planner first.
[[nodiscard]] std::span<const Planner> planners();

/// The planner that is used when none is named.
[[nodiscard]] const Planner& default_planner();

/// The default planner with a warm start from a path that was good for a similar problem: its
/// start, goal or obstacles were a little different. If a path along `path` is free, it is the
/// first one, and the planner improves it before it looks for others.
///
/// `path` is in the scenario's frame. It is ignored among moving obstacles. Throws InputError
/// naming "segments[3]" for a segment that is not finite. The numbers of `path.start` must be
/// finite, too; they are not checked.
[[nodiscard]] Planner warm_started(const Path& path);

/// The planner of that name; none if there is no such planner. For a search that is guided by an
/// estimate, the estimate may stand behind a colon: "hrrt:hlut-4". "hrrt:max-hlut-4-bound" takes
/// the larger of two estimates. It knows the thesis' trees with the estimate "site", too, which are
/// not among `planners()`: "rrt-opt-site".
[[nodiscard]] std::optional<Planner> find_planner(std::string_view name);

/// The planner of that name, as `find_planner` knows it. Throws InputError naming "planner" if
/// there is none; the message lists all planners, or all estimates.
[[nodiscard]] Planner planner_named(std::string_view name);

/// The options in force: all prices, the steering and the planner's own options are set. `plan`,
/// the command line, Python and the evaluation get their defaults here, and only here. Completing
/// twice changes nothing.
///
/// - Prices that are not set are those of the style for that vehicle.
/// - A path for a vehicle with a trailer is made of arcs and lines, unless another steering is
///   asked for or the cost is the time.
/// - A run without a limit of time or iterations gets `default_time_limit`.
///
/// Throws InputError naming the first option that is out of range or that the planner does not
/// honour; the message lists the planners that do. Values without effect are accepted: defaults,
/// style `shortest` and its prices, and steering reeds-shepp. The error also names:
///
/// - a price that has an effect although the cost is the time,
/// - "estimate" for the estimate "table" without a table, "table" for a table that is not used,
/// - "site" for the estimate "site" without a table of the site, or for one that is not used,
/// - "planner" if the planner cannot plan with a trailer, "steering" if not with that steering.
[[nodiscard]] PlanOptions complete(const Planner& planner, const PlanOptions& options = {},
                                   const Vehicle& vehicle = {});

/// Whether a planner honours an option of that name: one of its own or one of all planners.
[[nodiscard]] bool honours(const Planner& planner, std::string_view option);

/// Whether an estimate of the planner, with these options, has that name: "table" looks up
/// `PlanOptions::table`, "site" looks up `PlanOptions::site`.
[[nodiscard]] bool asks_for_estimate(const Planner& planner, const PlanOptions& options,
                                     std::string_view name);

/// Sets an option for a planner by name from text, as `--set` does. "style" resets the cost to
/// `prices`, all prices and the steering; another "cost" resets the prices. Throws InputError
/// naming the option if it does not exist, the value is not valid, or the planner does not honour
/// it and the value has an effect (see `complete`).
void set_option(PlanOptions& options, const Planner& planner, std::string_view name,
                std::string_view text);

/// Place of an option among options that are given together: those that reset others are set first.
/// 0: "style"; 1: "cost"; 2: all others. So "cost=time" beside "style=shortest" is the fastest
/// drive on arcs and lines, whichever stands first.
[[nodiscard]] int setting_order(std::string_view option) noexcept;

/// Sets those options that the planner honours, in the order of `setting_order`, and skips the
/// others. Throws InputError naming the option whose value is not valid, or "gears" if one gear is
/// asked for and the planner does not honour that.
void set_honoured(PlanOptions& options, const Planner& planner, std::span<const Setting> settings);

/// Plans a path. A run without a limit of time or iterations takes `default_time_limit`. The path
/// that is returned has passed the judge.
///
/// The status is `rejected` if the judge rejects the planner's path or its speeds, or if the
/// planner's answer contradicts itself. The result then has no path, and `reason` says why. `check`
/// is the verdict on a path, `drive_check` that on speeds; a verdict is missing if nothing was
/// judged. Throws InputError naming:
///
/// - an option that `complete` refuses,
/// - "problem" if `make_problem` did not make it,
/// - "planner" if it has no function,
/// - "moving" if there are moving obstacles and the planner does not honour them.
[[nodiscard]] PlanResult plan(const Problem& problem, const Planner& planner,
                              const PlanOptions& options = {});

/// Plans a path with the default planner. Throws InputError naming an option that is wrong.
[[nodiscard]] PlanResult plan(const Problem& problem, const PlanOptions& options = {});

/// Plans a path for a scenario with the default planner. Throws InputError naming the key of the
/// scenario or the option that is wrong.
[[nodiscard]] PlanResult plan(const Scenario& scenario, const PlanOptions& options = {});

/// Plans many problems, `jobs` at a time, with equal options; `jobs` below 1 counts as 1.
/// `take(i, result)` is called once for each problem, one call at a time, in the order of the
/// problems. With several jobs it runs on any of the threads that plan, not only on the caller's.
/// Throws what a planner or `take` throws.
void plan_many(std::span<const Problem> problems, const Planner& planner,
               const PlanOptions& options, int jobs,
               const std::function<void(std::size_t, PlanResult)>& take);

// ---- How do I let the default planner use paths that I know of? ----
//
//   const auto result = vandplan::plan(problem, vandplan::with_sources({{"mine", make}}));
//
// A source proposes paths while the planner runs. The planner checks and shortens each, and
// compares it with the paths that it finds itself. Whatever a source proposes, the result has
// passed the judge.

/// A path in the frame of a task, which is the world's.
struct LocalPath {
  LocalPose start;
  std::vector<Segment> segments;
};

/// Proposes paths in one run. Calls come one after the other, from any thread of the run. Results
/// repeat if the source depends only on the seed and on what `hear` is given.
class PathSource {
 public:
  virtual ~PathSource() = default;

  /// A path, or none yet: one iteration of the run, at best some ten microseconds of work. The path
  /// is in the frame of the task. It may begin or end elsewhere, or hit something: the planner
  /// makes a free path along it, if it can. A number that is not finite ends the run with
  /// InputError.
  [[nodiscard]] virtual std::optional<LocalPath> propose() = 0;

  /// Whether another call of `propose` may bring a path. The run ends when none of the planner's
  /// workers has work.
  [[nodiscard]] virtual bool has_work() const = 0;

  /// Receives the cheapest path so far, in the frame of the task, and its cost [m]. It is called
  /// when the planner has a cheaper path, whoever proposed it.
  virtual void hear(const LocalPath& /*best*/, double /*cost*/) {}
};

/// A source of paths under a name, with its share of the work.
struct NamedSource {
  std::string name;  ///< name of the source; error messages have it
  /// Makes the source for one run; required. The task and the options outlive the source. Start and
  /// goal of the task are free.
  std::function<std::unique_ptr<PathSource>(const Task&, const PlanOptions&)> make;
  /// Iterations of the source in a round while no path is known; [1, 10000]. The round after the
  /// first path has a quarter of it. Later rounds have up to 16 times as much.
  std::int64_t share = 16;
};

/// The default planner, with sources of paths beside its own workers. For a vehicle with a trailer
/// a path is that of the tractor. Throws InputError naming "source NAME" if it has no `make` or its
/// share is out of range.
[[nodiscard]] Planner with_sources(std::vector<NamedSource> sources);

// ---- How does a path become cheaper, and one that the wheels can follow? ----
//
//   const auto smoothed = vandplan::smooth(problem, path, SmoothMethod::optimised);
//
// Method: docs/algorithms/smooth.md.

/// Method by which a path is smoothed.
enum class SmoothMethod : std::uint8_t {
  clothoids,  ///< joints become clothoids; what becomes longer is shortened briefly
  optimised,  ///< the whole path is made cheaper for as long as the budget lasts
};

/// The method of that name, "clothoids" or "optimised". Throws InputError naming "method" for
/// another name.
[[nodiscard]] SmoothMethod smooth_method_named(std::string_view name);

/// The options of smoothing that hold unless others are set. Options of the run that planned the
/// path (`stored`) take precedence over those that the scenario wants.
///
/// The budget of that run does not count, nor a stored steering of reeds-shepp. Such a run allowed
/// jumps of the curvature, and smoothing removes them; with a trailer only if the cost is the time.
/// Throws InputError naming the option whose value is not valid.
[[nodiscard]] PlanOptions smooth_options(std::span<const Setting> scenario,
                                         std::span<const Setting> stored);

/// Result of smoothing a path.
struct Smoothed {
  PlanResult result = {};    ///< result of `plan` with the smoothed path
  PlanOptions options = {};  ///< options that were in force
  /// Cost of the path that was given, by these options [m] or [s].
  double given_cost = 0.0;
  /// Fault that the judge finds in the given path, by these options; empty: none. That the path
  /// ends at no goal of a set is no fault (see `smooth`).
  std::string given_fault = {};
  /// Whether the result is the path that was given, because nothing better was found.
  bool is_given = false;
};

/// Smooths a path in the scenario's frame. If the judge accepts the given path, the result is never
/// worse by these options: it costs no more, and strokes shorter than `min_stroke` become no
/// shorter in total.
///
/// With a set of goals, the goal is the one at which the path ends; a path that ends at none is
/// `rejected`. What leads to the straight last stretch that the goal asks for is smoothed. Past
/// vias each leg is smoothed, and vias slide along their sets. A run without a limit of time or
/// iterations takes `default_time_limit`.
///
/// Throws InputError as `plan` does, also naming "moving" if there are moving obstacles, and "path"
/// if it has a number that is not finite.
[[nodiscard]] Smoothed smooth(const Problem& problem, const Path& path,
                              SmoothMethod method = SmoothMethod::optimised,
                              const PlanOptions& options = {});

/// The planner that `smooth` runs: it keeps to the way of one path, whose segments lead from the
/// problem's start to its goal. The start of `path` is not used. Unless a steering is set, it is
/// `continuous_between_stops`, also with style `shortest`. With a trailer it is `reeds_shepp`,
/// unless the cost is the time. The planner is not among `planners()`.
///
/// - A path that is nearer than a millimetre to something may count as blocked.
/// - It finds no path where one beside the given path is needed that it does not see. Then
///   `no_path` proves nothing.
[[nodiscard]] Planner smoother(const Path& path, SmoothMethod method);

}  // namespace vandplan
