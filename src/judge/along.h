// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How near does the vehicle come to things on its way, in the eyes of the judge?
//
// Method and proof: docs/algorithms/path_check.md.

#include <optional>

#include "judge/ground.h"
#include "judge/track.h"

namespace vandplan::judge {

struct Nearest {
  double clearance = 0.0;      ///< the least on the way, to 1 mm [m]; infinity if there is nothing
  std::optional<Place> touch;  ///< the first on the way; none if `clearance` is above 0
  Effort effort;
};

/// Looks wherever a point of the vehicle has moved by a millimetre, except where nothing can be
/// nearer than what is known.
[[nodiscard]] Nearest nearest_along(const Track& track, const Ground& ground,
                                    const Outlines& outlines);

}  // namespace vandplan::judge
