// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What happens when a path is driven by a vehicle with wheels that take time to turn, a controller,
// a delay and noise?
//
// Method: docs/algorithms/drive.md.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/problem.h"

namespace vandplan {

/// A way to steer a vehicle along a path.
struct ControllerInfo {
  std::string_view name;     ///< "rear-axle-feedback"
  std::string_view summary;  ///< half a sentence
  bool drives_reverse;       ///< whether it can follow a path with metres in reverse
  bool steers_trailer;       ///< whether it can do so with a trailer, which runs away in reverse
};

/// All controllers: "rear-axle-feedback", "lqr", "pure-pursuit", "stanley".
[[nodiscard]] std::span<const ControllerInfo> controllers() noexcept;

/// The one that drives where none is named: "rear-axle-feedback", with a trailer "lqr".
[[nodiscard]] std::string_view usual_controller(const Vehicle& vehicle) noexcept;

/// How a path is driven.
struct DriveOptions {
  std::string controller = {};  ///< one of `controllers`; empty: `usual_controller`
  /// How wrong sensors and actuators are; 0 to 10; 0: not at all. 1: measured positions are off by
  /// 2 cm along x and y, headings and hitch angles by 0.2 degrees, anew at each of 50 measurements
  /// a second; for the whole drive the wheels are turned 0.2 degrees and 1 % further than they say,
  /// and the vehicle is 1 % faster. All of these are standard deviations of normal distributions.
  double noise = 0.0;
  double delay = 0.0;  ///< from a measurement to what follows from it [s]; 0 to 1
  /// Share of steering rate, acceleration and braking that the planned speeds leave for
  /// corrections; 0 to 0.5.
  double reserve = 0.1;
  /// What the plan leaves to correct with; 0 to 0.5. The wheels can make a curvature larger by this
  /// share than `min_turning_radius` says, and a rig folds up further by it than `max_hitch_angle`
  /// says. At 0 nobody can steer against what drives out of the tightest turn.
  double spare_steering = 0.0;
  std::uint64_t seed = 1;  ///< of the noise
  bool keep_log = false;   ///< `DriveResult::log` is filled
};

/// Where a driven vehicle is, how it moves, and how far that is from the plan.
struct DriveMoment {
  double t = 0.0;                ///< since the start [s]
  double s = 0.0;                ///< distance along the planned path beside which it is [m]
  Pose pose = {};                ///< in the frame of the path
  int direction = 1;             ///< 1 forward, -1 reverse
  double v = 0.0;                ///< speed; negative in reverse [m/s]
  double steering_angle = 0.0;   ///< of the front wheel of a bicycle [rad]; positive to the left
  double wanted_steering = 0.0;  ///< angle that the controller asks for now [rad]
  double wanted_acceleration = 0.0;  ///< along the path [m/s^2]; negative: it brakes
  double lateral_error = 0.0;  ///< of the rear axle; positive: left of the path, seen forward [m]
  double heading_error = 0.0;  ///< in [-pi, pi) [rad]; positive: turned to the left of the path
  std::optional<double> hitch_angle = {};  ///< of a trailer [rad]
};

/// The moment when a vehicle touches something for the first time.
struct Contact {
  double t = 0.0;    ///< since the start [s]
  double s = 0.0;    ///< distance along the planned path [m]
  Pose pose = {};    ///< of the vehicle, in the frame of the path
  std::string what;  ///< "the footprint hits obstacles[3]", "the rig folds up (jackknife)"
};

/// How a trailer keeps to where it would be behind a tractor that is on the path.
struct TrailerDeviation {
  double largest_lateral = 0.0;  ///< of its axle's midpoint, across its heading [m]
  double rms_lateral = 0.0;      ///< root of the mean square along the way of the tractor [m]
  double end_distance = 0.0;     ///< of its axle's midpoint from where it should end [m]
  double end_heading = 0.0;      ///< difference of the heading there, without sign [rad]
  /// How much further the rig folded up than it would beside there [rad]: a path that was planned
  /// with a `Vehicle::max_hitch_angle` less by that does not fold up too far.
  double hitch_deviation = 0.0;
};

/// What came of a drive. After a contact it goes on as if there had been none.
struct DriveResult {
  bool has_arrived = false;       ///< it stands at the end of the path, as far as it can tell
  double duration = 0.0;          ///< [s]
  double planned_duration = 0.0;  ///< of the fastest drive that leaves the reserve [s]
  double largest_lateral = 0.0;   ///< distance of the rear axle from the path [m]
  double rms_lateral = 0.0;       ///< root of the mean square along the driven way [m]
  double largest_heading = 0.0;   ///< difference of the headings [rad]
  double rms_heading = 0.0;       ///< [rad]
  double end_distance = 0.0;      ///< of the rear axle from the end of the path [m]
  double end_heading = 0.0;       ///< difference of the heading there, without sign [rad]
  std::optional<TrailerDeviation> trailer = {};  ///< if there is one
  /// How far the outline of body, wheels or trailer was beyond where it would be on the path [m]: a
  /// path with a margin of at least that much is driven without contact.
  double outline_deviation = 0.0;
  /// How far the rear axle was outside of the bounds [m]; nothing is touched there.
  double out_of_bounds = 0.0;
  double clearance = 0.0;  ///< least at the ends of all steps of 5 ms [m]; infinite without things
  std::optional<Contact> contact = {};
  std::vector<DriveMoment> log = {};  ///< every 0.02 s, if it was asked for
};

/// Drives a path (in the scenario's frame) from standing to standing with the speeds of
/// `speed_profile` for limits less the reserve, and looks at everything that footprint, wheels and
/// trailer sweep. At the start the wheels are turned as `Problem::curvatures` says, and the trailer
/// as `Problem::hitch_angles`. Repeats bit for bit.
/// Throws InputError naming "controller", "noise", "delay", "reserve" or "spare_steering", a limit
/// of the vehicle, or a segment that is not finite or turns more sharply than the vehicle can.
[[nodiscard]] DriveResult drive(const Problem& problem, const Path& path,
                                const DriveOptions& options = {});

/// How a path is driven without looking: every millisecond, or every millionth of a drive that
/// takes longer than 1000 s, the speed is that of the fastest drive, and the wheels turn as fast as
/// they may to where they should be.
struct Execution {
  /// It touches nothing and ends within 1 cm and 1 degree, as does the trailer.
  bool passes = false;
  std::string reason = {};    ///< why it does not pass, one line
  double duration = 0.0;      ///< [s]
  double end_distance = 0.0;  ///< from the end of the path [m]
  double end_heading = 0.0;   ///< difference of the heading there, without sign [rad]
};

/// Whether a path can be executed, by the criterion of CommonParking (2026): limits are relaxed by
/// 0.1 %.
struct ExecutableCheck {
  /// Standing at start, goal and gear changes only: where the curvature jumps in between, the
  /// wheels turn while the vehicle drives on, slowly.
  Execution flowing = {};
  /// Standing at jumps of the curvature, too, until the wheels are turned.
  Execution pausing = {};
  int jumps = 0;  ///< of the curvature on the way, but for those at gear changes
};

/// Executes a path in the scenario's frame. Throws InputError naming a limit of the vehicle or a
/// segment that is not finite.
[[nodiscard]] ExecutableCheck executable(const Problem& problem, const Path& path);

}  // namespace vandplan
