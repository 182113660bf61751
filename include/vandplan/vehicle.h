// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long, how fast and how agile is the vehicle, how does it stand, and what does its trailer do?

#include <array>
#include <optional>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/path.h"

namespace vandplan {

// ---- How fast may a vehicle be driven, and how fast can its wheels be turned? ----

/// Largest speeds, one for each gear [m/s]; > 0.
struct GearSpeeds {
  double forward = 2.5;  ///< largest speed forward [m/s]
  double reverse = 1.5;  ///< largest speed in reverse, without sign [m/s]
  bool operator==(const GearSpeeds&) const = default;
};

/// Limits of a vehicle's motion along its path. The field names are keys of scenario files. The
/// defaults are for moving a truck in a yard (sources: docs/lab/tools.md). Where the vehicle fits
/// does not depend on them.
struct DrivingLimits {
  /// Largest rate of the steering angle [rad/s], at standstill too; > 0. The angle is that of the
  /// front wheel of a bicycle, atan(wheelbase * curvature).
  double max_steering_rate = 0.5;
  /// Largest change of curvature per metre driven [1/m^2]; > 0. None: what `max_steering_rate`
  /// allows at 1 m/s with any curvature. It limits paths, not speeds.
  std::optional<double> max_curvature_rate = {};
  GearSpeeds max_speed = {};  ///< largest speed in each gear [m/s]
  /// Largest acceleration along the path, gaining speed [m/s^2]; > 0.
  double max_acceleration = 1.0;
  /// Largest deceleration along the path, without sign [m/s^2]; > 0. None: `max_acceleration`.
  std::optional<double> max_braking = {};
  double max_lateral_acceleration = 1.5;  ///< largest speed^2 * |curvature| [m/s^2]; > 0
  /// Largest change of the acceleration per second [m/s^3]; > 0. None: no limit.
  std::optional<double> max_jerk = {};
  bool operator==(const DrivingLimits&) const = default;
};

/// Checks limits alone: each must be 0.001 to 1000 of its unit. Throws InputError naming
/// "max_speed.forward" or the key of another limit that is out of range.
void check_limits(const DrivingLimits& limits);

// ---- Which lengths describe the vehicle, and where is its footprint? ----

/// Lengths of a trailer with one axle [m]. It hangs on the hitch of its tractor. The field names
/// are keys of scenario files.
struct Trailer {
  double wheelbase = 8.1;       ///< hitch to axle [m]; > 0
  double front_overhang = 1.2;  ///< hitch to the front of the body [m]; negative with a drawbar
  double rear_overhang = 4.3;   ///< axle to the rear of the body [m]; >= 0
  double width = 2.55;          ///< width of the body [m]; > 0
  /// Corners of a body that is no rectangle, in the frame of the axle's midpoint with x ahead [m].
  /// It is a convex polygon in either orientation that holds the midpoint. Empty: the rectangle of
  /// the lengths.
  Polygon outline = {};
  bool operator==(const Trailer&) const = default;
};

/// Lengths of a rigid vehicle that steers at the front [m], its driving limits, and its trailer if
/// it pulls one. The field names are keys of scenario files, where those of `limits` stand beside
/// the lengths.
struct Vehicle {
  double wheelbase = 4.5;       ///< rear axle to front axle [m]; > 0
  double front_overhang = 1.4;  ///< front axle to front bumper [m]; >= 0
  double rear_overhang = 1.6;   ///< rear axle to rear bumper [m]; >= 0
  double width = 2.55;          ///< width of the body [m]; > 0
  /// Turning radius of the midpoint of the rear axle at full steering [m]; > 0. `turning_radius`
  /// computes it from the largest steering angle. Files, Python and JavaScript also take
  /// `max_steering_angle`.
  double min_turning_radius = 7.0;
  /// Width over the wheels of an axle [m]; > 0, at most `width`. None: `width`.
  std::optional<double> track_width = {};
  DrivingLimits limits = {};  ///< largest speeds, accelerations and steering rate
  double hitch = 0.0;  ///< x of the hitch in the vehicle frame [m]; negative behind the rear axle
  /// Largest absolute hitch angle [rad]; in (0, pi). Beyond it vehicle and trailer would touch or
  /// fold up. The default is 69 degrees, well short of a right angle.
  double max_hitch_angle = 1.2;
  std::optional<Trailer> trailer = {};  ///< the trailer; none: the vehicle is alone
  /// Corners of a body that is no rectangle, in the vehicle frame [m]. It is a convex polygon in
  /// either orientation that holds the midpoint of the rear axle. Empty: the rectangle of the
  /// lengths.
  Polygon outline = {};
  bool operator==(const Vehicle&) const = default;
};

/// How a vehicle stands, with its trailer if it pulls one. A pose alone is the state with the
/// trailer straight behind. Without a trailer the hitch angle means nothing.
struct State {
  Pose pose;           ///< pose of the vehicle, at the midpoint of its rear axle
  double hitch_angle;  ///< heading of the vehicle - heading of its trailer [rad]

  // NOLINTNEXTLINE(google-explicit-constructor)
  constexpr State(const Pose& at = {}, double angle = 0.0) noexcept
      : pose(at), hitch_angle(angle) {}
  bool operator==(const State&) const = default;
};

/// A state in the frame of a world.
using LocalState = Local<State>;

/// Whether two vehicles are equal apart from their driving limits.
[[nodiscard]] bool same_lengths(const Vehicle& a, Vehicle b);

/// Steering angle for a curvature [rad]: atan(wheelbase * curvature), the front-wheel angle of a
/// bicycle with the vehicle's wheelbase. `curvature` is that of the rear-axle midpoint [1/m]. The
/// angle is in (-pi/2, pi/2), positive to the left.
[[nodiscard]] double steering_angle(const Vehicle& vehicle, double curvature) noexcept;

/// Turning radius of the rear-axle midpoint [m] for the front-wheel angle of a bicycle [rad]:
/// wheelbase / tan(steering_angle). With the largest steering angle it is the vehicle's
/// `min_turning_radius`. Throws InputError naming "wheelbase" unless it is > 0 [m], or
/// "max_steering_angle" unless the angle is above 0 and below pi/2.
[[nodiscard]] double turning_radius(double wheelbase, double steering_angle);

/// Largest change of curvature per metre driven [1/m^2]: `limits.max_curvature_rate` if it is set.
/// Otherwise it is what `limits.max_steering_rate` allows at 1 m/s with any curvature:
/// rate / (wheelbase * 1 m/s).
[[nodiscard]] double max_curvature_rate(const Vehicle& vehicle) noexcept;

/// A closed rectangle in the vehicle frame [m], whose origin is the rear-axle midpoint with x
/// forward. It reaches from x = `-rear` to `front` and from y = `-half_width` to `half_width`.
struct Footprint {
  double rear = 0.0;
  double front = 0.0;
  double half_width = 0.0;
  bool operator==(const Footprint&) const = default;
};

/// Rectangle of the whole body in the vehicle frame [m]. For a body with an `outline` it is the
/// least rectangle around it that is as wide to the left as to the right.
[[nodiscard]] Footprint footprint(const Vehicle& vehicle) noexcept;

/// Rectangle of the whole body of a trailer [m], in the frame of its axle's midpoint with x ahead.
/// For a body with an `outline` it is the least rectangle around it that is as wide to the left as
/// to the right.
[[nodiscard]] Footprint footprint(const Trailer& trailer) noexcept;

/// Corners of the whole body in the vehicle frame [m], counter-clockwise: its `outline`, or the
/// corners of its footprint without one.
[[nodiscard]] Polygon body_outline(const Vehicle& vehicle);
/// Corners of the whole body of a trailer [m], counter-clockwise, in the frame of its axle's
/// midpoint.
[[nodiscard]] Polygon body_outline(const Trailer& trailer);

/// Rectangle of the wheels in the vehicle frame [m]: between the axles, as wide as the track. Kerbs
/// must stay out of it.
[[nodiscard]] Footprint wheel_footprint(const Vehicle& vehicle) noexcept;

/// Least distance from the midpoint of the rear axle to the outline of the footprint [m]. While the
/// footprint touches nothing, the midpoint keeps at least this distance from everything.
///
/// The distance is 0 for a vehicle without a rear overhang, whose rear axle is a side of its
/// outline. In that case the proofs of `anytime` use a wider disc ahead of the axle
/// (docs/proofs/anytime_bounds.md).
[[nodiscard]] double inner_radius(const Footprint& footprint) noexcept;

/// Least distance from the midpoint of the rear axle to the outline of the whole body [m]. The body
/// may have an `outline`.
[[nodiscard]] double inner_radius(const Vehicle& vehicle);

/// The four corners of a vehicle's footprint at `pose` [m], in the frame in which `pose` is given.
/// They are counter-clockwise and begin at the rear right.
[[nodiscard]] std::array<Point, 4> corners(const Footprint& footprint, const Pose& pose) noexcept;

// ---- What does a trailer do when its tractor drives? ----
//
// Formulas: docs/algorithms/trailers.md. Every vehicle that is passed here has a trailer, unless
// the docstring of a function says otherwise.

using RigState [[deprecated("use State")]] = State;

/// Pose of the trailer at the midpoint of its axle, in the frame of `state.pose`; heading in
/// [-pi, pi). Throws InputError naming "vehicle.trailers" if there is no trailer, as
/// `tractor_pose`, `hitch_rate` and `largest_hitch_angle` do.
[[nodiscard]] Pose trailer_pose(const Vehicle& vehicle, const State& state);

/// Pose of the tractor when the midpoint of its trailer's axle is at `trailer`, in the frame of
/// `trailer`; heading in [-pi, pi). `hitch_angle` is the tractor's heading less the trailer's
/// [rad].
[[nodiscard]] Pose tractor_pose(const Vehicle& vehicle, const Pose& trailer, double hitch_angle);

/// Change of the hitch angle per metre driven forward [rad/m]; in reverse it has the opposite sign.
/// `hitch_angle` is in rad, `curvature`
/// is that of the tractor's path [1/m].
[[nodiscard]] double hitch_rate(const Vehicle& vehicle, double hitch_angle, double curvature);

/// Hitch angle after a tractor has driven the segment [rad]. It is exact but for rounding along
/// arcs and lines, and within 1e-11 along clothoids of vehicles. An equilibrium stays exactly.
///
/// The angle is not wrapped: it goes on beyond pi where the trailer turns round its hitch. Without
/// a trailer the angle stays as it was.
[[nodiscard]] double hitch_angle_after(const Vehicle& vehicle, double hitch_angle,
                                       const Segment& segment) noexcept;

/// State after driving the segment, in the frame of `state`. The hitch angle is in [-pi, pi).
/// Without a trailer it is the one in `state`, wrapped.
[[nodiscard]] State advance(const Vehicle& vehicle, const State& state,
                            const Segment& segment) noexcept;
/// State after driving the segment from a state in the world's frame, in that frame.
[[nodiscard]] inline LocalState advance(const Vehicle& vehicle, const LocalState& state,
                                        const Segment& segment) noexcept {
  return Local(advance(vehicle, static_cast<const State&>(state), segment));
}

/// Hitch angles [rad] at the points that `sampled(path, step)` gives, one for each point.
/// `start_angle` is the hitch angle at the start of the path [rad], `step` the largest distance of
/// points [m]. The angles are not wrapped. Without a trailer all are `start_angle`. Throws
/// InputError naming "segments[3]" for a segment that is not finite, or "step" unless it is > 0 and
/// at least a 10^7th of the path's length.
[[nodiscard]] std::vector<double> sampled_hitch_angles(const Vehicle& vehicle, const Path& path,
                                                       double start_angle, double step);

/// Largest absolute hitch angle on the segment, both ends included [rad]. `hitch_angle` is that at
/// its begin. Along arcs and lines the largest one is at an end: the angle moves towards or away
/// from one equilibrium.
[[nodiscard]] double largest_hitch_angle(const Vehicle& vehicle, double hitch_angle,
                                         const Segment& segment);

}  // namespace vandplan
