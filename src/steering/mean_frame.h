// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do two poses look from half way between them?
//
// Seen from the midpoint, under the mean of both headings, every symmetry of shortest paths is a
// change of sign: docs/algorithms/steering.md.

#include "base/trigonometry.h"
#include "vandplan/geometry.h"

namespace vandplan::steering {

/// The relative pose of two poses. Lengths are in turning radii. The first pose is (-x/2, -y/2,
/// -half_turn), the second (x/2, y/2, half_turn). Swapping the poses changes only the three signs.
struct MeanFrame {
  double x = 0.0;
  double y = 0.0;
  double half_turn = 0.0;  ///< half of the change of heading, in [-pi/2, pi/2]
};

/// The mean frame of two poses for a turning `radius` > 0 [m].
[[nodiscard]] MeanFrame mean_frame(const Pose& from, const Pose& to, double radius) noexcept;

/// The mean of two headings, and half of the turn between them.
struct MeanHeading {
  double mean;        ///< half of the sum of both headings [rad]
  double half_turn;   ///< half of the change of heading, in [-pi/2, pi/2]
  bool is_backwards;  ///< the x axis of the mean frame points opposite to `mean`
};
[[nodiscard]] MeanHeading mean_heading(double from, double to) noexcept;

/// The mean frame of two poses. `heading` is the result of `mean_heading`, `mean` has the sine and
/// cosine of `heading.mean`.
[[nodiscard]] MeanFrame mean_frame(const Pose& from, const Pose& to, double radius,
                                   const MeanHeading& heading, const base::SinCos& mean) noexcept;

/// A mean frame, with numbers about the turning circles (radius 1) of its poses for all formulas.
struct Circles {
  explicit Circles(const MeanFrame& frame) noexcept
      : Circles(frame, base::sin_cos(frame.half_turn)) {}

  /// `half`: sine and cosine of the half turn of `frame`.
  Circles(const MeanFrame& frame, const base::SinCos& half) noexcept
      : x(frame.x), y(frame.y), a(frame.half_turn), s(half.sin), c(half.cos) {
    const double shared = (x - 2 * s) * (x + 2 * s);
    lr = shared + y * (y - 4 * c);
    rl = shared + y * (y + 4 * c);
  }

  double x, y;
  double a, s, c;  ///< half turn, its sine and cosine
  double lr;       ///< squared distance from the first left to the last right circle, less 4
  double rl;       ///< squared distance from the first right to the last left circle, less 4
};

}  // namespace vandplan::steering
