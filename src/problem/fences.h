// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a body stay inside an area? It starts inside, and would hit a fence before it leaves.

#include <cstddef>
#include <span>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::problem {

/// Areas moved from the scenario's frame into the frame of `origin`, cleaned, corners
/// counter-clockwise. Throws InputError naming "inside[1]" if an area is no simple polygon, or
/// touches or overlaps another area.
[[nodiscard]] std::vector<Polygon> local_areas(const std::vector<Polygon>& areas,
                                               const Point& origin);

/// Fences: one thin polygon outside each side, in the order of the areas and of their sides.
[[nodiscard]] std::vector<Polygon> fences_around(std::span<const Polygon> areas);

}  // namespace vandplan::problem
