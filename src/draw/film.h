// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a picture play?

#include <string>

#include "draw/scene.h"
#include "vandplan/draw.h"
#include "vandplan/speed.h"

namespace vandplan::drawing {

/// What plays over a picture.
struct Film {
  const Drawing& drawing;  ///< with a path and its times
  const Scene& scene;
  const View& view;
  double scale = 1.0;  ///< points per page unit
};

/// The SVG with the vehicle and all that moves over it, again and again; at the foot of the plot a
/// bar grows with the time. Browsers play it without a script.
[[nodiscard]] std::string played(const std::string& svg, const Film& film);

}  // namespace vandplan::drawing
