// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What happens when a vehicle drives to its goal, sees what comes, and plans anew at every tick?
//
// Method: docs/algorithms/replanning.md.

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "vandplan/drive.h"
#include "vandplan/moving.h"
#include "vandplan/problem.h"
#include "vandplan/replanner.h"

namespace vandplan {

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
