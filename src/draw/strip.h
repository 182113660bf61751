// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is the curvature along the path drawn?

#include "draw/canvas.h"
#include "draw/scene.h"

namespace vandplan::drawing {

/// Draws curvature over the distance driven, with axes around `place`, in the colours of the gears.
/// It shows slightly more than the range +- 1 / min_turning_radius. Jumps are steps; ticks mark
/// gear changes. The scene must have a path.
void paint_curvature_strip(cairo_t* cairo, const Scene& scene, const Box& place);

}  // namespace vandplan::drawing
