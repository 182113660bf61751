// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "draw/overlay.h"

#include <cmath>

namespace vandplan::drawing {

std::string svg_colour(const Colour& colour) {
  const auto byte = [](double share) { return static_cast<int>(std::lround(255 * share)); };
  return written("rgb(%d,%d,%d)", byte(colour.red), byte(colour.green), byte(colour.blue));
}

std::string svg_points(const Polygon& corners) {
  std::string text;
  for (const auto& [x, y] : corners) text += written("%.3f,%.3f ", x, y);
  return text;
}

std::string laid_over(const std::string& svg, const Overlay& overlay, const Layer& layer) {
  const Box& plot = overlay.view.plot;
  const double k = overlay.scale;
  const double metre = overlay.metre();
  const std::string clip =
      "<clipPath id=\"" + layer.name +
      written("\"><rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\"/></clipPath>\n",
              k * plot.x, k * plot.y, k * plot.width, k * plot.height);
  const std::string frame = written("<g transform=\"matrix(%.6f 0 0 %.6f %.4f %.4f)\">\n", metre,
                                    -metre, k * plot.x - metre * overlay.view.visible.x_min,
                                    k * plot.y + metre * overlay.view.visible.y_max);
  const std::size_t end = svg.rfind("</svg>");
  return svg.substr(0, end) + clip + "<g clip-path=\"url(#" + layer.name + ")\">" + frame +
         layer.metres + "</g>" + layer.points + "</g>\n" + svg.substr(end);
}

}  // namespace vandplan::drawing
