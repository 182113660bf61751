// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a picture animated?

#include <string>

#include "draw/scene.h"
#include "vandplan/draw.h"
#include "vandplan/speed.h"

namespace vandplan::drawing {

/// Animation over a picture.
struct Film {
  const Drawing& drawing;  ///< Drawing with a path and its times.
  const Scene& scene;
  const View& view;
  double scale = 1.0;  ///< Scale of the picture [points per page unit].
};

/// The SVG with an endless animation of the vehicle and the moving obstacles. A bar at the foot of
/// the plot grows with time. Browsers play it without a script.
[[nodiscard]] std::string played(const std::string& svg, const Film& film);

}  // namespace vandplan::drawing
