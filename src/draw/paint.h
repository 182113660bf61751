// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is the world painted: obstacles, tree, swept area, path, vehicles?

#include "draw/canvas.h"
#include "draw/scene.h"

namespace vandplan::drawing {

/// Fills the plot of `view` with the scene, from the ground upwards.
void paint_scene(cairo_t* cairo, const Scene& scene, const View& view);

/// Paints the occupied and unknown cells of a map.
void paint_map(cairo_t* cairo, const OccupancyGrid& grid, const View& view);

/// Vehicle at rest.
struct ParkedVehicle {
  Polygon body;  ///< Outline of the body in the vehicle's frame.
  Pose pose;
  Colour colour;
};

/// Paints the outline, a dot at the rear-axle midpoint, and an arrow in the vehicle's direction.
void paint_vehicle(cairo_t* cairo, const ParkedVehicle& vehicle, const View& view);

[[nodiscard]] const Colour& colour_of_gear(int direction);

/// Paints the mark of a gear change.
void paint_gear_change(cairo_t* cairo, const Point& place);

}  // namespace vandplan::drawing
