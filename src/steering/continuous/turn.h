// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where does a turn of a given length lead if the wheels take their time?
//
// Lengths are in turning radii, so that full lock is curvature 1. `sharpness` is the largest change
// of curvature per radius driven. Formulas: docs/algorithms/continuous_steering.md.

#include <array>

#include "base/trigonometry.h"

namespace vandplan::steering::continuous {

/// How the curvature is at either end of a turn: 0, or free because the vehicle stands there.
enum class TurnEnds { rolling, stands_before, stands_after, stands_at_both };

/// Places of a path where the curvature may jump because the vehicle stands.
struct Stops {
  bool start = false;
  bool inside = false;  ///< gear changes between start and goal
  bool goal = false;

  bool operator==(const Stops&) const = default;

  /// Stops of the way from the goal to the start.
  [[nodiscard]] Stops swapped() const noexcept { return {goal, inside, start}; }
};

/// Whether the curvature may jump inside, but not at both ends: on a leg of a longer way.
inline bool is_leg(const Stops& stops) { return stops.inside && !(stops.start && stops.goal); }

/// Displacement along a left turn driven forward, with derivatives by its length. A negative length
/// is the left turn in reverse: chord and angle are odd functions of the length.
struct Turned {
  double x = 0.0, y = 0.0;                ///< end of the turn in the frame of its start
  double slope_x = 0.0, slope_y = 0.0;    ///< derivatives of x and y by the length
  double angle = 0.0, angle_slope = 0.0;  ///< change of heading [rad], and its derivative
  double sin = 0.0, cos = 1.0;            ///< sine and cosine of `angle`

  /// The turn from its end to its start, as a left turn driven forward. Valid for a turn that ends
  /// in the direction of `slope`.
  [[nodiscard]] Turned reversed() const noexcept;
};

/// The sharpest turns of all lengths. The curvature rises as fast as it may, stays at full lock if
/// it gets there, and falls as fast as it may. Where the vehicle stands, it jumps.
class SharpTurns {
 public:
  /// `sharpness`: largest change of curvature per radius driven; > 0.
  explicit SharpTurns(double sharpness) noexcept;

  /// Turns made from the numbers of `constants()`.
  explicit SharpTurns(const std::array<double, 8>& constants) noexcept;

  /// All members as numbers. Working them out costs a clothoid, copying them nothing.
  [[nodiscard]] std::array<double, 8> constants() const noexcept;

  [[nodiscard]] double sharpness() const noexcept { return sharpness_; }
  /// Length of a clothoid from straight to full lock.
  [[nodiscard]] double ramp() const noexcept { return ramp_; }

  struct Point {
    double x, y;
  };
  /// Centre of the circle that a clothoid to full lock leads into, to the left.
  [[nodiscard]] Point centre() const noexcept { return {centre_x_, centre_y_}; }
  /// Distance of `centre()` from the start of the clothoid.
  [[nodiscard]] double reach() const noexcept { return reach_; }
  /// Angle by which `centre()` is ahead of the perpendicular at the start of the clothoid [rad].
  [[nodiscard]] double skew() const noexcept { return skew_; }

  /// The turn of a length, to the left; in reverse if the length is negative.
  [[nodiscard]] Turned turn(double length, TurnEnds ends) const noexcept;

  /// Length of all clothoids of a turn that reaches full lock.
  [[nodiscard]] double ramps_of(TurnEnds ends) const noexcept {
    return ends == TurnEnds::rolling ? 2 * ramp_ : ends == TurnEnds::stands_at_both ? 0 : ramp_;
  }

  /// The length of the turn by `angle` >= 0.
  [[nodiscard]] double length_of(double angle, TurnEnds ends) const noexcept;

  /// The largest curvature on a turn of a length.
  [[nodiscard]] double peak(double length, TurnEnds ends) const noexcept;

  /// End of a clothoid of `length` >= 0 that begins straight and turns left.
  [[nodiscard]] Point clothoid(double length) const noexcept;

 private:
  struct Chord {
    double length, slope;  ///< slope: derivative by the length of the turn
  };
  /// Chord of two clothoids, of `length` >= 0 together, that turn by `half_angle` each.
  [[nodiscard]] Chord chord(double length, double half_angle,
                            const base::SinCos& half) const noexcept;
  [[nodiscard]] Turned rolling(double length) const noexcept;
  [[nodiscard]] Turned to_stop(double length) const noexcept;

  double sharpness_;
  double ramp_;
  Point full_;                  ///< end of the clothoid to full lock
  double centre_x_, centre_y_;  ///< centre of the circle after that clothoid
  double reach_, skew_;         ///< distance of that centre, and its angle off the perpendicular
};

/// Where the circles of a word lie: seen from its ends, and from each other.
struct Joints {
  Joints(const SharpTurns& turns, const Stops& stops) noexcept
      : ahead(turns.centre().x),
        aside(turns.centre().y),
        start(turns, stops.start),
        goal(turns, stops.goal),
        stop(stops.inside ? 1 : aside),
        reach(turns.reach()),
        skew(turns.skew()) {}

  /// Centre of the first circle, seen from the start, or of the last one, seen from the goal.
  struct End {
    End(const SharpTurns& turns, bool stands) noexcept
        : ahead(stands ? 0 : turns.centre().x), aside(stands ? 1 : turns.centre().y) {}
    double ahead, aside;
  };

  double ahead, aside;  ///< centre of a circle, seen from where the wheels are straight
  End start, goal;
  double stop;   ///< half of the distance between centres across a gear change
  double reach;  ///< half of the distance between centres across straight wheels, to the other side
  double skew;   ///< angle of that direction off the perpendicular [rad]
};

}  // namespace vandplan::steering::continuous
