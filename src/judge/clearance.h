// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far does the vehicle stay from what it sees, in the eyes of the judge?
//
// Method and proof: docs/algorithms/path_check.md.

#include <cstddef>
#include <span>
#include <vector>

#include "judge/track.h"
#include "vandplan/geometry.h"

namespace vandplan::judge {

/// A convex body in the vehicle frame, x forward from the rear axle, y to the left; it holds the
/// origin.
struct Outline {
  double x_min, x_max, y_min, y_max;  ///< of the box around it
  std::vector<Point> corners = {};    ///< counter-clockwise; none: it is that box
};

/// The body with these corners, in either order.
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

/// All positions on the way through one position, up to `half` metres behind and ahead of it.
struct Passage {
  Position middle;
  double curvature = 0.0;  ///< in the middle [1/m]
  double half = 0.0;       ///< [m]; 0: `middle` alone
  double rate = 0.0;       ///< change of the curvature per metre driven [1/m^2]
};

/// A passage and how the vehicle in its middle sees the world; sine and cosine are taken once for
/// all that is looked at.
struct View {
  Passage passage;
  Real cos, sin;  ///< of the heading in the middle
  Point axle;     ///< the position in the middle, rounded to doubles, ...
  Point axis;     ///< ... and where the vehicle points: cos and sin
};

[[nodiscard]] View view_of(const Passage& passage);
[[nodiscard]] View view_of(const Passage& passage, const Direction& heading);

/// A point of the world, seen from the vehicle in the middle.
[[nodiscard]] inline Point seen(const View& view, const Point& p) {
  const double dx = p.x - view.axle.x;
  const double dy = p.y - view.axle.y;
  return {dx * view.axis.x + dy * view.axis.y, dy * view.axis.x - dx * view.axis.y};
}

/// All points within `radius` of a straight line from a to b: a side of a polygon (radius 0), a
/// disc (a = b), or whatever many sides together fit in.
struct Bar {
  Point a, b;
  double radius = 0.0;  ///< [m]
};

[[nodiscard]] inline Bar seen(const View& view, const Bar& bar) {
  return {seen(view, bar.a), seen(view, bar.b), bar.radius};
}

/// How much was done, for those who want to know what an answer costs.
struct Effort {
  std::size_t looks = 0;    ///< passages and positions that were asked for
  std::size_t visited = 0;  ///< bars and squares of cells that were measured
  std::size_t made = 0;     ///< nodes of the tree of polygons that nobody had looked at before
  std::size_t parts = 0;    ///< parts of the track that were remembered at once, at the most
};

/// The furthest point of a body from its rear axle [m].
[[nodiscard]] double reach_of(const Outline& body);

/// No point of a body is further than this from where it would be on a passage of constant
/// curvature [m].
[[nodiscard]] double deviation(const Passage& passage, const Outline& body);

/// Between the closed body and a bar as it is seen from the vehicle in the middle [m], if the
/// curvature is constant. At one position it is the distance if the radius is 0, else a lower bound
/// that is below 0 at times; on a passage it is no more than that at any of its positions. It need
/// not be exact from `most` on.
[[nodiscard]] double clearance_of_bar(const Passage& passage, const Outline& body, const Bar& bar,
                                      double most);

/// The clearance of a closed polygon as it is seen from there, 0 if one holds the other, and never
/// more than `most`.
[[nodiscard]] double clearance_of_seen(const Passage& passage, const Outline& body,
                                       std::span<const Point> polygon, double most);

/// A lower bound of the clearance, below 0 at times, of all that lies in a disc seen from there.
[[nodiscard]] double clearance_of_disc(const Passage& passage, const Outline& body,
                                       const Point& centre, double radius);

/// How much nearer a point, seen from the vehicle in the middle, may come along a direction, if the
/// curvature is constant.
[[nodiscard]] double approach(const Passage& passage, const Point& p, const Point& direction);

}  // namespace vandplan::judge
