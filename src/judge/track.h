// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where is the vehicle along a path, in the eyes of the judge?
//
// The judge is a second implementation on purpose: nothing in this folder calls code that planners
// use, not even `advance` or `corners`.

#include <cstddef>
#include <numbers>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::judge {

using Real = long double;

inline constexpr Real full_turn = 2 * std::numbers::pi_v<Real>;

struct Position {
  Real x = 0;
  Real y = 0;
  Real heading = 0;
};

/// A segment and where it begins.
struct Stretch {
  Position start;
  Real curvature = 0;
  Real direction = 1;  ///< 1 forward, -1 reverse
  Real length = 0;     ///< driven, >= 0
  Real s = 0;          ///< driven before
};

/// `t` metres into a stretch.
struct Place {
  std::size_t stretch = 0;
  Real t = 0;
};

struct Track {
  std::vector<Stretch> stretches;  ///< never empty
  Position end;
  Real length = 0;
  Real reverse_length = 0;
  int gear_changes = 0;
};

/// Every number of the path is finite.
[[nodiscard]] Track integrate(const Path& path);

[[nodiscard]] Position after(const Stretch& stretch, Real t);

[[nodiscard]] PathPoint point_at(const Track& track, const Place& place);

}  // namespace vandplan::judge
