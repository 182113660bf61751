// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How near does the vehicle come to obstacles along its path, in the eyes of the judge?
//
// Method: docs/algorithms/path_check.md; proof: docs/proofs/judge.md.

#include <optional>
#include <vector>

#include "judge/body.h"
#include "judge/track.h"

namespace vandplan::judge {

/// Reduced margin around a place: `least` [m] at `centre`, growing linearly with the distance of
/// the rear axle up to the margin at `reach` [m].
struct Ramp {
  Position centre;
  double least = 0.0;
  double reach = 1.0;
};

/// Distance that the vehicle and its trailer must keep from obstacles.
struct Keeping {
  double margin = 0.0;  ///< margin away from all ramps [m]
  std::vector<Ramp> ramps = {};

  /// Upper bound of the required distance at places up to `half` metres from `place` [m].
  [[nodiscard]] double most_within(const Position& place, double half) const;
};

struct Nearest {
  /// Least clearance along the path, less the required distance [m]. It is at most 1 mm too large,
  /// and infinity without obstacles.
  double clearance = 0.0;
  std::optional<Place> touch;  ///< first touch along the path; none if `clearance` is above 0
  Effort effort;
};

/// Least clearance of a body along its track. The judge looks wherever a point of the body has
/// moved by a millimetre, except where no obstacle can be nearer than the least clearance so far.
[[nodiscard]] Nearest nearest_along(const Body& body, const Keeping& keeping = {});

}  // namespace vandplan::judge
