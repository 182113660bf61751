// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which rigid bodies does a vehicle have?

#include <algorithm>
#include <cmath>
#include <utility>

#include "collision/disc_trace.h"
#include "collision/sweep.h"
#include "vandplan/vehicle.h"

namespace vandplan::collision {

/// Largest distance of a point of a footprint from its rear axle [m].
inline double reach_of(const Footprint& body) {
  const double x = std::max(body.rear, body.front);
  return std::sqrt(x * x + body.half_width * body.half_width);
}

/// Shape of a vehicle or a trailer.
Shape shape_of(const auto& part) {
  return {footprint(part), part.outline.empty() ? Polygon{} : body_outline(part)};
}

/// Rigid body of a vehicle or trailer, around the midpoint of its axle.
struct Body {
  Body(Shape of_body, const Footprint& of_wheels, double margin)
      : shape(std::move(of_body)),
        wheels{of_wheels},
        discs(shape, margin),
        slim(DiscRows(shape).slim) {}

  Shape shape;
  Shape wheels;
  DiscRows discs;  // Discs that cover the shape with the wanted margin.
  DiscRow slim;    // Discs that cover the shape without a margin.
};

/// Trailer of a vehicle.
struct Towed {
  Towed(const Vehicle& of, double margin)
      : vehicle(of),
        body(shape_of(*of.trailer),
             {.rear = 0.0, .front = 0.0, .half_width = of.trailer->width / 2}, margin),
        reach(std::max(reach_of(body.shape.box), reach_of(body.wheels.box))) {
    const auto [rear, front, half_width] = footprint(of);
    const Footprint& own = body.shape.box;
    holds_hitch = of.outline.empty() && of.trailer->outline.empty() &&
                  -rear <= std::min(of.hitch, 0.0) && of.hitch <= front && own.rear >= 0.0 &&
                  of.trailer->wheelbase <= own.front;
  }

  Vehicle vehicle;
  Body body;
  double reach;      // Largest distance of its points from the axle [m].
  bool holds_hitch;  // Whether both bodies contain their axle and the hitch.
};

}  // namespace vandplan::collision
