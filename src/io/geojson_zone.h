// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which zones does a feature of a GeoJSON file make?

#include <vector>

#include "io/geojson_feature.h"
#include "vandplan/problem.h"

namespace vandplan::io {

/// The rules of a feature of kind zone, one-way or speed, from its properties, which have the keys
/// of zones in scenarios. The area is empty. A one-way street with a heading allows a quarter of a
/// turn to both sides. Throws InputError naming the property that is wrong or missing.
[[nodiscard]] Zone rules_of(const Document& file, const Feature& feature);

/// Zones along a line that is driven from its begin to its end, `width` wide [m].
[[nodiscard]] std::vector<Zone> street_along(const std::vector<Point>& line, double width,
                                             const Zone& rules);

}  // namespace vandplan::io
