// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a vehicle plan anew while it drives, in a world that changes?
//
//   Replanner replanner(scenario);
//   for (double t = 0; ...; t += 0.1) {
//    replanner.patch(seen);             // what of the ground is new
//    replanner.set_moving(predicted);   // who moves how, from now on
//    const ReplanAnswer answer = replanner.tick(t);
//    if (answer.has_arrived) break;
//   }
//
// Method: docs/algorithms/replanning.md.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/drive.h"
#include "vandplan/geometry.h"
#include "vandplan/motion.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {

class ChangingSiteTable;

namespace replanning {
class KnownGround;
}

/// A rectangle of cells of the map with new contents.
struct CellPatch {
  std::int32_t column = 0;       ///< column of the first cell
  std::int32_t row = 0;          ///< row of the first cell
  std::int32_t columns = 0;      ///< number of columns
  std::int32_t rows = 0;         ///< number of rows
  std::vector<Cell> cells = {};  ///< all cells, row by row: columns * rows of them
};

/// A rectangle of cells of a mask that limits speeds or has prices, with new contents.
struct MaskPatch {
  std::size_t mask = 0;                     ///< number of the mask, which has `percents`
  CellRange range = {};                     ///< the cells
  std::vector<std::uint8_t> percents = {};  ///< all their percentages, row by row
};

/// An obstacle that may come and go. The obstacles of the scenario are called 0, 1, ... in their
/// order.
struct NamedPolygon {
  std::int64_t name = 0;  ///< name of the obstacle
  Polygon outline = {};   ///< outline in the scenario's frame [m]
};

/// A change of the ground.
struct WorldPatch {
  std::vector<CellPatch> cells = {};  ///< cells with new contents
  std::vector<MaskPatch> masks = {};  ///< cells of masks with new contents
  /// New obstacles; one with a known name replaces the old one.
  std::vector<NamedPolygon> added = {};
  /// Names of obstacles that are gone. Unknown names are ignored: what is reported as gone may
  /// never have been seen.
  std::vector<std::int64_t> removed = {};
  /// Whether the patch changes nothing.
  [[nodiscard]] bool is_empty() const noexcept {
    return cells.empty() && masks.empty() && added.empty() && removed.empty();
  }
};

/// A world that patches change. It is equal to a world of the changed surroundings, but what was
/// made of the rest of a large map is kept.
///
///   ChangingWorld ground(surroundings(scenario), {scenario.start.x, scenario.start.y});
///   ground.patch({.cells = {window}});
///   plan(make_problem(ground.world(), vehicle, start, goal));
class ChangingWorld {
 public:
  /// Makes the world of `surroundings` and `near`, as `World` does. Throws InputError as `World`.
  ChangingWorld(const Surroundings& surroundings, const Point& near);
  ~ChangingWorld();
  ChangingWorld(ChangingWorld&&) noexcept;
  ChangingWorld& operator=(ChangingWorld&&) noexcept;

  /// Changes the world in place, with outlines in the scenario's frame. Problems and checkers that
  /// were made in it before must not be used any more. Throws InputError as `Replanner::patch`; the
  /// world then stays as it was.
  void patch(const WorldPatch& patch);

  /// The world as it is now. Every call gives the one object that patches change.
  [[nodiscard]] std::shared_ptr<const World> world() const noexcept;

 private:
  std::unique_ptr<replanning::KnownGround> ground_;
};

/// Options of replanning.
struct ReplanOptions {
  /// Options of the paths, without a `site`. The budget is that of the first plan; without one it
  /// has 20 000 iterations.
  PlanOptions plan = {};
  /// Table of the site (site_table.h) that all plans begin with, for this vehicle and these prices.
  /// A tick after a patch first repairs the ways to its goal, some 0.05 s of work, or goes on with
  /// that for at most half of its time limit. None: no plan knows the site. Replanners may share a
  /// table; it is not for several threads at once.
  std::shared_ptr<ChangingSiteTable> site = {};
  std::int64_t tick_iterations = 100;  ///< iterations of each later look for a better way; >= 0
  /// States of each search for speeds among moving obstacles; >= 1.
  std::int64_t tick_states = 2'000;
  double committed = 1.0;  ///< time for which an answer stays as it is, if it can [s]; [0, 60]
  /// Share by which a new way must reduce the cost of the rest to be taken; [0, 1].
  double better = 0.1;
  /// Share of steering rate, acceleration and braking that planned speeds leave for corrections;
  /// [0.01, 0.5].
  double reserve = 0.1;
};

/// Outcome of a tick.
enum class TickOutcome : std::uint8_t {
  kept,       ///< the drive goes on as it was
  new_times,  ///< the drive follows the same way with other speeds
  new_way,    ///< the drive follows another way
  stop,       ///< no drive to the goal was found: it ends in an earlier standstill that is safe
  /// No safe drive was found either: the vehicle brakes, or goes on if that touches something
  /// later.
  none,
};

/// Name of the outcome: "kept", "new_times", ...
[[nodiscard]] std::string_view name_of(TickOutcome outcome) noexcept;

/// Answer of a tick: the drive of the vehicle from now on.
struct ReplanAnswer {
  TickOutcome outcome = TickOutcome::none;
  double begin = 0.0;  ///< time at which the drive begins or began [s]
  /// The drive in the scenario's frame. At time `begin + t` the vehicle is where the drive is at t.
  /// It ends in a standstill.
  std::shared_ptr<const TimedPath> drive = {};
  double start_speed = 0.0;        ///< speed with which the drive begins [m/s]; never negative
  double start_hitch_angle = 0.0;  ///< hitch angle with which it begins [rad]; 0 without a trailer
  bool reaches_goal = false;       ///< whether the drive ends at the goal, not on the way
  /// Whether the vehicle stands at the goal: the drive reaches it and is over, and the measured
  /// speed, if there is one, is at most 0.05 m/s.
  bool has_arrived = false;
  /// Whether the judge accepts the rest of the drive. It touches nothing that stands or moves, then
  /// or ever after, as far as ground and moving obstacles are known. It also keeps the margin,
  /// unless it ends in a standstill on the way (outcome `stop`, or `kept` after it).
  bool is_safe = false;
  /// Reason why the drive is not safe or does not reach the goal; otherwise empty.
  std::string reason = {};
  /// Reason why this tick left the table of the site aside: it lacks the goal, or could not be
  /// repaired in time. Empty if plans had the table, or there is none.
  std::string without_site = {};
};

/// Limit of the time of one tick. Answers of ticks without a limit repeat bit for bit.
struct TickLimit {
  /// Time within which the tick answers [s]; >= 0; none: no limit. The clock is that of
  /// `ReplanOptions::plan`. The search for better drives ends 10 ms before, or after half of a
  /// shorter limit. The rest is left for the judge, and for the search for a standstill if no drive
  /// was found: the nearest one is always tried. A judgement that has begun is not cut short.
  std::optional<double> time_limit = {};
  std::stop_token stop = {};  ///< when this is asked to stop, the tick answers as if time were over
};

/// Measured state of the vehicle.
struct VehicleState {
  Pose pose = {};          ///< pose in the scenario's frame
  double v = 0.0;          ///< speed [m/s]; negative in reverse
  double curvature = 0.0;  ///< curvature of the wheels [1/m]
  /// Hitch angle [rad]; [-pi, pi], 0 without a trailer. None: that of the last answer. Up to 10
  /// degrees beyond `Vehicle::max_hitch_angle` the plan begins at that limit. Further beyond, no
  /// drive is safe.
  std::optional<double> hitch_angle = {};
};

/// A steering command and a speed for one time.
struct Action {
  double t = 0.0;               ///< time [s]
  double steering_angle = 0.0;  ///< front-wheel angle of a bicycle [rad]; positive to the left
  double v = 0.0;               ///< speed [m/s]; negative in reverse
  double a = 0.0;               ///< change of v [m/s^2]
};

/// The action that an answer asks for at time `t` [s]. Throws InputError naming "answer" before the
/// first tick.
[[nodiscard]] Action action_at(const ReplanAnswer& answer, const Vehicle& vehicle, double t);

/// Plans again and again for one vehicle on its way to a goal. Vias are dropped as its drives pass
/// them, and stay when the goal changes. Equal calls give equal answers, bit for bit. Not for
/// several threads at once.
class Replanner {
 public:
  /// Begins with a scenario, whose moving obstacles are known from the start. Throws InputError
  /// naming the key of the scenario or the option that is wrong. It names "vehicle.max_jerk" if the
  /// vehicle has one, which is not honoured, and "site" for a table of another vehicle or prices.
  explicit Replanner(const Scenario& scenario, const ReplanOptions& options = {});
  ~Replanner();
  Replanner(Replanner&&) noexcept;
  Replanner& operator=(Replanner&&) noexcept;

  /// Changes the ground from now on. Throws InputError naming "cells[0]" for cells that are not on
  /// the map (or without a map), "cells[0].cells" for a wrong number of cells, "masks[0]" for
  /// percentages that a mask cannot have there, or "added[0].outline" for a polygon that is not
  /// simple. The ground then stays as it was.
  void patch(const WorldPatch& patch);

  /// Sets all moving obstacles from now on, in the scenario's frame and with times of this
  /// replanner's clock. Throws InputError naming "moving[2].outline" or another key; the obstacles
  /// then stay as they were.
  void set_moving(std::span<const MovingObstacle> moving);

  /// Drives to another goal from now on, in the scenario's frame, with straight wheels and trailer
  /// there. The drive stays as it is until a tick finds one to the new goal; a vehicle that stands
  /// at the end of its drive plans once with the budget of the first plan. Throws InputError naming
  /// "goal" or "goal.x"; the old goal then stays.
  void set_goal(const Pose& goal);
  /// Drives to any goal of a set from now on. Throws InputError naming "goal.any_of[2].heading" or
  /// another key as `with_goal_set` does; the old goal then stays.
  void set_goal(const std::vector<GoalRegion>& set);

  /// Plans at time `t` [s] for a vehicle that follows the last answer. The answer holds until the
  /// next tick. Throws InputError naming "t" for a time before the last tick, or "time_limit"; the
  /// answer then stays as it was.
  ReplanAnswer tick(double t, const TickLimit& limit = {});

  /// Plans at time `t` [s] for a vehicle in that state. Beyond 0.5 m, 0.5 m/s or 10 degrees of
  /// heading or hitch angle from the last answer the plan begins at the state, otherwise at the
  /// planned state. The first tick begins at the scenario's start and ignores the state. Throws
  /// InputError naming "t", "state.pose", "state.v", "state.curvature" or "state.hitch_angle" that
  /// is not finite or out of range; the answer then stays as it was.
  ReplanAnswer tick(double t, const VehicleState& state, const TickLimit& limit = {});

  /// The answer of the last tick; it has no drive before the first one.
  [[nodiscard]] ReplanAnswer answer() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

// ---- What happens when a vehicle drives like that to its goal? ----
//
// Method: docs/algorithms/replanning.md.

/// What a vehicle assumes about the motion of the obstacles that it sees.
enum class Prediction : std::uint8_t {
  known,              ///< trajectories of the scenario
  constant_velocity,  ///< velocity over the last 0.1 s, up to the horizon
};

/// Name of the prediction: "known" or "constant-velocity".
[[nodiscard]] std::string_view name_of(Prediction prediction) noexcept;

/// Options of a drive with replanning.
struct LiveDriveOptions {
  ReplanOptions replan = {};  ///< options of the replanner; `drive.reserve` replaces its reserve
  double period = 0.1;        ///< time between ticks [s]; a multiple of 0.02, in [0.02, 10]
  /// Distance up to which the vehicle sees cells and obstacles, moving ones too [m]; above 0, up to
  /// 1e4. None: it knows all of them.
  std::optional<double> sensor_range = {};
  /// Motion that moving obstacles are predicted to have.
  Prediction prediction = Prediction::known;
  double horizon = 6.0;     ///< time up to which a constant velocity is predicted [s]; [0.1, 100]
  DriveOptions drive = {};  ///< controller, noise and delay; `keep_log` fills the log
  /// Time after which the drive ends, wherever the vehicle is [s]; above 0, up to 1e5.
  double longest = 600.0;
  double action_rate = 0.0;  ///< calls of `on_action` per second [1/s]; [0, 1000]; 0: none
};

/// Result of a drive with replanning. Poses are in the scenario's frame.
struct LiveDriveResult {
  bool has_arrived = false;      ///< whether the vehicle stands at its goal
  double duration = 0.0;         ///< duration of the drive [s]
  int ticks = 0;                 ///< number of ticks
  int ticks_without_answer = 0;  ///< ticks whose answer is not safe
  int stops = 0;                 ///< standstills on the way
  int new_ways = 0;              ///< ticks that chose another way, without the first tick
  int new_times = 0;             ///< ticks that chose other speeds along the same way
  int stopping_ticks = 0;        ///< ticks without a drive to the goal
  double end_distance = 0.0;     ///< distance of the rear axle from the goal [m]
  double end_heading = 0.0;      ///< difference of the heading from the goal's, without sign [rad]
  /// Least clearance from standing obstacles at steps of 5 ms [m]; or infinite.
  double clearance = 0.0;
  /// Least clearance from moving obstacles, as `DriveCheck` has it [m]; or infinite.
  double moving_clearance = 0.0;
  /// First contact with a standing or moving obstacle.
  std::optional<Contact> contact = {};
  TimedPath driven = {};              ///< the path driven, in arcs of 5 ms
  std::vector<DriveMoment> log = {};  ///< moments every 0.02 s, if they were asked for
};

/// Drives a scenario from its start to its goal in a closed loop of replanner, controller and
/// vehicle, with delay and noise, and watches for contacts. Calls `on_action` for each action that
/// the answers ask for. Results repeat bit for bit without a time limit.
///
/// Throws InputError as `Replanner` and `drive` do, and naming "period", "sensor_range", "horizon",
/// "longest" or "action_rate".
[[nodiscard]] LiveDriveResult drive_live(const Scenario& scenario,
                                         const LiveDriveOptions& options = {},
                                         const std::function<void(const Action&)>& on_action = {});

}  // namespace vandplan
