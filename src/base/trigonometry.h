// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which trigonometric functions does the core call?
//
// All of the core goes through these, never through <cmath>, so that an answer does not depend on
// which variant of a function the C library picks for a processor.

namespace vandplan::base {

/// Sine and cosine of one angle.
struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine of an angle [rad], both within 1 unit in the last place, for angles of any size;
/// NaN for infinity and NaN.
[[nodiscard, gnu::const]] SinCos sin_cos(double angle) noexcept;

/// The angle in [-pi, pi] of the vector (x, y) [rad], within 2.5 units in the last place; like
/// std::atan2 for zeros, infinities and NaN.
[[nodiscard, gnu::const]] double atan_2(double y, double x) noexcept;

}  // namespace vandplan::base
