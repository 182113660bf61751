// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does nearness to obstacles add to the cost of a path, in the eyes of the judge?

#include <span>

#include "judge/body.h"
#include "judge/zone_prices.h"
#include "vandplan/plan_options.h"

namespace vandplan::judge {

/// Integral of `clearance_weight` max(0, 1 - clearance / `clearance_distance`) along the parts of a
/// track [m]. At each place the body with the least clearance counts. Each metre also has the
/// weight of its gear and the factor of its part.
[[nodiscard]] double near_cost(std::span<const Body> bodies, const CostOptions& stated,
                               std::span<const PricedPart> parts);

/// What the factors of the parts add to the price of the metres of a track [m].
[[nodiscard]] double zone_cost(const Track& track, const CostOptions& stated,
                               std::span<const PricedPart> parts);

}  // namespace vandplan::judge
