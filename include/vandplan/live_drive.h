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

/// What a vehicle believes about others that it sees.
enum class Prediction : std::uint8_t {
  known,              ///< their trajectories, as the scenario has them
  constant_velocity,  ///< they go on as in the last tenth of a second, up to the horizon
};

/// "known" or "constant-velocity".
[[nodiscard]] std::string_view name_of(Prediction prediction) noexcept;

struct LiveDriveOptions {
  ReplanOptions replan = {};
  double period = 0.1;  ///< between ticks, a multiple of 0.02 [s]; 0.02 to 10
  /// So far away the vehicle sees cells, obstacles and movers [m]; > 0; none: it knows them all.
  std::optional<double> sensor_range = {};
  Prediction prediction = Prediction::known;
  double horizon = 6.0;      ///< of a constant velocity [s]; 0.1 to 100
  DriveOptions drive = {};   ///< its `reserve` is that of `replan`
  double longest = 600.0;    ///< the drive ends after that, wherever the vehicle is [s]; > 0
  double action_rate = 0.0;  ///< of actions [1/s]; 0: there are none; at most 1000
};

/// What came of it.
struct LiveDriveResult {
  bool has_arrived = false;
  double duration = 0.0;  ///< [s]
  int ticks = 0;
  int ticks_without_answer = 0;   ///< with an answer that is not safe
  int stops = 0;                  ///< standstills on the way
  int new_ways = 0;               ///< after the first one
  int new_times = 0;              ///< along the same way
  int stopping_ticks = 0;         ///< without a drive to the goal
  double end_distance = 0.0;      ///< of the rear axle from the goal [m]
  double end_heading = 0.0;       ///< difference of the heading there, without sign [rad]
  double clearance = 0.0;         ///< from what stands, least at steps of 5 ms [m]; or infinite
  double moving_clearance = 0.0;  ///< from what moves, as `DriveCheck` has it [m]; or infinite
  std::optional<Contact> contact = {};  ///< the first one, with what stands or moves
  TimedPath driven = {};                ///< in the scenario's frame, in arcs of 5 ms
  std::vector<DriveMoment> log = {};
};

/// Drives a scenario from its start to its goal in a closed loop: a replanner, a controller, a
/// vehicle with delay and noise, and an eye on what it touches. Calls `on_action` for each action
/// that the answers ask for. Repeats bit for bit without a time limit. Throws InputError as
/// `Replanner` and `drive` do, and naming "period", "sensor_range", "horizon", "longest" or
/// "action_rate".
[[nodiscard]] LiveDriveResult drive_live(const Scenario& scenario,
                                         const LiveDriveOptions& options = {},
                                         const std::function<void(const Action&)>& on_action = {});

}  // namespace vandplan
