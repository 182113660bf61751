// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "draw/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "vandplan/input_error.h"

namespace vandplan::drawing {
namespace {

using SurfacePtr = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using CairoPtr = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

void require(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  if (status == CAIRO_STATUS_INVALID_STRING) throw InputError("caption", "must be UTF-8");
  throw std::runtime_error(std::string("cannot draw: ") + cairo_status_to_string(status));
}

cairo_surface_t* new_surface(PictureFormat format, const Size& size, std::string& bytes) {
  switch (format) {
    case PictureFormat::svg:
      return cairo_svg_surface_create_for_stream(append, &bytes, size.width, size.height);
    case PictureFormat::pdf:
      return cairo_pdf_surface_create_for_stream(append, &bytes, size.width, size.height);
    case PictureFormat::png:
      break;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.width),
                                    static_cast<int>(size.height));
}

void select_font(cairo_t* cairo, const TextStyle& style) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, style.size);
}

}  // namespace

void set_colour(cairo_t* cairo, const Colour& colour, double alpha) {
  cairo_set_source_rgba(cairo, colour.red, colour.green, colour.blue, alpha);
}

std::string render(PictureFormat format, int width, const Size& page,
                   const std::function<void(cairo_t*)>& paint) {
  const double scale = width / page.width;
  const Size size{static_cast<double>(width), std::round(scale * page.height)};
  std::string bytes;
  const SurfacePtr surface(new_surface(format, size, bytes), cairo_surface_destroy);
  require(cairo_surface_status(surface.get()));
  const CairoPtr cairo(cairo_create(surface.get()), cairo_destroy);
  set_colour(cairo.get(), colour::paper, 1.0);
  cairo_paint(cairo.get());
  cairo_scale(cairo.get(), scale, scale);
  paint(cairo.get());
  require(cairo_status(cairo.get()));
  if (format == PictureFormat::png) return png_of(surface.get());
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()));
  return bytes;
}

std::string png_of(cairo_surface_t* image) {
  std::string bytes;
  require(cairo_surface_status(image));
  require(cairo_surface_write_to_png_stream(image, append, &bytes));
  return bytes;
}

void write_text(cairo_t* cairo, const std::string& text, double x, double y,
                const TextStyle& style) {
  const double shift = style.align == Align::left ? 0.0 : style.align == Align::right ? 1.0 : 0.5;
  const double width = shift == 0.0 ? 0.0 : text_width(cairo, text, style);
  select_font(cairo, style);
  set_colour(cairo, style.colour, 1.0);
  cairo_move_to(cairo, x - shift * width, y);
  cairo_show_text(cairo, text.c_str());
  cairo_new_path(cairo);
}

double text_width(cairo_t* cairo, const std::string& text, const TextStyle& style) {
  select_font(cairo, style);
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  return extents.x_advance;
}

}  // namespace vandplan::drawing
