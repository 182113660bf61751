// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "draw/frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "draw/paint.h"

namespace vandplan::drawing {
namespace {

constexpr TextStyle legend_style{.size = 11.0, .colour = colour::ink};

// Whole number with digits grouped in threes, as in SI: "4 517 230 000".
std::string grouped(double value) {
  std::string digits = number(std::abs(value), 1.0);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, " ");
  return digits;
}

double axis_step(const View& view) { return tick_step(view.scale, 85.0); }

// Draws a bar that ends at `right_end`, with its length in metres before it.
void paint_scale_bar(cairo_t* cairo, double metres, double scale, const Point& right_end) {
  const auto [right, y] = right_end;
  const double left = right - metres * scale;
  add_line(cairo, {left, y}, {right, y});
  add_line(cairo, {left, y - 4}, {left, y + 4});
  add_line(cairo, {right, y - 4}, {right, y + 4});
  set_colour(cairo, colour::ink, 1.0);
  cairo_set_line_width(cairo, 1.6);
  cairo_stroke(cairo);
  write_text(cairo, number(metres, metres) + " m", left - 7, y + 4,
             {.size = 10.5, .align = Align::right});
}

// Writes a word on a patch of paper. `corner`: its lower left corner.
void paint_label(cairo_t* cairo, const std::string& word, const Point& corner) {
  constexpr double height = 16.0;
  cairo_rectangle(cairo, corner.x, corner.y - height, text_width(cairo, word, tick_style) + 12,
                  height);
  set_colour(cairo, colour::paper, 0.85);
  cairo_fill(cairo);
  write_text(cairo, word, corner.x + 6, corner.y - 4, tick_style);
}

// Entry of the legend: a sample of what is drawn, and a word.
struct Entry {
  enum class Sample { vehicle, line, marker, area };
  const char* word;
  Sample sample;
  Colour colour;
};

constexpr double sample_width = 24.0;
constexpr double sample_gap = 6.0;

std::vector<Entry> entries_of(const LegendContent& content) {
  using enum Entry::Sample;
  std::vector<Entry> entries = {{"start", vehicle, colour::start}, {"goal", vehicle, colour::goal}};
  if (content.path) {
    entries.push_back({"forward", line, colour::forward});
    entries.push_back({"reverse", line, colour::reverse});
    entries.push_back({"gear change", marker, colour::ink});
  }
  if (content.driven) entries.push_back({"driven", line, colour::driven});
  if (content.tree) entries.push_back({"tree", line, colour::tree});
  if (content.obstacles) entries.push_back({"obstacle", area, colour::obstacle});
  if (content.margin) entries.push_back({"margin", area, colour::margin});
  if (content.kerbs) entries.push_back({"kerb", area, colour::kerb});
  if (content.hit) entries.push_back({"in the way", area, colour::hit});
  if (content.unknown) entries.push_back({"unknown", area, colour::unknown});
  if (content.outside) entries.push_back({"out of bounds", area, colour::outside});
  return entries;
}

double entry_width(cairo_t* cairo, const Entry& entry) {
  return sample_width + sample_gap + text_width(cairo, entry.word, legend_style);
}

void paint_sample(cairo_t* cairo, const Entry& entry, const Point& at) {
  switch (entry.sample) {
    case Entry::Sample::vehicle: {
      const View view{.visible = {}, .plot = {at.x + 6, at.y, 0, 0}, .scale = 1.0};
      const Polygon small{{-4.0, -4.4}, {16.0, -4.4}, {16.0, 4.4}, {-4.0, 4.4}};
      paint_vehicle(cairo, {small, {}, entry.colour}, view);
      break;
    }
    case Entry::Sample::line:
      add_line(cairo, at, {at.x + sample_width, at.y});
      set_colour(cairo, entry.colour, 1.0);
      cairo_set_line_width(cairo, 2.0);
      cairo_stroke(cairo);
      break;
    case Entry::Sample::marker:
      paint_gear_change(cairo, {at.x + sample_width / 2, at.y});
      break;
    case Entry::Sample::area:
      cairo_rectangle(cairo, at.x + 4, at.y - 5, sample_width - 8, 10);
      set_colour(cairo, entry.colour, 1.0);
      cairo_fill(cairo);
      break;
  }
}

bool shows(const std::optional<OccupancyGrid>& map, Cell kind) {
  return map && std::find(map->cells->begin(), map->cells->end(), kind) != map->cells->end();
}

std::string axis_title(const char* axis, double origin) {
  std::string title = axis;
  if (origin != 0.0) title += (origin > 0.0 ? " \u2212 " : " + ") + grouped(origin) + " ";
  return title + " [m]";
}

}  // namespace

Layout layout_of(const Scene& scene, bool has_caption) {
  constexpr double page_width = 900.0;
  constexpr double left = 58.0;
  constexpr double plot_width = page_width - left - 18.0;
  constexpr double titled = 42.0;  // Space below a plot for ticks and title.
  constexpr double legend_height = 34.0;
  constexpr double gap = 14.0;  // Space above the strip.
  constexpr double strip_height = 84.0;
  const double top = has_caption ? 38.0 : 14.0;
  const auto [seen, is_cropped] = framed(scene);
  const double shape = (seen.y_max - seen.y_min) / (seen.x_max - seen.x_min);
  const Box plot{left, top, plot_width, std::round(plot_width * std::clamp(shape, 0.3, 0.9))};
  std::optional<Box> strip;
  double below = plot.y + plot.height + titled;
  if (scene.curvature_strip) {
    strip = Box{left, below + gap, plot_width, strip_height};
    below += gap + strip_height + titled;
  }
  const Size page{page_width, below + legend_height};
  const Box legend{left, below, plot_width, 24.0};
  return {page, view_of(seen, plot), legend, strip, is_cropped};
}

TextStyle aligned(TextStyle style, Align align) {
  style.align = align;
  return style;
}

std::string number(double value, double step) {
  const int decimals = step < 1.0 ? static_cast<int>(std::ceil(-std::log10(step) - 1e-9)) : 0;
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*f", decimals, std::abs(value));
  return value < 0.0 ? "\u2212" + std::string(text.data()) : text.data();
}

std::vector<double> ticks(double low, double high, double step) {
  std::vector<double> values;
  for (double i = std::ceil(low / step); i * step <= high; ++i) values.push_back(i * step);
  return values;
}

void add_line(cairo_t* cairo, const Point& from, const Point& to) {
  cairo_move_to(cairo, from.x, from.y);
  cairo_line_to(cairo, to.x, to.y);
}

void paint_frame(cairo_t* cairo, const Box& plot) {
  cairo_rectangle(cairo, plot.x, plot.y, plot.width, plot.height);
  set_colour(cairo, colour::faint_ink, 1.0);
  cairo_set_line_width(cairo, 0.9);
  cairo_stroke(cairo);
}

void write_upwards(cairo_t* cairo, const std::string& title, const Point& centre) {
  cairo_save(cairo);
  cairo_translate(cairo, centre.x, centre.y);
  cairo_rotate(cairo, -1.5707963267948966);
  write_text(cairo, title, 0.0, 0.0, aligned(tick_style, Align::centre));
  cairo_restore(cairo);
}

double tick_step(double scale, double wanted) {
  const double metres = wanted / scale;
  const double power = std::pow(10.0, std::floor(std::log10(metres)));
  const double digit = metres / power;
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

void paint_grid(cairo_t* cairo, const View& view) {
  const Bounds& seen = view.visible;
  const double step = axis_step(view);
  for (const double x : ticks(seen.x_min, seen.x_max, step)) {
    add_line(cairo, view.on_page({x, seen.y_min}), view.on_page({x, seen.y_max}));
  }
  for (const double y : ticks(seen.y_min, seen.y_max, step)) {
    add_line(cairo, view.on_page({seen.x_min, y}), view.on_page({seen.x_max, y}));
  }
  set_colour(cairo, colour::ink, 0.07);
  cairo_set_line_width(cairo, 0.7);
  cairo_stroke(cairo);
}

void paint_axes(cairo_t* cairo, const View& view) {
  const Bounds& seen = view.visible;
  const Box& plot = view.plot;
  const double step = axis_step(view);
  for (const double x : ticks(seen.x_min, seen.x_max, step)) {
    const Point at = view.on_page({x, seen.y_min});
    add_line(cairo, at, {at.x, at.y + 4});
    write_text(cairo, number(x, step), at.x, at.y + 16, aligned(tick_style, Align::centre));
  }
  for (const double y : ticks(seen.y_min, seen.y_max, step)) {
    const Point at = view.on_page({seen.x_min, y});
    add_line(cairo, {at.x - 4, at.y}, at);
    write_text(cairo, number(y, step), at.x - 7, at.y + 4, aligned(tick_style, Align::right));
  }
  paint_frame(cairo, plot);
}

void paint_axis_titles(cairo_t* cairo, const Scene& scene, const View& view) {
  const Box& plot = view.plot;
  const TextStyle style = aligned(tick_style, Align::centre);
  write_text(cairo, axis_title("x", scene.origin.x), plot.x + plot.width / 2,
             plot.y + plot.height + 33, style);
  write_upwards(cairo, axis_title("y", scene.origin.y), {plot.x - 42, plot.y + plot.height / 2});
  paint_scale_bar(cairo, tick_step(view.scale, 90.0), view.scale,
                  {plot.x + plot.width, plot.y + plot.height + 29});
}

void paint_cropped(cairo_t* cairo, const View& view) {
  const Box& plot = view.plot;
  write_text(cairo, "cropped: the scene goes on", plot.x, plot.y + plot.height + 33, tick_style);
}

void paint_small_frame(cairo_t* cairo, const View& view, bool is_cropped) {
  const Box& plot = view.plot;
  if (is_cropped) paint_label(cairo, "cropped", {plot.x, plot.y + plot.height});
  const double metres = tick_step(view.scale, 50.0);
  const double width =
      metres * view.scale + text_width(cairo, number(metres, metres) + " m", {.size = 10.5}) + 19;
  cairo_rectangle(cairo, plot.x + plot.width - width, plot.y + plot.height - 16, width, 16);
  set_colour(cairo, colour::paper, 0.85);
  cairo_fill(cairo);
  paint_scale_bar(cairo, metres, view.scale, {plot.x + plot.width - 6, plot.y + plot.height - 8});
  paint_frame(cairo, plot);
}

void LegendContent::add(const Scene& scene, const View& view) noexcept {
  const Bounds& seen = view.visible;
  path |= scene.path.has_value();
  driven |= !scene.driven.empty();
  tree |= !scene.tree.poses.empty();
  obstacles |= !scene.obstacles.empty() || shows(scene.map, Cell::occupied);
  margin |= scene.path && scene.margin > 0.0;
  kerbs |= !scene.kerbs.empty();
  hit |= !scene.hit.empty();
  unknown |= shows(scene.map, Cell::unknown);
  outside |= !contains(scene.bounds, {seen.x_min, seen.y_min}) ||
             !contains(scene.bounds, {seen.x_max, seen.y_max});
}

void paint_legend(cairo_t* cairo, const LegendContent& content, const Box& place) {
  constexpr double space = 22.0;  // Space between entries.
  const std::vector<Entry> entries = entries_of(content);
  double total = -space;
  for (const Entry& entry : entries) total += entry_width(cairo, entry) + space;
  double x = place.x + (place.width - total) / 2;
  const double y = place.y + place.height / 2;
  for (const Entry& entry : entries) {
    paint_sample(cairo, entry, {x, y});
    write_text(cairo, entry.word, x + sample_width + sample_gap, y + 4, legend_style);
    x += entry_width(cairo, entry) + space;
  }
}

}  // namespace vandplan::drawing
