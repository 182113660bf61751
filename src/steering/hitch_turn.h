// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does the trailer follow at full lock and on lines?
//
// Lengths are in turning radii, so that the curvature of a turn is -1, 0 or 1. The hitch angle is
// represented by u, the tangent of its half. Formulas have numbers in
// docs/algorithms/rig_steering.md.

#include <array>
#include <cstddef>

namespace vandplan::steering {

/// Motion of a rig's trailer at unit turning radius.
class HitchTurn {
 public:
  /// `wheelbase` of the trailer > |hitch|; both in turning radii. `most`: the largest |u|.
  HitchTurn(double wheelbase, double hitch, double most) noexcept;

  [[nodiscard]] double most() const noexcept { return most_; }

  /// Change of u per radius driven forward at a turn of -1, 0 or 1 (2).
  [[nodiscard]] double rate(int turn, double u) const noexcept {
    const Riccati& r = of_turn(turn);
    return r.a + u * (r.b + r.c * u);
  }

  /// u at the end of a way, and its derivative to u at the start.
  struct After {
    double u = 0.0;
    double slope = 0.0;  ///< NaN where the trailer has folded up on the way
  };
  /// u after `way`, negative in reverse, at a turn of -1, 0 or 1 (3).
  [[nodiscard]] After after(int turn, double u, double way) const noexcept;

  /// u after `way`, negative in reverse, at any curvature (3).
  [[nodiscard]] After after_arc(double curvature, double u, double way) const noexcept;

  /// The way from one u to another at a turn of -1 or 1 (4), negative in reverse; NaN if none
  /// leads.
  [[nodiscard]] double way_between(int turn, double from, double to) const noexcept;

  /// The curvature at which u stays constant (5).
  [[nodiscard]] double hold_curvature(double u) const noexcept;

 private:
  /// Coefficients of du/ds = a + b u + c u^2 (2); square = b^2/4 - a c, root = sqrt |square|.
  struct Riccati {
    double a = 0.0, b = 0.0, c = 0.0, square = 0.0, root = 0.0;
    double inverse_root = 0.0;  // 1 / root; not used where the root is next to 0
  };
  [[nodiscard]] Riccati riccati(double curvature) const noexcept;
  [[nodiscard]] static After after(const Riccati& r, double u, double way) noexcept;
  [[nodiscard]] const Riccati& of_turn(int turn) const noexcept {
    return turns_[static_cast<std::size_t>(turn + 1)];
  }

  double wheelbase_;
  double hitch_;
  double most_;
  std::array<Riccati, 3> turns_{};
};

}  // namespace vandplan::steering
