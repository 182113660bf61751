// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where does a clothoid lead?
//
// Method and proof of the error: docs/algorithms/clothoid.md.

#include "vandplan/path.h"

namespace vandplan::path {

/// How a vehicle moves along a segment, in its frame at the start: x forward, y left.
struct Displacement {
  double x = 0.0;     ///< [m]
  double y = 0.0;     ///< [m]
  double turn = 0.0;  ///< change of heading, whole turns included [rad]
};

/// Displacement along a segment of any curvature rate. The time is bounded whatever the numbers;
/// NaN if they overflow.
[[nodiscard]] Displacement along_clothoid(const Segment& segment) noexcept;

}  // namespace vandplan::path
