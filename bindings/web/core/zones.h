// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do maps, zones and masks of JavaScript become values of the library?

#include <string>
#include <vector>

#include "bindings/web/core/values.h"

namespace vandplan::web {

/// Map from {origin, resolution, columns, rows, cells, unknown}.
[[nodiscard]] OccupancyGrid map_from(const val& given, const std::string& where);

/// Zones of a scenario; none if the key is missing.
[[nodiscard]] std::vector<Zone> zones_at(const val& scenario);

/// Masks of a scenario; none if the key is missing. Nav2 gives speeds in percent of `fastest`
/// [m/s].
[[nodiscard]] std::vector<Mask> masks_at(const val& scenario, double fastest);

}  // namespace vandplan::web
