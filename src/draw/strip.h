// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the wheels turned along the path?

#include "draw/canvas.h"
#include "draw/scene.h"

namespace vandplan::drawing {

/// Curvature over the way driven, from -1 / min_turning_radius to its opposite and a little
/// further, in the colours of the gears; a step where it jumps, ticks where the gear changes. With
/// axes around `place`. The scene has a path.
void paint_curvature_strip(cairo_t* cairo, const Scene& scene, const Box& place);

}  // namespace vandplan::drawing
