// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is the world painted: obstacles, tree, swept area, path, vehicles?

#include "draw/canvas.h"
#include "draw/scene.h"

namespace vandplan::drawing {

/// Fills the plot of `view` with the scene, from the ground upwards.
void paint_scene(cairo_t* cairo, const Scene& scene, const View& view);

/// The cells of a map that are occupied or unknown.
void paint_map(cairo_t* cairo, const OccupancyGrid& grid, const View& view);

/// A vehicle at rest.
struct ParkedVehicle {
  Polygon body;  ///< in its own frame
  Pose pose;
  Colour colour;
};

/// The outline, the rear-axle midpoint as a dot, and an arrow where the vehicle points.
void paint_vehicle(cairo_t* cairo, const ParkedVehicle& vehicle, const View& view);

[[nodiscard]] const Colour& colour_of_gear(int direction);

/// A gear change.
void paint_gear_change(cairo_t* cairo, const Point& place);

}  // namespace vandplan::drawing
