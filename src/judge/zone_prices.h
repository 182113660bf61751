// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How much does a metre of a track cost in zones and masks, and how fast may it be driven, in the
// eyes of the judge?
//
// Method: docs/lab/zones.md.

#include <cstddef>
#include <limits>
#include <vector>

#include "judge/track.h"
#include "judge/trailing.h"
#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan::judge {

/// Part of a stretch where the price of a metre is `factor` times the usual one, and the speed is
/// at most `max_speed` [m/s].
struct PricedPart {
  std::size_t stretch = 0;
  Real begin = 0, end = 0;  ///< driven distances from the start of the stretch [m]
  Real factor = 1;
  Real max_speed = std::numeric_limits<Real>::infinity();
};

/// Which positions at the edge of an area count as inside. What is less than a micrometre from the
/// edge (a body: 1.5 mm) may be taken for either.
enum class AtEdge { inside, outside };

/// Parts of all stretches of a track, in order. `trailing` is null without a trailer.
[[nodiscard]] std::vector<PricedPart> priced_parts(const Surroundings& ground,
                                                   const Vehicle& vehicle, const Track& track,
                                                   const Trailing* trailing, AtEdge at_edge);

/// Whether a zone or mask has a price or a largest speed.
[[nodiscard]] bool has_prices(const Surroundings& ground);

/// Largest speed at a place by the parts of a track [m/s].
[[nodiscard]] Real max_speed_at(const std::vector<PricedPart>& parts, const Place& place);

}  // namespace vandplan::judge
