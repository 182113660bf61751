// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Boxes made of boxes.

#include <algorithm>

#include "vandplan/geometry.h"

namespace vandplan::geometry {

/// The smallest box around two boxes [m].
[[nodiscard]] inline Bounds united(const Bounds& a, const Bounds& b) noexcept {
  return {std::min(a.x_min, b.x_min), std::max(a.x_max, b.x_max), std::min(a.y_min, b.y_min),
          std::max(a.y_max, b.y_max)};
}

/// What two boxes share [m]. Limits are crossed if they share nothing.
[[nodiscard]] inline Bounds shared(const Bounds& a, const Bounds& b) noexcept {
  return {std::max(a.x_min, b.x_min), std::min(a.x_max, b.x_max), std::max(a.y_min, b.y_min),
          std::min(a.y_max, b.y_max)};
}

/// The box with each side moved outwards by `by` [m].
[[nodiscard]] inline Bounds widened(const Bounds& box, double by) noexcept {
  return {box.x_min - by, box.x_max + by, box.y_min - by, box.y_max + by};
}

}  // namespace vandplan::geometry
