// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is the vehicle from an obstacle that it sees, in the eyes of the judge?
//
// Method: docs/algorithms/path_check.md; proof: docs/proofs/judge.md.

#include <cstddef>
#include <span>
#include <vector>

#include "judge/track.h"
#include "vandplan/geometry.h"

namespace vandplan::judge {

/// Convex body in the vehicle's frame, x forward from the rear axle, y to the left. It contains the
/// origin.
struct Outline {
  double x_min, x_max, y_min, y_max;  ///< bounding box of the body
  std::vector<Point> corners = {};    ///< corners, counter-clockwise; empty: the body is the box
};

/// Body with the given corners, in either orientation.
[[nodiscard]] Outline outline_with(const Polygon& corners);

/// Calls `look` with each corner.
template <typename Look>
void for_each_corner(const Outline& body, Look look) {
  for (const Point& corner : body.corners) look(corner);
  if (!body.corners.empty()) return;
  look(Point{body.x_min, body.y_min});
  look(Point{body.x_max, body.y_min});
  look(Point{body.x_max, body.y_max});
  look(Point{body.x_min, body.y_max});
}

/// Positions of a track up to `half` metres behind and ahead of one position.
struct Passage {
  Position middle;
  double curvature = 0.0;  ///< curvature in the middle [1/m]
  double half = 0.0;       ///< half length of the passage [m]; 0: `middle` alone
  double rate = 0.0;       ///< change of the curvature per metre driven [1/m^2]
};

/// A passage and the frame of the vehicle in its middle. Sine and cosine are computed once for all
/// obstacles.
struct View {
  Passage passage;
  Real cos, sin;  ///< cosine and sine of the heading in the middle
  Point axle;     ///< position in the middle, rounded to doubles
  Point axis;     ///< unit vector of the heading in the middle, rounded to doubles
};

[[nodiscard]] View view_of(const Passage& passage);
[[nodiscard]] View view_of(const Passage& passage, const Direction& heading);

/// A point of the world in the frame of the vehicle in the middle.
[[nodiscard]] inline Point seen(const View& view, const Point& p) {
  const double dx = p.x - view.axle.x;
  const double dy = p.y - view.axle.y;
  return {dx * view.axis.x + dy * view.axis.y, dy * view.axis.x - dx * view.axis.y};
}

/// All points within `radius` of the straight line from a to b. A bar is a side of a polygon
/// (radius 0), a disc (a = b), or a region that contains many sides.
struct Bar {
  Point a, b;
  double radius = 0.0;  ///< distance from the line up to which points belong to the bar [m]
};

[[nodiscard]] inline Bar seen(const View& view, const Bar& bar) {
  return {seen(view, bar.a), seen(view, bar.b), bar.radius};
}

/// Work of the judge, for statistics.
struct Effort {
  std::size_t looks = 0;    ///< number of passages and positions that were checked
  std::size_t visited = 0;  ///< number of bars and squares of cells that were measured
  std::size_t made = 0;     ///< number of nodes that were added to trees of polygons
  std::size_t parts = 0;    ///< largest number of parts of the track in the queue
};

/// Distance of the furthest point of a body from its rear axle [m].
[[nodiscard]] double reach_of(const Outline& body);

/// Largest distance of a point of the body from its place on a passage of constant curvature [m].
[[nodiscard]] double deviation(const Passage& passage, const Outline& body);

/// Distance between the closed body and a bar in the vehicle's frame [m], if the curvature is
/// constant. At one position it is exact for radius 0, otherwise a lower bound, which may be
/// negative. On a passage it is a lower bound for all positions. From `most` on it need not be
/// exact.
[[nodiscard]] double clearance_of_bar(const Passage& passage, const Outline& body, const Bar& bar,
                                      double most);

/// Clearance of a closed polygon in the vehicle's frame [m]; 0 if one contains the other. Values
/// are cut off at `most`.
[[nodiscard]] double clearance_of_seen(const Passage& passage, const Outline& body,
                                       std::span<const Point> polygon, double most);

/// Lower bound of the clearance of everything within a disc in the vehicle's frame [m]. It may be
/// negative.
[[nodiscard]] double clearance_of_disc(const Passage& passage, const Outline& body,
                                       const Point& centre, double radius);

/// Upper bound of how far a point of the vehicle's frame approaches along a direction on a passage
/// of constant curvature [m].
[[nodiscard]] double approach(const Passage& passage, const Point& p, const Point& direction);

}  // namespace vandplan::judge
