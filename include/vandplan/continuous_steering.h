// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which short path can a vehicle drive that needs time to turn its wheels?
//
// The words of Reeds and Shepp with turns whose curvature rises and falls at a limited rate
// (Fraichard & Scheuer 2004). Method and what is optimal: docs/algorithms/continuous_steering.md.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "vandplan/geometry.h"
#include "vandplan/path.h"

namespace vandplan {

/// Where the curvature of a path goes on without a jump.
enum class Continuity : std::uint8_t {
  between_stops,  ///< it may jump where the vehicle stands: at gear changes, at start and goal
  throughout,     ///< it never jumps, through gear changes too
};

/// What a steering call asks for beside its two poses.
struct ContinuousQuery {
  double start_curvature = 0.0;  ///< at most 1/radius [1/m]; of no account if it stands there
  double goal_curvature = 0.0;   ///< at most 1/radius [1/m]; of no account if it stands there
  double cutoff = std::numeric_limits<double>::infinity();  ///< longer paths are of no use [m]
  /// Between stops: the vehicle stands at the start and may have turned its wheels there, as the
  /// path wants; else the path begins with `start_curvature`. Of no account throughout.
  bool start_stands = true;
  /// Between stops: the vehicle stands at the goal and the path may end with any curvature; else it
  /// ends with `goal_curvature`. Of no account throughout.
  bool goal_stands = true;
};

/// curvature_rate * radius^2 of `ContinuousSteering`: below, no vehicle gets to full lock; above,
/// turning the wheels takes next to no way.
inline constexpr struct {
  double least = 1e-4;
  double most = 1e9;
} supported_sharpness;

/// Short paths on open ground in either gear with |curvature| <= 1/radius and |change of curvature
/// per metre| <= curvature_rate. Between any two poses there is one. It is the least of the
/// families that the document names; no path is shorter than `reeds_shepp_length`. A small value:
/// make it once, call it often, from any thread.
class ContinuousSteering {
 public:
  /// `radius` > 0 [m], `curvature_rate` > 0 [1/m^2], both finite, and their sharpness supported,
  /// else InputError.
  ContinuousSteering(double radius, double curvature_rate, Continuity continuity);

  /// The least path. It begins and ends with the wheels straight or, between stops, as it wants.
  /// Throws InputError if a pose is not finite.
  [[nodiscard]] Piece steer(const Pose& from, const Pose& to) const;

  /// The least path, or nothing if it is longer than the cutoff. Throws InputError if a pose is not
  /// finite, a curvature is beyond 1/radius or the cutoff is NaN.
  [[nodiscard]] std::optional<Piece> steer(const Pose& from, const Pose& to,
                                           const ContinuousQuery& query) const;

  /// Length of `steer(from, to)`, bit for bit [m].
  [[nodiscard]] double length(const Pose& from, const Pose& to) const;

  /// Length of `steer(from, to, query)`, bit for bit; infinity if it is longer than the cutoff [m].
  [[nodiscard]] double length(const Pose& from, const Pose& to, const ContinuousQuery& query) const;

  /// Every path of the families up to the cutoff, in no order.
  [[nodiscard]] std::vector<Piece> candidates(const Pose& from, const Pose& to,
                                              const ContinuousQuery& query) const;

  [[nodiscard]] double radius() const noexcept { return radius_; }
  [[nodiscard]] double curvature_rate() const noexcept { return curvature_rate_; }
  [[nodiscard]] Continuity continuity() const noexcept { return continuity_; }

 private:
  double radius_;
  double curvature_rate_;
  Continuity continuity_;
  std::array<double, 8> turns_{};  ///< constants of steering::SharpTurns
};

}  // namespace vandplan
