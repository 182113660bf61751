// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a polygon on the ground become a thing with a height?

#include "recording/messages.h"
#include "vandplan/geometry.h"

namespace vandplan::recording {

/// A prism above a simple polygon, as high as `height` [m], without a bottom.
[[nodiscard]] Triangles prism_of(const Polygon& polygon, double height, const Colour& colour);

/// The sides of a polygon as a line just above the ground.
[[nodiscard]] Line outline_of(const Polygon& polygon, const Colour& colour);

}  // namespace vandplan::recording
