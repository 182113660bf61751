// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which lengths and limits describe the vehicle, and where is its footprint?

#include <array>
#include <optional>

#include "vandplan/driving_limits.h"
#include "vandplan/geometry.h"

namespace vandplan {

/// The lengths of a trailer with one axle [m]: it hangs on the hitch of its tractor, and its axle
/// follows. The field names are keys of scenario files.
struct Trailer {
  double wheelbase = 8.1;       ///< hitch to axle; > 0
  double front_overhang = 1.2;  ///< hitch to the front of the body; negative with a drawbar
  double rear_overhang = 4.3;   ///< axle to the rear of the body; >= 0
  double width = 2.55;          ///< of the body; > 0
  /// Corners of a body that is no rectangle, in the frame of the axle's midpoint, x ahead; as that
  /// of a vehicle.
  Polygon outline = {};
  bool operator==(const Trailer&) const = default;
};

/// The lengths of a rigid vehicle that steers at the front [m], how fast it may be driven, and the
/// trailer that it may pull; the field names are keys of scenario files, where those of `limits`
/// stand beside the lengths.
struct Vehicle {
  double wheelbase = 4.5;       ///< rear axle to front axle; > 0
  double front_overhang = 1.4;  ///< front axle to front bumper; >= 0
  double rear_overhang = 1.6;   ///< rear axle to rear bumper; >= 0
  double width = 2.55;          ///< of the body; > 0
  /// Turning radius of the midpoint of the rear axle at full steering; > 0. `turning_radius` gives
  /// it for a largest steering angle. Files, Python and JavaScript take `max_steering_angle` as
  /// well.
  double min_turning_radius = 7.0;
  /// Width over the wheels of an axle; > 0, at most `width`, which holds where there is none.
  std::optional<double> track_width = {};
  DrivingLimits limits = {};
  double hitch = 0.0;  ///< x of the hitch in the vehicle frame; negative behind the rear axle
  /// Largest angle between the vehicle and its trailer [rad], beyond which they would touch or
  /// fold up; in (0, pi). The default is 69 degrees, well short of a right angle.
  double max_hitch_angle = 1.2;
  std::optional<Trailer> trailer = {};  ///< none: the vehicle is alone
  /// Corners of a body that is no rectangle, in the vehicle frame [m]: a convex polygon, in either
  /// orientation, that holds the midpoint of the rear axle. None: the rectangle of the lengths.
  Polygon outline = {};
  bool operator==(const Vehicle&) const = default;
};

/// Whether two vehicles have the same lengths and outlines, whatever their limits.
[[nodiscard]] bool same_lengths(const Vehicle& a, Vehicle b);

/// The angle of the front wheel of a bicycle with this wheelbase that makes the midpoint of the
/// rear axle drive this curvature [rad]; in (-pi/2, pi/2), positive to the left.
[[nodiscard]] double steering_angle(const Vehicle& vehicle, double curvature) noexcept;

/// The turning radius of the midpoint of the rear axle when the front wheel of a bicycle with this
/// wheelbase is turned by that angle [m]: `min_turning_radius` of a vehicle whose largest steering
/// angle is known. Throws InputError naming "max_steering_angle" unless it is above 0 and below
/// pi/2 [rad], "wheelbase" unless that is above 0.
[[nodiscard]] double turning_radius(double wheelbase, double steering_angle);

/// The largest change of curvature per metre driven [1/m^2]: `limits.max_curvature_rate`, or what
/// the steering rate allows at 1 m/s with any curvature, rate / (wheelbase * 1 m/s).
[[nodiscard]] double max_curvature_rate(const Vehicle& vehicle) noexcept;

/// A rectangle in the vehicle frame (origin at the rear-axle midpoint, x forward): x from `-rear`
/// to `front`, y from `-half_width` to `half_width`. Closed. [m]
struct Footprint {
  double rear = 0.0;
  double front = 0.0;
  double half_width = 0.0;
  bool operator==(const Footprint&) const = default;
};

/// The whole body in the vehicle frame [m]; of a body with an `outline` the least rectangle around
/// it that is as wide to the left as to the right.
[[nodiscard]] Footprint footprint(const Vehicle& vehicle) noexcept;

/// The whole body of a trailer in the frame of its axle's midpoint, likewise [m].
[[nodiscard]] Footprint footprint(const Trailer& trailer) noexcept;

/// The corners of the whole body in the vehicle frame [m], counter-clockwise: its `outline`, or
/// those of its footprint.
[[nodiscard]] Polygon body_outline(const Vehicle& vehicle);
/// The same of a trailer in the frame of its axle's midpoint [m].
[[nodiscard]] Polygon body_outline(const Trailer& trailer);

/// The outline of the wheels in the vehicle frame [m]: between the axles, as wide as the track.
/// Kerbs must stay out of it.
[[nodiscard]] Footprint wheel_footprint(const Vehicle& vehicle) noexcept;

/// The least distance from the midpoint of the rear axle to the outline [m]: the midpoint stays
/// that far from whatever the footprint does not touch. 0 for a vehicle without a rear overhang,
/// whose rear axle is a side of its outline. What `anytime` proves comes from a wider disc ahead of
/// the axle then (docs/algorithms/anytime.md).
[[nodiscard]] double inner_radius(const Footprint& footprint) noexcept;

/// The same of the whole body of a vehicle, which may have an `outline` [m].
[[nodiscard]] double inner_radius(const Vehicle& vehicle);

/// The four corners of the footprint of a vehicle at `pose`, in the frame of the pose [m],
/// counter-clockwise from the rear right one.
[[nodiscard]] std::array<Point, 4> corners(const Footprint& footprint, const Pose& pose) noexcept;

}  // namespace vandplan
