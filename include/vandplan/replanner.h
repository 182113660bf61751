// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a vehicle plan anew while it drives, in a world that changes?
//
//   Replanner replanner(scenario);
//   for (double t = 0; ...; t += 0.1) {
//     replanner.patch(seen);             // what of the ground is new
//     replanner.set_moving(predicted);   // who moves how, from now on
//     const ReplanAnswer& answer = replanner.tick(t);
//   }
//
// Method: docs/algorithms/replanning.md.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/moving.h"
#include "vandplan/occupancy_grid.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/speed.h"

namespace vandplan {

/// A rectangle of cells of the map, seen anew.
struct CellPatch {
  std::int32_t column = 0;  ///< of its first cell
  std::int32_t row = 0;
  std::int32_t columns = 0;
  std::int32_t rows = 0;
  std::vector<Cell> cells = {};  ///< row by row: columns * rows of them
};

/// An obstacle that may come and go. Those of the scenario are called 0, 1, ... in their order.
struct NamedPolygon {
  std::int64_t name = 0;
  Polygon outline = {};  ///< in the scenario's frame
};

/// What of the ground has changed.
struct WorldPatch {
  std::vector<CellPatch> cells = {};
  std::vector<NamedPolygon> added = {};    ///< one of a known name takes the place of that
  std::vector<std::int64_t> removed = {};  ///< names; one that is not there is no error
  [[nodiscard]] bool is_empty() const noexcept {
    return cells.empty() && added.empty() && removed.empty();
  }
};

/// How to plan again and again.
struct ReplanOptions {
  /// Of the paths. The budget is that of the first plan; without one it has 20 000 iterations.
  PlanOptions plan = {};
  std::int64_t tick_iterations = 100;  ///< of each later look for a better way; >= 0
  std::int64_t tick_states = 2'000;    ///< of each search for speeds among what moves; >= 1
  double committed = 1.0;              ///< so long an answer stays as it is, if it can [s]; >= 0
  /// A new way is taken only if what is left costs less by this share; 0 to 1.
  double better = 0.1;
  /// Share of steering rate, acceleration and braking that planned speeds leave for corrections;
  /// 0.01 to 0.5.
  double reserve = 0.1;
};

/// What a tick brought.
enum class TickOutcome : std::uint8_t {
  kept,       ///< the drive goes on as it was
  new_times,  ///< along the same way, with other speeds
  new_way,    ///< along another way
  stop,       ///< no drive to the goal was found: it ends in an earlier standstill that is safe
  none,       ///< none was found that is safe, either: the vehicle brakes as hard as it may
};

/// "kept", "new_times", ...
[[nodiscard]] std::string_view name_of(TickOutcome outcome) noexcept;

/// What the vehicle is to do from now on.
struct ReplanAnswer {
  TickOutcome outcome = TickOutcome::none;
  double begin = 0.0;  ///< when the drive begins or began [s]
  /// In the scenario's frame; at time `begin + t` the vehicle is where the drive is at t. It ends
  /// in a standstill.
  std::shared_ptr<const TimedPath> drive = {};
  double start_speed = 0.0;   ///< with which the drive begins [m/s]
  bool reaches_goal = false;  ///< else it ends in a standstill on the way
  /// Judged: the rest of the drive touches nothing and nobody, then or ever after, as far as is
  /// known of ground and movers.
  bool is_safe = false;
  std::string reason = {};  ///< why it is not safe, or does not reach the goal; else empty
};

/// Where the vehicle is, as measured.
struct VehicleState {
  Pose pose = {};          ///< in the scenario's frame
  double v = 0.0;          ///< negative in reverse [m/s]
  double curvature = 0.0;  ///< that the wheels are turned to [1/m]
};

/// A steering command, and how fast to drive.
struct Action {
  double t = 0.0;               ///< [s]
  double steering_angle = 0.0;  ///< of the front wheel of a bicycle [rad]; positive to the left
  double v = 0.0;               ///< negative in reverse [m/s]
  double a = 0.0;               ///< change of v [m/s^2]
};

/// What an answer asks for at a time [s]. Throws InputError before the first tick.
[[nodiscard]] Action action_at(const ReplanAnswer& answer, const Vehicle& vehicle, double t);

/// One vehicle on its way to one goal. Same calls, same answers, bit for bit. Not for several
/// threads at once.
class Replanner {
 public:
  /// What moves in the scenario is known from the start. Throws InputError naming what is wrong
  /// with the scenario or an option, "vehicle.trailers" or "vehicle.max_jerk" where there is one:
  /// neither is honoured.
  explicit Replanner(const Scenario& scenario, const ReplanOptions& options = {});
  ~Replanner();
  Replanner(Replanner&&) noexcept;
  Replanner& operator=(Replanner&&) noexcept;

  /// The ground is different from now on. Throws InputError naming a polygon that is none, or cells
  /// that are not on the map; the ground is as it was then.
  void patch(const WorldPatch& patch);

  /// Who else moves from now on, in the scenario's frame and with times of this replanner's clock.
  /// Throws InputError naming what is wrong; the movers are as they were then.
  void set_moving(std::span<const MovingObstacle> moving);

  /// Plans at time `t` for a vehicle that follows the last answer. The answer holds until the next
  /// tick. Throws InputError for a time before that of the last tick; the answer is as it was then.
  const ReplanAnswer& tick(double t);

  /// The same for a vehicle that may be somewhere else: beyond half a metre, half a metre per
  /// second or 10 degrees from the last answer it plans from where it is. Throws InputError, too,
  /// for a state that is no number or out of range; the answer is as it was then.
  const ReplanAnswer& tick(double t, const VehicleState& state);

  [[nodiscard]] const ReplanAnswer& answer() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vandplan
