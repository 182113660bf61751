// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is more than a still picture laid over an SVG?

#include <array>
#include <cstdio>
#include <string>

#include "draw/scene.h"
#include "vandplan/draw.h"

namespace vandplan::drawing {

/// Picture that something is laid over.
struct Overlay {
  const Drawing& drawing;
  const Scene& scene;
  const View& view;
  double scale = 1.0;  ///< Scale of the picture [points per page unit].

  /// Points per metre.
  [[nodiscard]] double metre() const noexcept { return scale * view.scale; }
};

/// Text by a format of `printf`, at most 239 bytes.
std::string written(const char* format, auto... values) {
  std::array<char, 240> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, values...);
  return buffer.data();
}

/// The colour as SVG's attributes name it.
[[nodiscard]] std::string svg_colour(const Colour& colour);

/// Corners as the value of SVG's attribute `points` [m].
[[nodiscard]] std::string svg_points(const Polygon& corners);

/// Elements of SVG over a plot.
struct Layer {
  std::string name;         ///< Identifier of the clip path; one for each layer.
  std::string metres = {};  ///< Elements in metres of the scene's frame, y upwards.
  std::string points = {};  ///< Elements in points of the picture.
};

/// The SVG with a layer over its plot, cut off at the edge of the plot.
[[nodiscard]] std::string laid_over(const std::string& svg, const Overlay& overlay,
                                    const Layer& layer);

}  // namespace vandplan::drawing
