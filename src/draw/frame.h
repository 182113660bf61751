// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What stands where on the page, and what around the picture: axes, scale bar, legend?

#include <optional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "draw/scene.h"

namespace vandplan::drawing {

/// Where everything stands on a page with one picture.
struct Layout {
  Size page;
  View view;
  Box legend;
  std::optional<Box> strip;  ///< of curvature, without its axes
  bool is_cropped = false;   ///< there is more than the view shows
};

[[nodiscard]] Layout layout_of(const Scene& scene, bool has_caption);

/// Lines every 1, 2 or 5 times a power of ten metres, about `wanted` page units apart [m].
[[nodiscard]] double tick_step(double scale, double wanted);

/// Words and numbers along axes.
inline constexpr TextStyle tick_style{.size = 10.5, .colour = colour::faint_ink};

[[nodiscard]] TextStyle aligned(TextStyle style, Align align);

/// As many decimals as the step has, and a true minus.
[[nodiscard]] std::string number(double value, double step);

/// The multiples of the step from `low` to `high`.
[[nodiscard]] std::vector<double> ticks(double low, double high, double step);

/// Adds a line to those that are to be drawn.
void add_line(cairo_t* cairo, const Point& from, const Point& to);

/// Lines around a plot.
void paint_frame(cairo_t* cairo, const Box& plot);

/// What an axis counts that goes upwards, centred at a point.
void write_upwards(cairo_t* cairo, const std::string& title, const Point& centre);

/// Faint lines across the plot.
void paint_grid(cairo_t* cairo, const View& view);

/// Ticks with numbers left and below, and a frame.
void paint_axes(cairo_t* cairo, const View& view);

/// What the axes count, with the origin when it is not zero, and a scale bar.
void paint_axis_titles(cairo_t* cairo, const Scene& scene, const View& view);

/// Says below the plot that the scene goes on beyond it.
void paint_cropped(cairo_t* cairo, const View& view);

/// Instead of axes, where there is little room: a frame, a scale bar in its corner, and a word when
/// the scene goes on beyond it.
void paint_small_frame(cairo_t* cairo, const View& view, bool is_cropped);

/// What the legend explains beside start and goal.
struct LegendContent {
  bool path = false;
  bool driven = false;
  bool tree = false;
  bool obstacles = false;
  bool margin = false;
  bool kerbs = false;
  bool hit = false;      ///< by start or goal
  bool unknown = false;  ///< cells of a map
  bool outside = false;  ///< ground out of bounds

  /// Adds what is seen in one more picture.
  void add(const Scene& scene, const View& view) noexcept;
};

/// One row of samples and words, centred in `place`.
void paint_legend(cairo_t* cairo, const LegendContent& content, const Box& place);

}  // namespace vandplan::drawing
