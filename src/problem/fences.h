// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a body stay inside an area? It begins there, and meets a fence before it leaves.

#include <cstddef>
#include <span>
#include <vector>

#include "vandplan/geometry.h"

namespace vandplan::problem {

/// Areas of the scenario's frame in the frame of `origin`, cleaned, corners counter-clockwise.
/// Throws InputError naming "inside[1]" if one is no simple polygon, or has something in common
/// with another one.
[[nodiscard]] std::vector<Polygon> local_areas(const std::vector<Polygon>& areas,
                                               const Point& origin);

/// A thin fence outside of each side, in the order of the areas and of their sides.
[[nodiscard]] std::vector<Polygon> fences_around(std::span<const Polygon> areas);

}  // namespace vandplan::problem
