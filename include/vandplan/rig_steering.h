// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which short path leads a tractor with a trailer from one state to another?
//
// Words of arcs and lines of the tractor that end with the wanted hitch angle, too. Method and
// what is optimal: docs/algorithms/rig_steering.md.

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/path.h"
#include "vandplan/rig.h"
#include "vandplan/vehicle.h"

namespace vandplan {

/// What the metres and gear changes of a path of a rig cost, and which paths are of interest.
struct RigPrices {
  double reverse_weight = 1.0;    ///< of a metre in reverse; a forward one costs 1; > 0, finite
  double gear_change_cost = 0.0;  ///< of each change inside the path; >= 0, finite [m]
  double cutoff = std::numeric_limits<double>::infinity();  ///< dearer paths are of no use [m]
};

/// The price of segments that are driven one after the other [m].
[[nodiscard]] double price_of(const RigPrices& prices, std::span<const Segment> segments) noexcept;

/// Short paths of a rig on open ground in either gear, with |curvature| <= 1/min_turning_radius and
/// |hitch angle| <= max_hitch_angle everywhere. Segments are arcs and lines of the tractor, which
/// end within 1e-9 m and rad of the goal. No path is shorter than `reeds_shepp_length` between the
/// poses of the tractor. Mirrored states have the mirrored path. The path from b to a is that from
/// a to b driven backwards, unless one of them has a stretch in reverse so long that rounding would
/// bend the rig: such paths are not given. A small value: make it once, call it often, from any
/// thread.
class RigSteering {
 public:
  /// Throws InputError if there is no trailer, a length is not finite and positive, the hitch is as
  /// far from the rear axle as the axle of the trailer from the hitch or farther, or
  /// `max_hitch_angle` is not in [0.05, 3] rad.
  explicit RigSteering(const Vehicle& vehicle);

  /// The least path that the search finds; equal states give one without segments. Throws
  /// InputError if a number is not finite or a hitch angle is beyond the limit.
  [[nodiscard]] std::optional<Piece> steer(const RigState& from, const RigState& to) const;

  /// The path with the least price that the search finds, or nothing if that is above the cutoff.
  /// Throws InputError if a number is not finite or out of its range.
  [[nodiscard]] std::optional<Piece> steer(const RigState& from, const RigState& to,
                                           const RigPrices& prices) const;

  /// The least path of the few words that are most useful between such states, or nothing where
  /// none of them leads there: for whoever asks often and throws most paths away. Throws as above.
  [[nodiscard]] std::optional<Piece> steer_quickly(const RigState& from, const RigState& to) const;

  /// Every path that the search finds up to the cutoff, the cheapest first.
  [[nodiscard]] std::vector<Piece> candidates(const RigState& from, const RigState& to,
                                              const RigPrices& prices) const;

  [[nodiscard]] double radius() const noexcept { return radius_; }
  [[nodiscard]] double max_hitch_angle() const noexcept { return max_hitch_angle_; }

 private:
  double radius_;
  double max_hitch_angle_;
  std::array<double, 3>
      shape_;  ///< wheelbase of the trailer, hitch [radii], tan(largest angle / 2)
};

}  // namespace vandplan
