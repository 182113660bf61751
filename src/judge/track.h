// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where is the vehicle along a path, in the eyes of the judge?
//
// The judge is a second implementation on purpose: nothing in this folder calls code that planners
// use, not even `advance` or `corners`.

#include <compare>
#include <cstddef>
#include <numbers>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::judge {

/// Number type of the judge. It has more digits than the numbers that are judged, except in
/// WebAssembly. There double is the widest type in hardware: looks have a rounding error of 1e-9 m.
#ifdef __wasm__
using Real = double;
#else
using Real = long double;
#endif

inline constexpr Real full_turn = 2 * std::numbers::pi_v<Real>;

struct Position {
  Real x = 0;
  Real y = 0;
  Real heading = 0;
};

/// Cosine and sine of an angle.
struct Direction {
  Real cos = 1;
  Real sin = 0;
};

[[nodiscard]] Direction direction_of(Real angle);

/// Position with cosine and sine of its heading.
struct Placement {
  Position position;
  Direction direction;
};

/// A segment with its start pose. A clothoid is cut into stretches so short that `after` is exact.
struct Stretch {
  Position start;
  Real curvature = 0;    ///< curvature at the start [1/m]
  Real direction = 1;    ///< gear: 1 forward, -1 reverse
  Real length = 0;       ///< driven length [m]; >= 0
  Real s = 0;            ///< distance from the start of the track to the stretch [m]
  Real rate = 0;         ///< change of the curvature per metre driven [1/m^2]
  bool is_first = true;  ///< whether a segment begins here
  Direction ahead = direction_of(start.heading);  ///< direction of the heading at the start
};

/// Largest numbers of stretches of one clothoid, and of all clothoids of a path. Other paths wind
/// too often to be judged.
inline constexpr Real most_stretches = 1e4L;
inline constexpr Real most_stretches_of_all = 1e6L;

/// Number of stretches of a segment: 1, or for a clothoid as many as `after` needs.
[[nodiscard]] Real stretches_of(const Segment& segment);

/// Curvature `t` metres into a stretch [1/m].
[[nodiscard]] inline Real curvature_at(const Stretch& stretch, Real t) {
  return stretch.curvature + stretch.rate * t;
}

/// The largest absolute curvature on a stretch [1/m].
[[nodiscard]] Real steepest(const Stretch& stretch);

/// Place `t` metres into a stretch.
struct Place {
  std::size_t stretch = 0;
  Real t = 0;
  auto operator<=>(const Place&) const = default;  // as driven
};

struct Track {
  std::vector<Stretch> stretches;  ///< stretches of the path; never empty
  Position end;
  Real length = 0;
  Real reverse_length = 0;
  int gear_changes = 0;
  Real curvature_change = 0;  ///< total variation of the curvature along the track [1/m]
};

/// The place where a track ends.
[[nodiscard]] inline Place end_of(const Track& track) {
  return {track.stretches.size() - 1, track.stretches.back().length};
}

/// Integrates a path. Its numbers must be finite, and its clothoids must not exceed
/// `most_stretches` and `most_stretches_of_all`.
[[nodiscard]] Track integrate(const Path& path);

[[nodiscard]] Placement placement_after(const Stretch& stretch, Real t);

[[nodiscard]] inline Position after(const Stretch& stretch, Real t) {
  return placement_after(stretch, t).position;
}

[[nodiscard]] PathPoint point_at(const Track& track, const Place& place);

}  // namespace vandplan::judge
