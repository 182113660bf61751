// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How near does the vehicle come to things on its way, in the eyes of the judge?
//
// Method and proof: docs/algorithms/path_check.md.

#include <optional>
#include <vector>

#include "judge/body.h"
#include "judge/track.h"

namespace vandplan::judge {

/// Around a place less will do: `least` there, growing evenly with the distance of the rear axle up
/// to the margin at `reach` [m].
struct Ramp {
  Position centre;
  double least = 0.0;
  double reach = 1.0;
};

/// How far the vehicle, and what it pulls, must stay from things.
struct Keeping {
  double margin = 0.0;  ///< [m]
  std::vector<Ramp> ramps = {};

  /// The most that is asked for up to `half` metres from a place [m].
  [[nodiscard]] double most_within(const Position& place, double half) const;
};

struct Nearest {
  /// The least on the way beyond what must be kept, to 1 mm [m]; infinity if there is nothing.
  double clearance = 0.0;
  std::optional<Place> touch;  ///< the first on the way; none if `clearance` is above 0
  Effort effort;
};

/// Looks wherever a point of the vehicle has moved by a millimetre, except where nothing can be
/// nearer than what is known.
[[nodiscard]] Nearest nearest_along(const Body& body, const Keeping& keeping = {});

}  // namespace vandplan::judge
