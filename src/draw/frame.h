// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where is everything on the page, and how are axes, scale bar and legend drawn?

#include <optional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/scene.h"

namespace vandplan::drawing {

/// Layout of a page with one picture.
struct Layout {
  Size page;
  View view;
  Box legend;
  std::optional<Box> strip;  ///< Strip of curvature, without its axes.
  bool is_cropped = false;   ///< Whether the scene is larger than the view.
};

[[nodiscard]] Layout layout_of(const Scene& scene, bool has_caption);

/// Step between lines [m]: 1, 2 or 5 times a power of ten, about `wanted` page units apart.
[[nodiscard]] double tick_step(double scale, double wanted);

/// Style of texts and numbers along axes.
inline constexpr TextStyle tick_style{.size = 10.5, .colour = colour::faint_ink};

[[nodiscard]] TextStyle aligned(TextStyle style, Align align);

/// Number with as many decimals as the step has, and a typographic minus.
[[nodiscard]] std::string number(double value, double step);

/// Multiples of the step from `low` to `high`.
[[nodiscard]] std::vector<double> ticks(double low, double high, double step);

/// Adds a line to Cairo's current path.
void add_line(cairo_t* cairo, const Point& from, const Point& to);

/// Draws a frame around a plot.
void paint_frame(cairo_t* cairo, const Box& plot);

/// Writes the title of a vertical axis upwards, centred at a point.
void write_upwards(cairo_t* cairo, const std::string& title, const Point& centre);

/// Draws faint grid lines across the plot.
void paint_grid(cairo_t* cairo, const View& view);

/// Draws ticks with numbers to the left and below, and a frame.
void paint_axes(cairo_t* cairo, const View& view);

/// Writes the titles of the axes, with the origin if it is not zero, and draws a scale bar.
void paint_axis_titles(cairo_t* cairo, const Scene& scene, const View& view);

/// Writes below the plot that the scene is larger than the view.
void paint_cropped(cairo_t* cairo, const View& view);

/// Draws a frame with a scale bar in its corner, for small plots without axes. Adds a word if the
/// scene is larger than the view.
void paint_small_frame(cairo_t* cairo, const View& view, bool is_cropped);

/// Entries of the legend beside start and goal.
struct LegendContent {
  bool path = false;
  bool driven = false;
  bool tree = false;
  bool obstacles = false;
  bool margin = false;
  bool kerbs = false;
  bool hit = false;      ///< Objects hit by start or goal.
  bool unknown = false;  ///< Unknown cells of a map.
  bool outside = false;  ///< Ground out of bounds.

  /// Adds the entries of one more picture.
  void add(const Scene& scene, const View& view) noexcept;
};

/// Draws a row of samples and words, centred in `place`.
void paint_legend(cairo_t* cairo, const LegendContent& content, const Box& place);

}  // namespace vandplan::drawing
