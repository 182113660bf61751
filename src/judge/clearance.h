// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far does the vehicle stay from a polygon, in the eyes of the judge?
//
// Method and proof: docs/algorithms/path_check.md.

#include <array>
#include <span>

#include "judge/track.h"
#include "vandplan/geometry.h"

namespace vandplan::judge {

/// A body in the vehicle frame, x forward from the rear axle, y to the left; it holds the origin.
struct Rectangle {
  double x_min, x_max, y_min, y_max;
};

[[nodiscard]] std::array<Point, 4> corners_of(const Rectangle& body);

/// All positions on the way through one position, up to `half` metres behind and ahead of it.
struct Passage {
  Position middle;
  double curvature = 0.0;  ///< in the middle [1/m]
  double half = 0.0;       ///< [m]; 0: `middle` alone
  double rate = 0.0;       ///< change of the curvature per metre driven [1/m^2]
};

/// The furthest point of a body from its rear axle [m].
[[nodiscard]] double reach_of(const Rectangle& body);

/// No point of a body is further than this from where it would be on a passage of constant
/// curvature [m].
[[nodiscard]] double deviation(const Passage& passage, const Rectangle& body);

/// Between the closed body and the closed polygon [m]. At one position it is the distance, 0 if
/// they touch or one holds the other; on a passage it is no more than that at any of its positions.
/// It is never more than `most`.
[[nodiscard]] double clearance(const Passage& passage, const Rectangle& body,
                               const Polygon& polygon, double most);

/// That for a polygon as it is seen from the vehicle in the middle, if the curvature is constant.
[[nodiscard]] double clearance_of_seen(const Passage& passage, const Rectangle& body,
                                       std::span<const Point> polygon, double most);

/// A lower bound of it, below 0 at times, for all that lies in a disc seen from there, if the
/// curvature is constant.
[[nodiscard]] double clearance_of_disc(const Passage& passage, const Rectangle& body,
                                       const Point& centre, double radius);

/// How much nearer a point, seen from the vehicle in the middle, may come along a direction, if the
/// curvature is constant.
[[nodiscard]] double approach(const Passage& passage, const Point& p, const Point& direction);

}  // namespace vandplan::judge
