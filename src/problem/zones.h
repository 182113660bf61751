// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which zones are valid, and where are they in the frame of a world?

#include <vector>

#include "vandplan/collision.h"

namespace vandplan::problem {

/// Zones moved from the scenario's frame into the frame of `origin`; their areas are cleaned.
/// Throws InputError naming "zones[1].area", "zones[1].direction", or "zones[1]" for a zone without
/// a rule.
[[nodiscard]] std::vector<Zone> local_zones(const std::vector<Zone>& zones, const Point& origin);

}  // namespace vandplan::problem
