// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which short path can a vehicle drive that needs time to turn its wheels?
//
// The words of Reeds and Shepp, with turns whose curvature rises and falls at a limited rate
// (Fraichard & Scheuer 2004). Method and what is optimal: docs/algorithms/continuous_steering.md.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/path.h"

namespace vandplan {

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

}  // namespace vandplan
