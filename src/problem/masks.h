// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which masks are valid, and which obstacles stand for the cells of a mask?

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "vandplan/collision.h"

namespace vandplan::problem {

/// Masks moved from the scenario's frame into the frame of `origin`. Throws InputError naming
/// "masks[1].map", or "masks[1]" for values that are no speed or cost.
[[nodiscard]] std::vector<Mask> local_masks(const std::vector<Mask>& masks, const Point& origin);

/// Checks that cells of a mask may have these percentages. Throws InputError naming `where` for one
/// that is no speed or cost.
void check_percents(const Mask& mask, std::span<const std::uint8_t> percents,
                    const std::string& where);

/// Rectangles that cover the occupied cells of a map, and nothing else, in the map's frame.
[[nodiscard]] std::vector<Polygon> rectangles_over(const OccupancyGrid& map);

}  // namespace vandplan::problem
