// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// On which side of a line is a point, exactly?

#include "vandplan/geometry.h"

namespace vandplan::geometry {

/// 1 if the way from a over b to c turns left, -1 if it turns right, 0 if the three points are on
/// one line. Never wrong, as long as no product of two coordinates leaves the range of doubles:
/// J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates" (1997).
[[nodiscard]] int orientation(const Point& a, const Point& b, const Point& c);

}  // namespace vandplan::geometry
