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

/// A controller that steers a vehicle along a path.
struct ControllerInfo {
  std::string_view name;     ///< name, such as "rear-axle-feedback"
  std::string_view summary;  ///< the controller in half a sentence
  /// Whether the controller follows a path with metres in reverse, without a trailer.
  bool drives_reverse;
  /// Whether the controller follows a path with metres in reverse with a trailer, which runs away.
  bool steers_trailer;
};

/// All controllers: "rear-axle-feedback", "lqr", "pure-pursuit", "stanley".
[[nodiscard]] std::span<const ControllerInfo> controllers() noexcept;

/// Name of the controller that drives where none is named: "rear-axle-feedback", with a trailer
/// "lqr".
[[nodiscard]] std::string_view usual_controller(const Vehicle& vehicle) noexcept;

/// Options of a drive.
struct DriveOptions {
  std::string controller = {};  ///< name of one of `controllers`; empty: `usual_controller`
  /// Scale of the errors of sensors and actuators; [0, 10]; 0: no errors. At 1 these are the
  /// standard deviations of normal distributions:
  ///
  /// - Each of 50 measurements a second is off by 2 cm along x and y, and by 0.2 degrees in heading
  ///   and hitch angle.
  /// - For the whole drive the wheels are turned 0.2 degrees and 1 % further than they report, and
  ///   the vehicle is 1 % faster.
  double noise = 0.0;
  double delay = 0.0;  ///< time from a measurement to its effect [s]; [0, 1]
  /// Share of steering rate, acceleration and braking that planned speeds leave for corrections;
  /// [0, 0.5].
  double reserve = 0.1;
  /// Share by which the vehicle can do more than the plan assumes, for corrections; [0, 0.5]. Its
  /// wheels make a curvature larger by this share than 1/`min_turning_radius`. A rig folds up
  /// further by it than `max_hitch_angle`. At 0 nobody can steer against what drives out of the
  /// tightest turn.
  double spare_steering = 0.0;
  std::uint64_t seed = 1;  ///< seed of the noise
  bool keep_log = false;   ///< whether `DriveResult::log` is filled
};

/// State of a driven vehicle at one time, and its deviation from the plan.
struct DriveMoment {
  double t = 0.0;  ///< time since the start [s]
  /// Distance along the planned path to the place beside the vehicle [m].
  double s = 0.0;
  Pose pose = {};                ///< pose in the frame of the path
  Gear gear = Gear::forward;     ///< gear that is engaged
  double v = 0.0;                ///< speed [m/s]; negative in reverse
  double steering_angle = 0.0;   ///< front-wheel angle of a bicycle [rad]; positive to the left
  double wanted_steering = 0.0;  ///< steering angle that the controller asks for now [rad]
  /// Acceleration along the path that the controller asks for [m/s^2]; negative: it brakes.
  double wanted_acceleration = 0.0;
  /// Distance of the rear axle from the path [m]; positive: left of the path, seen forward.
  double lateral_error = 0.0;
  /// Heading of the vehicle less that of the path [rad], in [-pi, pi); positive: turned to the
  /// left.
  double heading_error = 0.0;
  std::optional<double> hitch_angle = {};  ///< hitch angle [rad]; none without a trailer
};

/// The moment at which a vehicle touches something for the first time.
struct Contact {
  double t = 0.0;    ///< time since the start [s]
  double s = 0.0;    ///< distance along the planned path [m]
  Pose pose = {};    ///< pose of the vehicle, in the frame of the path
  std::string what;  ///< "the footprint hits obstacles[3]", "the rig folds up (jackknife)"
};

/// Deviation of a trailer from where it would be behind a tractor that is on the path.
struct TrailerDeviation {
  /// Largest distance of the trailer's axle from its planned place, across the planned heading [m].
  double largest_lateral = 0.0;
  /// Root mean square distance of the trailer's axle across its heading, along the tractor's way
  /// [m].
  double rms_lateral = 0.0;
  /// Distance of the trailer's axle at the end from its planned place [m].
  double end_distance = 0.0;
  double end_heading = 0.0;  ///< difference of the trailer's heading at the end, without sign [rad]
  /// Largest excess of the absolute hitch angle over the planned one [rad]. A path that was planned
  /// with a `Vehicle::max_hitch_angle` smaller by that much does not fold up too far.
  double hitch_deviation = 0.0;
};

/// Result of a drive. After a contact the drive goes on as if there had been none.
struct DriveResult {
  /// Whether the vehicle believes to stand at the end of the path. The drive is given up after
  /// three times the planned duration plus 60 s and the delay.
  bool has_arrived = false;
  double duration = 0.0;  ///< duration of the drive [s]
  /// Duration of the fastest drive that leaves the reserve [s].
  double planned_duration = 0.0;
  double largest_lateral = 0.0;  ///< largest distance of the rear axle from the path [m]
  double rms_lateral = 0.0;  ///< root mean square distance from the path, along the driven way [m]
  double largest_heading = 0.0;  ///< largest difference of the headings [rad]
  double rms_heading = 0.0;      ///< root mean square difference of the headings [rad]
  double end_distance = 0.0;     ///< distance of the rear axle from the end of the path [m]
  double end_heading = 0.0;      ///< difference of the heading at the end, without sign [rad]
  std::optional<TrailerDeviation> trailer = {};  ///< deviation of the trailer, if there is one
  /// Largest distance by which the outline of body, wheels or trailer was beyond its planned place
  /// [m]. A path with a margin of at least that much is driven without contact.
  double outline_deviation = 0.0;
  /// Largest distance of the rear axle outside the bounds [m]; nothing is touched there.
  double out_of_bounds = 0.0;
  /// Least clearance at the ends of all steps of 5 ms [m]. It is 0 after a contact, also where the
  /// rig folds up, and infinite without obstacles within 1 km.
  double clearance = 0.0;
  std::optional<Contact> contact = {};  ///< first contact; none if nothing was touched
  std::vector<DriveMoment> log = {};    ///< moments every 0.02 s, if they were asked for
};

/// Drives a path (in the scenario's frame) from standing to standing, and checks all ground that
/// footprint, wheels and trailer sweep. Moving obstacles are ignored. The speeds are those of
/// `speed_profile` for limits less the reserve. At the start the wheels are turned as
/// `Problem::curvatures` says, and the trailer as `Problem::hitch_angles`. Results repeat bit for
/// bit. Throws InputError naming:
///
/// - "problem" if `make_problem` did not make it,
/// - "noise", "delay", "reserve" or "spare_steering" if it is out of range,
/// - "controller" if it is unknown or cannot drive the path's metres in reverse,
/// - a limit of the vehicle that is out of range,
/// - "segments[3].curvature" if it is not finite, or by more than 0.1 % too sharp for the vehicle,
/// - "segments[3]" if its length is not finite.
[[nodiscard]] DriveResult drive(const Problem& problem, const Path& path,
                                const DriveOptions& options = {});

/// Execution of a path without feedback. Every millisecond the speed is that of the fastest drive,
/// and the wheels turn as fast as they may to where they should be. A drive longer than 1000 s is
/// cut into 10^6 parts instead.
struct Execution {
  /// Whether the vehicle touches nothing and ends within 1 cm and 1 degree, and the trailer too.
  bool passes = false;
  std::string reason = {};    ///< why the execution does not pass, one line; or empty
  double duration = 0.0;      ///< duration of the execution [s]
  double end_distance = 0.0;  ///< distance from the end of the path [m]
  double end_heading = 0.0;   ///< difference of the heading at the end, without sign [rad]
};

/// Whether a path can be executed, by the criterion of CommonParking (2026): limits are relaxed by
/// 0.1 %.
struct ExecutableCheck {
  /// Execution that stands only at start, goal and gear changes. Where the curvature jumps in
  /// between, the wheels turn while the vehicle drives on, slowly.
  Execution flowing = {};
  /// Execution that also stands at jumps of the curvature, until the wheels are turned.
  Execution pausing = {};
  int jumps = 0;  ///< number of jumps of the curvature, except at the start and at gear changes
};

/// Executes a path in the scenario's frame. Throws InputError naming a limit of the vehicle, or
/// "segments[3]" if it is not finite.
[[nodiscard]] ExecutableCheck executable(const Problem& problem, const Path& path);

}  // namespace vandplan
