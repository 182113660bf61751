// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lengths and limits describe the vehicle, how does it stand, and where is its footprint?

#include <array>
#include <optional>

#include "vandplan/driving_limits.h"
#include "vandplan/geometry.h"

namespace vandplan {

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

}  // namespace vandplan
