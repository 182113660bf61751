// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which short path leads a tractor with a trailer from one state to another?
//
// The paths are words of arcs and lines of the tractor that also end with the wanted hitch angle.
// Method and what is optimal: docs/algorithms/rig_steering.md.

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/rig.h"
#include "vandplan/vehicle.h"

namespace vandplan {

/// Prices of metres and gear changes of a rig's path, and the cost up to which paths are of
/// interest.
struct RigPrices {
  double reverse_weight = 1.0;    ///< cost of a metre in reverse; forward it is 1; > 0, finite
  double gear_change_cost = 0.0;  ///< cost of each gear change inside the path [m]; >= 0, finite
  /// Cost above which paths are of no use [m].
  double cutoff = std::numeric_limits<double>::infinity();
};

/// Cost of segments that are driven one after the other [m].
[[nodiscard]] double price_of(const RigPrices& prices, std::span<const Segment> segments) noexcept;

/// Short paths of a rig on open ground in either gear. Everywhere |curvature| is at most
/// 1/min_turning_radius, and |hitch angle| at most max_hitch_angle. Segments are arcs and lines of
/// the tractor, which end within 1e-9 m and rad of the goal. No path is shorter than
/// `reeds_shepp_length` between the poses of the tractor. Mirrored states have the mirrored path.
///
/// The path from b to a is the path from a to b driven backwards, with one exception. A path is not
/// given if it has so long a stretch in reverse that rounding would bend the rig. Both states of a
/// call share one frame. A small value: make it once, call it often, from any thread.
class RigSteering {
 public:
  /// Makes the steering of a vehicle with a trailer. Throws InputError naming:
  ///
  /// - "trailers" if there is no trailer,
  /// - "min_turning_radius" or "trailers wheelbase" if it is not finite and positive,
  /// - "hitch" if the hitch is as far from the rear axle as the trailer's axle from the hitch, or
  ///   farther,
  /// - "max_hitch_angle" if it is not in [0.05, 3] rad.
  explicit RigSteering(const Vehicle& vehicle);

  /// The shortest path that the search finds, or none if it finds none. Equal states give a path
  /// without segments. Throws InputError naming "from" or "to" if a number is not finite or the
  /// hitch angle is beyond the limit.
  [[nodiscard]] std::optional<Piece> steer(const State& from, const State& to) const;

  /// The path of least cost that the search finds; none if that is above the cutoff. Throws
  /// InputError naming "from", "to", "reverse_weight", "gear_change_cost" or "cutoff" if a number
  /// is out of range.
  [[nodiscard]] std::optional<Piece> steer(const State& from, const State& to,
                                           const RigPrices& prices) const;

  /// The shortest path of the few words that are most useful between such states; none if none of
  /// these words leads there. It is for callers who ask often and drop most paths. Throws
  /// InputError naming "from" or "to" if a number is not finite or the hitch angle is beyond the
  /// limit.
  [[nodiscard]] std::optional<Piece> steer_quickly(const State& from, const State& to) const;

  /// All paths that the search finds up to the cutoff, the cheapest first. Throws InputError as
  /// `steer` with prices does.
  [[nodiscard]] std::vector<Piece> candidates(const State& from, const State& to,
                                              const RigPrices& prices) const;

  /// The turning radius of the tractor [m].
  [[nodiscard]] double radius() const noexcept { return radius_; }
  /// The largest absolute hitch angle [rad].
  [[nodiscard]] double max_hitch_angle() const noexcept { return max_hitch_angle_; }

 private:
  double radius_;
  double max_hitch_angle_;
  // Wheelbase of the trailer and x of the hitch [turning radii], tan(largest angle / 2).
  std::array<double, 3>
      shape_;  ///< wheelbase of the trailer, hitch [radii], tan(largest angle / 2)
};

}  // namespace vandplan
