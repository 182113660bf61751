// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where does a turn of a given length lead if the wheels take their time?
//
// Lengths are in turning radii, so that full lock is curvature 1; `sharpness` is the most that the
// curvature may change per radius driven. Formulas: docs/algorithms/continuous_steering.md.

#include <array>

#include "base/trigonometry.h"

namespace vandplan::steering {

/// How the curvature is at either end of a turn: 0, or free because the vehicle stands there.
enum class Ends { rolling, stands_before, stands_after, stands_at_both };

/// Where on its way the curvature may jump because the vehicle stands.
struct Stops {
  bool start = false;
  bool inside = false;  ///< at gear changes between start and goal
  bool goal = false;

  bool operator==(const Stops&) const = default;

  /// Of the way from the goal to the start.
  [[nodiscard]] Stops swapped() const noexcept { return {goal, inside, start}; }
};

/// What a turn to the left driven forward does, and how that changes with its length. Of a negative
/// length it is the turn to the left in reverse: way and angle are odd functions in its own frame.
struct Turned {
  double x = 0.0, y = 0.0;              ///< the way in the frame at its start
  double slope_x = 0.0, slope_y = 0.0;  ///< its derivative by the length
  double angle = 0.0, angle_slope = 0.0;
  double sin = 0.0, cos = 1.0;  ///< of the angle

  /// Of a turn that ends in the direction of `slope`: the same driven the other way round, from its
  /// end, as a turn to the left driven forward.
  [[nodiscard]] Turned reversed() const noexcept;
};

/// The sharpest turns of all lengths: the curvature rises as fast as it may, stays at full lock if
/// it gets there, and falls as fast as it may; where the vehicle stands, it jumps.
class SharpTurns {
 public:
  /// `sharpness` > 0.
  explicit SharpTurns(double sharpness) noexcept;

  /// What `constants()` of another gave.
  explicit SharpTurns(const std::array<double, 8>& constants) noexcept;

  /// All that there is to know; costs one clothoid to work out, nothing to copy.
  [[nodiscard]] std::array<double, 8> constants() const noexcept;

  [[nodiscard]] double sharpness() const noexcept { return sharpness_; }
  /// Length of a clothoid from straight to full lock.
  [[nodiscard]] double ramp() const noexcept { return ramp_; }

  struct Point {
    double x, y;
  };
  /// Centre of the circle that a clothoid to full lock leads into, to the left.
  [[nodiscard]] Point centre() const noexcept { return {centre_x_, centre_y_}; }
  /// How far that centre is.
  [[nodiscard]] double reach() const noexcept { return reach_; }
  /// How far ahead of the perpendicular it is seen [rad].
  [[nodiscard]] double skew() const noexcept { return skew_; }

  [[nodiscard]] Turned turn(double length, Ends ends) const noexcept;

  /// Length of the clothoids of a turn that reaches full lock.
  [[nodiscard]] double ramps_of(Ends ends) const noexcept {
    return ends == Ends::rolling ? 2 * ramp_ : ends == Ends::stands_at_both ? 0 : ramp_;
  }

  /// The length of the turn by `angle` >= 0.
  [[nodiscard]] double length_of(double angle, Ends ends) const noexcept;

  /// The largest curvature on a turn of some length.
  [[nodiscard]] double peak(double length, Ends ends) const noexcept;

  /// Where a clothoid leads that begins straight and turns left, after `length` >= 0.
  [[nodiscard]] Point clothoid(double length) const noexcept;

 private:
  struct Chord {
    double way, slope;  ///< and its derivative by the length
  };
  /// Of two clothoids of `length` >= 0 together that turn by `half_angle` each.
  [[nodiscard]] Chord chord(double length, double half_angle,
                            const base::SinCos& half) const noexcept;
  [[nodiscard]] Turned rolling(double length) const noexcept;
  [[nodiscard]] Turned to_stop(double length) const noexcept;

  double sharpness_;
  double ramp_;
  Point full_;                  ///< where the clothoid to full lock leads
  double centre_x_, centre_y_;  ///< of the circle that it leads into
  double reach_, skew_;         ///< how far that centre is, and how far off the perpendicular
};

/// Distances between the centres of neighbouring circles.
struct Joints {
  Joints(const SharpTurns& turns, const Stops& stops) noexcept
      : ahead(turns.centre().x),
        aside(turns.centre().y),
        start(turns, stops.start),
        goal(turns, stops.goal),
        stop(stops.inside ? 1 : aside),
        reach(turns.reach()),
        skew(turns.skew()) {}

  /// The centre of the first circle from the start, or of the last from the goal.
  struct End {
    End(const SharpTurns& turns, bool stands) noexcept
        : ahead(stands ? 0 : turns.centre().x), aside(stands ? 1 : turns.centre().y) {}
    double ahead, aside;
  };

  double ahead, aside;  ///< centre of a circle from where the wheels are straight
  End start, goal;
  double stop;   ///< half of the distance across a gear change
  double reach;  ///< half of the distance across straight wheels to the other side
  double skew;   ///< how far that direction is off the perpendicular
};

}  // namespace vandplan::steering
