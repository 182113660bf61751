// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How many times as much does a metre of a track cost in zones, in the eyes of the judge?
//
// Method: docs/algorithms/path_check.md, "Zones".

#include <cstddef>
#include <vector>

#include "judge/track.h"
#include "judge/trailing.h"
#include "vandplan/problem.h"
#include "vandplan/vehicle.h"

namespace vandplan::judge {

/// Part of a stretch where the price of a metre is `factor` times the usual one.
struct PricedPart {
  std::size_t stretch = 0;
  Real begin = 0, end = 0;  ///< driven distances from the start of the stretch [m]
  Real factor = 1;
};

/// Which positions at the edge of an area count as inside. What is less than a micrometre from the
/// edge (a body: 1.5 mm) may be taken for either.
enum class AtEdge { inside, outside };

/// Parts of all stretches of a track, in order. `trailing` is null without a trailer.
[[nodiscard]] std::vector<PricedPart> priced_parts(const std::vector<Zone>& zones,
                                                   const Vehicle& vehicle, const Track& track,
                                                   const Trailing* trailing, AtEdge at_edge);

/// Whether a zone has a price.
[[nodiscard]] bool has_prices(const std::vector<Zone>& zones);

}  // namespace vandplan::judge
