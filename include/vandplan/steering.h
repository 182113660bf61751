// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which path is shortest on open ground?

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/path.h"
#include "vandplan/vehicle.h"

namespace vandplan {

// ---- Which path is shortest that drives forward only? ----
//
// Dubins 1957: a shortest path of bounded curvature is an arc, a line or arc, and an arc.
// Derivation and formulas: docs/algorithms/steering.md.

/// The shortest path from `from` to `to` driving forward with curvature -1/radius, 0 or 1/radius.
/// Ties go to the first word of `dubins_words`. Throws InputError naming "radius" unless it is
/// finite and > 0 [m].
[[nodiscard]] Piece dubins(const Pose& from, const Pose& to, double radius);

/// The length of the shortest forward-only path, `dubins(from, to, radius)` [m]. Throws InputError
/// naming "radius" unless it is finite and > 0 [m].
[[nodiscard]] double dubins_length(const Pose& from, const Pose& to, double radius);

/// The paths of all words that join the poses, in the order LSL, RSR, LSR, RSL, RLR, LRL. There are
/// at most 6 words. Throws InputError naming "radius" unless it is finite and > 0 [m].
[[nodiscard]] std::vector<Piece> dubins_words(const Pose& from, const Pose& to, double radius);

// ---- Which path is shortest if the vehicle may reverse? ----
//
// Reeds & Shepp 1990: a shortest path is one of 48 words of arcs and at most one line.
// Formulas: docs/algorithms/steering.md; proof and errata: docs/proofs/steering.md.

/// The shortest path from `from` to `to` with curvature -1/radius, 0 or 1/radius, in either gear.
/// The path from b to a is the path from a to b driven backwards, ties included. Throws InputError
/// naming "radius" unless it is finite and > 0 [m].
[[nodiscard]] Piece reeds_shepp(const Pose& from, const Pose& to, double radius);

/// The length of the shortest path, `reeds_shepp(from, to, radius)`, bit for bit [m]. Throws
/// InputError naming "radius" unless it is finite and > 0 [m].
[[nodiscard]] double reeds_shepp_length(const Pose& from, const Pose& to, double radius);

/// Lengths of the shortest paths from every node to one sample, in float, for ranking [m]: out[i]
/// belongs to node i. They have equal bits on every processor. They are within
/// 4e-6 * (length + radius) of the exact lengths between the poses as rounded to float. Far from
/// the origin that rounding alone is large (0.5 m at 6 000 km), so give poses near it.
///
/// Throws InputError naming "radius" unless it is finite and > 0 [m], or "nodes" unless all columns
/// have as many numbers as `out`.
void reeds_shepp_lengths(const PoseColumns& nodes, const Pose& sample, double radius,
                         std::span<float> out);

/// Lengths of the shortest paths of many pairs, `reeds_shepp_length(from[i], to[i], radius)`, bit
/// for bit [m]. Several are computed at a time where the processor has vectors of double. Either
/// side may be one pose for all. Throws InputError naming "radius" unless it is finite and > 0 [m],
/// or "from" or "to" if it has neither one pose nor as many as `out`.
void reeds_shepp_lengths(std::span<const Pose> from, std::span<const Pose> to, double radius,
                         std::span<double> out);

/// The paths of all of the 48 words that join the poses, shortest or not. Throws InputError naming
/// "radius" unless it is finite and > 0 [m].
[[nodiscard]] std::vector<Piece> reeds_shepp_words(const Pose& from, const Pose& to, double radius);

// ---- Which path is short if turning the wheels takes time? ----
//
// The words of Reeds and Shepp, with turns whose curvature rises and falls at a limited rate
// (Fraichard & Scheuer 2004). Method and what is optimal: docs/algorithms/continuous_steering.md.

/// Places where the curvature of a path may jump.
enum class Continuity : std::uint8_t {
  between_stops,  ///< where the vehicle stands: at gear changes, at start and goal
  throughout,     ///< nowhere, not at gear changes either
};

/// Wishes of a steering call beside its two poses.
struct ContinuousQuery {
  double start_curvature = 0.0;  ///< curvature at the start [1/m]; absolute at most 1/radius
  double goal_curvature = 0.0;   ///< curvature at the goal [1/m]; absolute at most 1/radius
  /// Length above which paths are of no use [m].
  double cutoff = std::numeric_limits<double>::infinity();
  /// Whether, with `between_stops`, the vehicle stands at the start: the path may begin with any
  /// curvature. Otherwise it begins with `start_curvature`. Ignored with `throughout`.
  bool start_stands = true;
  /// Whether, with `between_stops`, the vehicle stands at the goal: the path may end with any
  /// curvature. Otherwise it ends with `goal_curvature`. Ignored with `throughout`.
  bool goal_stands = true;
};

/// Range of curvature_rate * radius^2 of `ContinuousSteering`. Below it no vehicle gets to full
/// lock; above it turning the wheels takes next to no way.
inline constexpr struct {
  double least = 1e-4;
  double most = 1e9;
} supported_sharpness;

/// Short paths on open ground in either gear. Everywhere |curvature| is at most 1/radius, and its
/// change per metre at most curvature_rate. Between any two poses there is such a path. It is the
/// shortest word that the search finds, and no shorter than `reeds_shepp_length`.
///
/// Poses of a call share one frame. A small value: make it once, call it often, from any thread.
class ContinuousSteering {
 public:
  /// Makes the steering. Throws InputError naming "radius" unless it is finite and > 0 [m], or
  /// "curvature_rate" unless it is finite, > 0 [1/m^2] and within `supported_sharpness`.
  ContinuousSteering(double radius, double curvature_rate, Continuity continuity);

  /// The shortest path found. It begins and ends with straight wheels or, with `between_stops`,
  /// with any curvature. Throws InputError naming "from" or "to" if the pose is not finite.
  [[nodiscard]] Piece steer(const Pose& from, const Pose& to) const;

  /// The shortest path found; none if it is longer than the cutoff. Throws InputError naming "from"
  /// or "to" if the pose is not finite, "start_curvature" or "goal_curvature" if it is beyond
  /// 1/radius, or "cutoff" if it is NaN.
  [[nodiscard]] std::optional<Piece> steer(const Pose& from, const Pose& to,
                                           const ContinuousQuery& query) const;

  /// Length of `steer(from, to)`, bit for bit [m].
  [[nodiscard]] double length(const Pose& from, const Pose& to) const;

  /// Length of `steer(from, to, query)`, bit for bit [m]; infinite if it is longer than the cutoff.
  [[nodiscard]] double length(const Pose& from, const Pose& to, const ContinuousQuery& query) const;

  /// All paths by these words up to the cutoff, in no order. Throws InputError as `steer` does.
  [[nodiscard]] std::vector<Piece> candidates(const Pose& from, const Pose& to,
                                              const ContinuousQuery& query) const;

  /// The turning radius [m].
  [[nodiscard]] double radius() const noexcept { return radius_; }
  /// The largest change of curvature per metre [1/m^2].
  [[nodiscard]] double curvature_rate() const noexcept { return curvature_rate_; }
  [[nodiscard]] Continuity continuity() const noexcept { return continuity_; }

 private:
  double radius_;
  double curvature_rate_;
  Continuity continuity_;
  std::array<double, 8> turns_{};  ///< constants of steering::SharpTurns
};

// ---- Which path is short for a tractor with a trailer? ----
//
// The paths are words of arcs and lines of the tractor that also end with the wanted hitch angle.
// Method and what is optimal: docs/algorithms/rig_steering.md.

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
