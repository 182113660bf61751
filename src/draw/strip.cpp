// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "draw/strip.h"

#include <algorithm>
#include <cmath>

#include "draw/frame.h"
#include "draw/paint.h"
#include "vandplan/path.h"

namespace vandplan::drawing {
namespace {

constexpr double reach = 1.25;  // Largest curvature shown [1 / min_turning_radius].

/// Position on the page of a curvature at a distance driven.
class Axes {
 public:
  Axes(const Scene& scene, const Box& place)
      : place_(place),
        length_(std::max(length(scene.path->segments), 1e-3)),
        radius_(scene.vehicle.min_turning_radius) {}

  [[nodiscard]] double length_driven() const { return length_; }
  [[nodiscard]] double scale() const { return place_.width / length_; }
  [[nodiscard]] double x_of(double s) const { return place_.x + s * scale(); }
  [[nodiscard]] double tightest() const { return 1 / radius_; }
  [[nodiscard]] double y_of(double curvature) const {
    const double part = std::clamp(curvature * radius_ / reach, -2.0, 2.0);  // Limited for Cairo.
    return place_.y + place_.height * (1 - part) / 2;
  }

 private:
  Box place_;
  double length_;
  double radius_;
};

void paint_limits(cairo_t* cairo, const Axes& axes, const Box& place) {
  const TextStyle style = aligned(tick_style, Align::right);
  const double dashes[] = {5.0, 4.0};
  const auto line_at = [&](double curvature, const char* word, const Colour& colour) {
    const double y = axes.y_of(curvature);
    add_line(cairo, {place.x, y}, {place.x + place.width, y});
    set_colour(cairo, colour, 0.6);
    cairo_set_line_width(cairo, 1.0);
    cairo_stroke(cairo);
    write_text(cairo, word, place.x - 7, y + 4, style);
  };
  line_at(0.0, "0", colour::unknown);
  cairo_set_dash(cairo, dashes, 2, 0.0);
  line_at(axes.tightest(), "1/R", colour::ink);
  line_at(-axes.tightest(), "\u22121/R", colour::ink);
  cairo_set_dash(cairo, nullptr, 0, 0.0);
}

void paint_gear_change_ticks(cairo_t* cairo, double x, const Box& place) {
  constexpr double tick = 7.0;
  add_line(cairo, {x, place.y}, {x, place.y + tick});
  add_line(cairo, {x, place.y + place.height}, {x, place.y + place.height - tick});
  set_colour(cairo, colour::ink, 1.0);
  cairo_set_line_width(cairo, 1.4);
  cairo_stroke(cairo);
}

void paint_curve(cairo_t* cairo, int direction) {
  set_colour(cairo, colour_of_gear(direction), 1.0);
  cairo_set_line_width(cairo, 2.0);
  cairo_stroke(cairo);
}

void paint_curvature(cairo_t* cairo, const Scene& scene, const Axes& axes, const Box& place) {
  double s = 0.0;
  int gear = 0;  // Gear of the line being drawn; 0: none.
  for (const Segment& segment : scene.path->segments) {
    if (segment.length == 0.0) continue;
    const int direction = segment.length > 0.0 ? 1 : -1;
    const Point begin{axes.x_of(s), axes.y_of(segment.curvature)};
    const double driven = std::abs(segment.length);
    if (direction != gear) {
      if (gear != 0) {
        paint_curve(cairo, gear);
        paint_gear_change_ticks(cairo, begin.x, place);
      }
      cairo_new_path(cairo);
      cairo_move_to(cairo, begin.x, begin.y);
      gear = direction;
    }
    cairo_line_to(cairo, begin.x, begin.y);
    s += driven;
    cairo_line_to(cairo, axes.x_of(s), axes.y_of(curvature_at(segment, driven)));
  }
  if (gear != 0) paint_curve(cairo, gear);
}

void paint_metres(cairo_t* cairo, const Axes& axes, const Box& place) {
  const TextStyle style = aligned(tick_style, Align::centre);
  const double bottom = place.y + place.height;
  const double step = tick_step(axes.scale(), 85.0);
  for (const double s : ticks(0.0, axes.length_driven(), step)) {
    add_line(cairo, {axes.x_of(s), bottom}, {axes.x_of(s), bottom + 4});
    write_text(cairo, number(s, step), axes.x_of(s), bottom + 16, style);
  }
  write_text(cairo, "driven [m]", place.x + place.width / 2, bottom + 33, style);
  write_upwards(cairo, "curvature", {place.x - 42, place.y + place.height / 2});
}

}  // namespace

void paint_curvature_strip(cairo_t* cairo, const Scene& scene, const Box& place) {
  const Axes axes(scene, place);
  paint_limits(cairo, axes, place);
  cairo_save(cairo);
  cairo_rectangle(cairo, place.x, place.y, place.width, place.height);
  cairo_clip(cairo);
  paint_curvature(cairo, scene, axes, place);
  cairo_restore(cairo);
  paint_metres(cairo, axes, place);
  paint_frame(cairo, place);
}

}  // namespace vandplan::drawing
