// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is this path or drive really good?

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "vandplan/motion.h"
#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"

namespace vandplan {

// ---- Is this path really valid? ----
//
// The independent judge: it shares no code with the checker, the planners or the kernels. Method:
// docs/algorithms/path_check.md.

/// A pose that somebody states for a place of the path.
struct StatedPose {
  double s = 0.0;                          ///< driven distance since the start [m]
  Pose pose;                               ///< pose in the frame of the path
  std::optional<double> curvature = {};    ///< curvature there [1/m]
  std::optional<Gear> gear = {};           ///< gear there
  std::optional<double> hitch_angle = {};  ///< hitch angle there [rad]
};

/// A cost that somebody states for a path.
struct StatedCost {
  /// Stated cost [m]. A surcharge for being near obstacles may be off by 1e-3 of the cost. Where
  /// the cost is the time [s], it may be off by 1e-3. With a limit of jerk it must only be no less
  /// than the time without that limit.
  double cost = 0.0;
  CostOptions rule = {};  ///< prices of the cost; those not set are from `shortest_style`
  std::optional<double> lower_bound =
      {};                          ///< stated lower bound of the cost of every path [m] or [s]
  std::optional<double> gap = {};  ///< stated cost / lower_bound - 1
};

/// Claims about a path, which the judge checks. It does not prove a bound again, but a bound must
/// not be above the cost.
struct PathClaims {
  std::optional<double> length = {};     ///< length of the path [m]
  std::optional<int> gear_changes = {};  ///< number of gear changes
  std::optional<StatedCost> cost = {};   ///< cost of the path
  /// Margin of the path: of the footprint from obstacles and map, of the wheels from kerbs. On
  /// ramps, which begin at the ends of the path, a millimetre less is accepted.
  ClearanceOptions clearance = {};
  /// Places where the curvature may jump. Unless it may jump anywhere, it changes by at most the
  /// vehicle's `max_curvature_rate` per metre. If it may jump nowhere, it is that of the problem at
  /// both ends.
  Steering steering = Steering::reeds_shepp;
  /// Gears of the path; a metre in another gear is a fault.
  AllowedGears gears = AllowedGears::both;
  /// Goal of a set at which the path ends, within 1e-5 m and 1e-5 rad; its pose is in the frame of
  /// the path. Without a set of goals it is ignored. If the set has no region of that index, only
  /// the pose counts.
  std::optional<ReachedGoal> goal = {};
  /// Where the path passes the vias of the problem, within 1e-5 m and 1e-5 rad, in the frame of the
  /// path. Empty: nothing is stated.
  std::vector<PassedVia> via = {};
  std::optional<double> start_hitch_angle = {};  ///< hitch angle at the start [rad]
  /// Poses from end to end, at most 0.1 m apart, in the frame of the path. Empty: none is stated.
  std::vector<StatedPose> poses = {};
};

/// Kind of thing that a vehicle may touch, come too near to, or leave, or whose rule it may break.
enum class HitKind : std::uint8_t { obstacle, kerb, map, bounds, inside, zone, mask };

/// Name of the kind, as in scenario files: "obstacles", "kerbs", "map", "bounds", "inside",
/// "zones", "masks".
[[nodiscard]] std::string_view name_of(HitKind kind) noexcept;

/// The kind with that name; none if there is no such kind.
[[nodiscard]] std::optional<HitKind> hit_kind_named(std::string_view name) noexcept;

/// Whether scenarios have a list of such things, so that `Hit::index` says which one is hit.
[[nodiscard]] bool has_index(HitKind kind) noexcept;

/// A thing that a vehicle touches, comes too near to, or leaves.
struct Hit {
  HitKind kind = HitKind::obstacle;
  /// Index of the obstacle, kerb, area to stay in, zone or mask in the scenario.
  std::size_t index = 0;
  /// Middle of the map's cell, in the scenario's frame [m]. Only `PlanResult::hit` has it.
  std::optional<Point> cell = {};
  bool operator==(const Hit&) const = default;
};

/// Verdict of the judge on a path.
struct PathCheck {
  bool valid = false;                ///< whether no fault was found
  std::string reason = {};           ///< first fault that was found, one line; empty when valid
  std::optional<PathPoint> at = {};  ///< place of the fault, if it has one; in the scenario's frame
  /// Thing that is hit or left, if that is the fault.
  std::optional<Hit> hit = {};
  /// Goal of a set at which the path ends, in the scenario's frame. None if the path has a fault,
  /// or the problem has no set of goals.
  std::optional<ReachedGoal> goal = {};
  /// First places where the path passes the vias of the problem, in the scenario's frame. Empty if
  /// the path has a fault.
  std::vector<PassedVia> via = {};
  double length = 0.0;          ///< length of the path [m]
  double reverse_length = 0.0;  ///< metres in reverse [m]
  int gear_changes = 0;         ///< number of gear changes
  /// Largest absolute hitch angle that was seen [rad]; 0 without a trailer.
  double largest_hitch_angle = 0.0;
  /// Total variation of the curvature, including jumps at gear changes [1/m].
  double curvature_change = 0.0;
  /// Least distance between footprint and obstacles or cells, or wheels and kerbs [m]; at most 1 mm
  /// too large. It is 0 if they touch, infinite if there are none. None if the path was found wrong
  /// before collisions were examined.
  std::optional<double> clearance = {};
};

/// Judges a path in the scenario's frame. A fault is no exception: the first one is in `reason`.
/// Faults are also a problem that `make_problem` did not make, and a negative margin or ramp. The
/// judge checks in this order:
///
/// - Every number is finite, and the path begins at the start.
/// - Every curvature is drivable. The wheels turn and the gears are as claimed.
/// - The rear axle stays in the bounds, and the whole body in the area of `inside` in which it
///   begins.
/// - No rule of a zone is broken.
/// - The hitch angle of a trailer stays within its limit.
/// - The footprint touches no obstacle and no blocked cell, and the wheels no kerb, for vehicle and
///   trailer. The judge looks at every millimetre that a point of the vehicle moves. It skips only
///   what is proven to be free.
/// - Footprint and wheels keep the claimed margin.
/// - The path ends at the goal, or at one of a set, within 1e-6 m and 1e-6 rad, with the trailer's
///   hitch angle within 1e-6 rad.
/// - It passes all vias in their order, within the same tolerances.
/// - What is claimed is true.
[[nodiscard]] PathCheck check_path(const Problem& problem, const Path& path,
                                   const PathClaims& claims = {});

// ---- Are these times really valid, and who is met on the way? ----
//
// The independent judge of drives; `check_path` judges their paths. It shares no code with what it
// judges. Method: docs/algorithms/moving.md.

/// Claims about a drive, which the judge checks.
struct DriveClaims {
  double margin = 0.0;  ///< least distance of the footprint from moving obstacles [m]
  /// Speed with which the vehicle comes to the start, in the gear of the first segment [m/s].
  double start_speed = 0.0;
};

/// Verdict of the judge on a drive.
struct DriveCheck {
  bool valid = false;                ///< whether no fault was found
  std::string reason = {};           ///< first fault that was found, one line; empty when valid
  std::optional<double> t = {};      ///< time of the fault, if it has one [s]
  std::optional<PathPoint> at = {};  ///< place of the vehicle at that time, in the scenario's frame
  double duration = 0.0;             ///< duration of the drive [s]
  /// Least distance between the footprint and the grown outline of any moving obstacle [m]. It may
  /// be too large by 1 mm and a twentieth of the distance. It is 0 if they touch, infinite if
  /// nothing moves. None if the times were found wrong before.
  std::optional<double> clearance = {};
};

/// Judges the times of a drive in the scenario's frame, whose path `check_path` accepts. A fault is
/// no exception: the first one is in `reason`. The judge checks in this order:
///
/// - Every number is finite, and speeds and distances follow from each other.
/// - The drive covers the whole path, from the claimed speed to standing.
/// - It keeps `Vehicle::limits` (to 1e-6 of them). With `max_jerk` the acceleration jumps nowhere.
/// - It stands where the gear changes. Where the curvature jumps, it stands until the wheels are
///   turned.
/// - Neither on the way nor ever after does it touch a moving obstacle, or come nearer than
///   claimed.
[[nodiscard]] DriveCheck check_drive(const Problem& problem, const TimedPath& drive,
                                     const DriveClaims& claims = {});

/// Judges only which moving obstacles are met on a drive and ever after. It is for what was driven
/// rather than planned. A fault is no exception: the first one is in `reason`. The knots must
/// follow from each other.
[[nodiscard]] DriveCheck check_company(const Problem& problem, const TimedPath& drive,
                                       const DriveClaims& claims = {});

}  // namespace vandplan
